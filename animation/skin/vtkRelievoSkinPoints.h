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

/// The output is the input with other points, normals and tangents, and without the bones' field
/// data. Points without weight stay. `precision`: of the points, as vtkAlgorithm names it. Returns
/// "", or what is missing, and then the output is empty.
std::string SkinMesh(
  vtkPolyData* input, vtkPolyData* skeleton, SkinMethod method, int precision, vtkPolyData* output);

/// Takes the bones' field data away: the mesh is moved.
void TakeBones(vtkPolyData* mesh);
}

#endif
