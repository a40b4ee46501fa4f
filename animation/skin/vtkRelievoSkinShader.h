// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What moves vertices in the shaders of VTK's mappers: shaders/skin/skin.glsl, by replacements, and
 * the vertex attributes that it reads.
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
  /// For points of at most so many bones, 0: none that move, of a mesh that vtkRelievoSkinRestPose
  /// has prepared. What is set already stays, so that VTK makes no shaders anew.
  void Set(vtkShaderProperty* shaders, vtkPolyDataMapper* mapper, int influences, bool dual);

  /// Whether they still have what was set.
  bool IsIn(vtkShaderProperty* shaders) const;

  bool Moves() const { return this->Influences > 0; }
  int GetNumberOfReplacements() const { return this->Moves() ? 4 : 0; }

private:
  int Influences = 0;
  bool Dual = false;
  std::string PointText; // what replaces the points
};
}

#endif
