// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Moves vertices in the shaders of VTK's mappers: shaders/skin/skin.glsl, inserted by replacements,
 * and the vertex attributes that it reads.
 */
#ifndef vtkRelievoSkinShader_h
#define vtkRelievoSkinShader_h

#include <string>

class vtkPolyDataMapper;
class vtkShaderProperty;

namespace relievo
{
class SkinShader
{
public:
  /// For points with at most so many bones (0: none moves) of a mesh prepared by
  /// vtkRelievoSkinRestPose. Existing replacements stay, so that VTK does not rebuild shaders.
  void Set(vtkShaderProperty* shaders, vtkPolyDataMapper* mapper, int influences, bool dual);

  /// Whether the replacements are still in place.
  bool IsIn(vtkShaderProperty* shaders) const;

  bool Moves() const { return this->Influences > 0; }
  int GetNumberOfReplacements() const { return this->Moves() ? 4 : 0; }

private:
  int Influences = 0;
  bool Dual = false;
  std::string PointText; // replacement of the points
};
}

#endif
