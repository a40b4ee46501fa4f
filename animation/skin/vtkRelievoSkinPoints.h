// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Moves the points of one mesh with its bones.
 */
#ifndef vtkRelievoSkinPoints_h
#define vtkRelievoSkinPoints_h

#include <string>

class vtkPolyData;

namespace relievo
{
enum class SkinMethod
{
  Linear,
  DualQuaternion,
  KeyMatrix
};

/// The output is the input with moved points, normals and tangents, and without the bones' field
/// data. Points without weight stay. `precision`: that of the points, as in vtkAlgorithm. Returns
/// "", or what is missing; the output is then empty.
std::string SkinMesh(
  vtkPolyData* input, vtkPolyData* skeleton, SkinMethod method, int precision, vtkPolyData* output);

/// Removes the bones' field data, because the mesh has been moved.
void TakeBones(vtkPolyData* mesh);
}

#endif
