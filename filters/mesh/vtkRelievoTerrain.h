// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoTerrain
 * @brief The triangles of a terrain whose heights are a raster, in double.
 *
 * Input: a vtkImageData of one slice, row 0 at the bottom, whose scalars are the heights, with the
 * field data raster_transform and, optionally, raster_nodata (vtkRelievoRaster.h), as
 * vtkRelievoGeoTIFFReader makes it. The image's origin and spacing do not count.
 *
 * Output: a point at the centre of each cell of the raster, at its height along z, and two
 * triangles between each four of them, cut along the diagonal from the cell with the lower row and
 * column to that with the higher ones. Normals point up. Of four cells of which one has no data,
 * the other three make a triangle. Point array: raster_cell; field data: those of the input, and
 * raster_size.
 *
 * Cells have no data if their value is not finite, is raster_nodata, or is beyond 1e30, which
 * stands for missing heights in rasters of floats.
 *
 * Errors: no transform or one that cannot be inverted; less than two rows or columns; no triangle;
 * not enough memory.
 */
#ifndef vtkRelievoTerrain_h
#define vtkRelievoTerrain_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoFiltersModule.h" // for the export macro

class VTKRELIEVOFILTERS_EXPORT vtkRelievoTerrain : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoTerrain* New();
  vtkTypeMacro(vtkRelievoTerrain, vtkPolyDataAlgorithm);

protected:
  vtkRelievoTerrain() = default;
  ~vtkRelievoTerrain() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoTerrain(const vtkRelievoTerrain&) = delete;
  void operator=(const vtkRelievoTerrain&) = delete;
};

#endif
