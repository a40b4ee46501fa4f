// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPVRelievoTerrainReader
 * @brief Reads a terrain from a GeoTIFF: vtkRelievoGeoTIFFReader and vtkRelievoTerrain in one.
 *
 * ParaView shows images by their origin and spacing. A raster may be turned, sheared and have cells
 * without data, so the mesh, not the image, is the output. Errors are those of the two classes.
 */
#ifndef vtkPVRelievoTerrainReader_h
#define vtkPVRelievoTerrainReader_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoPluginServerModule.h" // for the export macro

class VTKRELIEVOPLUGINSERVER_EXPORT vtkPVRelievoTerrainReader : public vtkPolyDataAlgorithm
{
public:
  static vtkPVRelievoTerrainReader* New();
  vtkTypeMacro(vtkPVRelievoTerrainReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Name of the file to read. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** Whether this is a TIFF with a place in the world and without colours: 1 or 0. */
  static int CanReadFile(const char* name);

protected:
  vtkPVRelievoTerrainReader();
  ~vtkPVRelievoTerrainReader() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPVRelievoTerrainReader(const vtkPVRelievoTerrainReader&) = delete;
  void operator=(const vtkPVRelievoTerrainReader&) = delete;

  char* FileName = nullptr;
};

#endif
