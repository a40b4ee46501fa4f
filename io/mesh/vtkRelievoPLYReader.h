// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoPLYReader
 * @brief Reads meshes in the Polygon File Format (.ply), as text or binary, into one vtkPolyData.
 *
 * The element `vertex` supplies the points, in the precision of `x`, and, if the file has them,
 * - the point array `Normals` (float, 3) of `nx ny nz`;
 * - `RGBA` (unsigned char, 4) of `red green blue` and `alpha` (opaque without it), also with
 *   `diffuse_` before the names: bytes as they are, other whole numbers as shares of the highest
 *   number of their type, float and double as shares of 1;
 * - `TextureCoordinates` (float, 2) of `s t`, `u v`, `texture_s texture_t` or
 *   `texture_u texture_v`;
 * - every other number, as a point array of its name and type.
 * These are the active normals, scalars and texture coordinates.
 *
 * The element `face` supplies the polygons (`vertex_indices` or `vertex_index`); faces of two
 * points are lines, of one point vertices. Colours and other numbers of faces are cell arrays. With
 * a list `texcoord`, two numbers for each corner, points at which it differs are split: the first
 * use has the point's number and the others get points at the end. Without faces, the triangles of
 * the element `tristrips` are read, else lines of `edge` (`vertex1`, `vertex2`). Other elements are
 * skipped. The files that comments `TextureFile` name are the field array `TextureFiles` (text).
 *
 * Errors: one error event names the file, the element or the line, and what was expected, also if
 * the file ends before the data that its header announces; GetErrorCode() is set and the
 * output is empty. Memory stays within a small multiple of the file's size, whatever counts the
 * file claims. Numbers that are not finite are read as they are.
 *
 * Format: G. Turk, The PLY Polygon File Format, 1994.
 */
#ifndef vtkRelievoPLYReader_h
#define vtkRelievoPLYReader_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkRelievoIOModule.h" // for the export macro

class VTKRELIEVOIO_EXPORT vtkRelievoPLYReader : public vtkPolyDataAlgorithm
{
public:
  static vtkRelievoPLYReader* New();
  vtkTypeMacro(vtkRelievoPLYReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the file. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkRelievoPLYReader();
  ~vtkRelievoPLYReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRelievoPLYReader(const vtkRelievoPLYReader&) = delete;
  void operator=(const vtkRelievoPLYReader&) = delete;

  char* FileName = nullptr;
};

#endif
