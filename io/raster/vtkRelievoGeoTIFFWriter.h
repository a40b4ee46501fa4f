// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoGeoTIFFWriter
 * @brief Writes values at the points of a terrain as a GeoTIFF on the grid of its raster.
 *
 * Input: a vtkPolyData of vtkRelievoTerrain, with point arrays of one component. Each of them but
 * raster_cell becomes a band with its name as description: Int32 if all arrays are of integers
 * of 32 bits; otherwise Float32, or Float64 if one is double or has integers beyond 2^24, which
 * Float32 cannot hold. The place in the world and the coordinate system are those of the terrain
 * (vtkRelievoRaster.h). Cells without a point have the value NoData. Bands are compressed without
 * loss (deflate).
 *
 * A file is replaced when the new one is complete.
 *
 * Errors: an input without a raster or arrays; a file that cannot be written.
 */
#ifndef vtkRelievoGeoTIFFWriter_h
#define vtkRelievoGeoTIFFWriter_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoIOModule.h" // for the export macro

class VTKRELIEVOIO_EXPORT vtkRelievoGeoTIFFWriter : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoGeoTIFFWriter* New();
  vtkTypeMacro(vtkRelievoGeoTIFFWriter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Name of the file to write. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** The value of cells without data, -9999. */
  static double GetNoData() { return -9999.0; }

  /** Writes the file. False, with an error, if it is not written. */
  bool Write();

protected:
  vtkRelievoGeoTIFFWriter();
  ~vtkRelievoGeoTIFFWriter() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoGeoTIFFWriter(const vtkRelievoGeoTIFFWriter&) = delete;
  void operator=(const vtkRelievoGeoTIFFWriter&) = delete;

  char* FileName = nullptr;
};

#endif
