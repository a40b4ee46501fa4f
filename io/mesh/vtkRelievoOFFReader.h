// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoOFFReader
 * @brief Reads surface meshes in the Object File Format (.off), as text.
 *
 * It reads the headers OFF, COFF, NOFF, STOFF and their combinations ([ST][C][N]OFF), comments from
 * `#` to the end of the line, and colours of faces. The output has
 * - points in double precision (OutputPointsPrecision changes that);
 * - polygons; faces of two points are lines, faces of one point vertices;
 * - point arrays `Normals` (float, 3), `RGBA` (unsigned char, 4), `TextureCoordinates` (float, 2)
 *   if the header announces them, as the active normals, scalars and texture coordinates;
 * - a cell array `RGBA` (unsigned char, 4) if any face has a colour of 3 or 4 numbers; faces
 *   without one, or with a colour-map index, are opaque grey (170).
 *
 * Colours are 0 to 255 if any value of any colour is above 1, otherwise 0 to 1. Four-dimensional
 * (4OFF, nOFF) and binary files are refused, as are numbers that are not finite and indices out of
 * range.
 *
 * Errors: one error event names the file, the line and what was expected; GetErrorCode() is set and
 * the output is empty. Memory stays within a small multiple of the file's size, whatever counts the
 * file claims.
 *
 * Format: the Geomview manual, "OFF Files".
 */
#ifndef vtkRelievoOFFReader_h
#define vtkRelievoOFFReader_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoIOModule.h" // for the export macro

class VTKRELIEVOIO_EXPORT vtkRelievoOFFReader : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoOFFReader* New();
  vtkTypeMacro(vtkRelievoOFFReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the file. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** SINGLE_PRECISION or DOUBLE_PRECISION of vtkAlgorithm. Default: DOUBLE_PRECISION. */
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  /** 1 if the file can be opened and starts with a header that this class reads, otherwise 0. */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

protected:
  vtkRelievoOFFReader();
  ~vtkRelievoOFFReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRelievoOFFReader(const vtkRelievoOFFReader&) = delete;
  void operator=(const vtkRelievoOFFReader&) = delete;

  // Throws the problem of the file, only inside the source file.
  void Parse(vtkPolyData* output);

  char* FileName = nullptr;
  int OutputPointsPrecision = vtkAlgorithm::DOUBLE_PRECISION;
};

#endif
