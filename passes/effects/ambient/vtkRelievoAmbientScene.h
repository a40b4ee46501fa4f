// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What hides the sky in a renderer, for the rays of shaders/ambient/shareFS.glsl: the opaque
// triangles of all visible props, those outside the view included.
#ifndef vtkRelievoAmbientScene_h
#define vtkRelievoAmbientScene_h

#include "vtkRelievoOpaqueMeshes.h"
#include "vtkRelievoTreeBuffer.h"

#include <string>

class vtkRelievoFrameContext;
class vtkShaderProgram;
class vtkWindow;

class vtkRelievoAmbientScene
{
public:
  // Brings it up to date, and takes a texture unit. Returns why not, in words.
  std::string Begin(const vtkRelievoFrameContext& context);
  void SetUniforms(vtkShaderProgram* program, const vtkRelievoFrameContext& context) const;
  void End() { this->Tree.Unbind(); }

  vtkIdType GetNumberOfTriangles() const { return this->Tree.GetNumberOfTriangles(); }
  // That rays cannot follow.
  int GetNumberOfPropsLeftOut() const { return this->Meshes.GetNumberOfPropsLeftOut(); }

  vtkIdType GetBytes() const { return this->Tree.GetBytes(); }
  void Release(vtkWindow* window);

private:
  vtkRelievoTreeBuffer Tree;
  vtkRelievoOpaqueMeshes Meshes;
};

#endif
