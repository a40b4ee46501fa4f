// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoGeoTIFFReader
 * @brief Reads a raster of the world, such as a terrain's heights, from a GeoTIFF.
 *
 * The first band becomes the scalars `height` (double) of an image of one slice, row 0 at the
 * bottom. Its place in the world is not the image's origin and spacing, but in the field data:
 * raster_transform, and, where the file has them, raster_nodata and the keys of the coordinate
 * system (vtkRelievoRaster.h). GDAL is not needed: the file is read by VTK's TIFF library, in
 * strips or tiles, uncompressed or as the library can decompress, also as BigTIFF. Cells of strips
 * or tiles that a sparse file lacks have the file's value of no data, or 0 if it has none.
 *
 * Errors: a file without a place in the world; geographic coordinates, whose degrees have no
 * lengths; a band with a scale or an offset; colours; more than 2^28 cells or 2 GiB; damaged files.
 */
#ifndef vtkRelievoGeoTIFFReader_h
#define vtkRelievoGeoTIFFReader_h

#include "vtkImageAlgorithm.h"
#include "vtkRelievoIOModule.h" // for the export macro
#include "vtkSmartPointer.h"    // for the image

class VTKRELIEVOIO_EXPORT vtkRelievoGeoTIFFReader : public vtkImageAlgorithm
{
public:
  static vtkRelievoGeoTIFFReader* New();
  vtkTypeMacro(vtkRelievoGeoTIFFReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Name of the file to read. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** Whether this is a TIFF with a place in the world and without colours: 1 or 0. */
  static int CanReadFile(const char* name);

protected:
  vtkRelievoGeoTIFFReader();
  ~vtkRelievoGeoTIFFReader() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRelievoGeoTIFFReader(const vtkRelievoGeoTIFFReader&) = delete;
  void operator=(const vtkRelievoGeoTIFFReader&) = delete;

  vtkImageData* GetImage();

  char* FileName = nullptr;
  vtkSmartPointer<vtkImageData> Image; // of the file
  vtkMTimeType ImageTime = 0;          // the reader's time at reading
};

#endif
