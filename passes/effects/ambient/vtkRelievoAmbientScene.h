// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The geometry that hides the sky, for the rays of shaders/ambient/shareFS.glsl: the opaque
// triangles of all visible props, those outside the view included, and of all processes that draw
// together.
#ifndef vtkRelievoAmbientScene_h
#define vtkRelievoAmbientScene_h

#include "vtkRelievoMeshExchange.h"
#include "vtkRelievoOpaqueMeshes.h"
#include "vtkRelievoTreeBuffer.h"

#include <string>

class vtkOpenGLRenderWindow;
class vtkRelievoFrameContext;
class vtkShaderProgram;
class vtkWindow;

class vtkRelievoAmbientScene
{
public:
  // Updates the tree, and takes a texture unit. Returns an error message, or an empty string. All
  // processes that draw together call this, also a process with an `error`.
  std::string Begin(const vtkRelievoFrameContext& context, const std::string& error);
  // Uniforms' names start with `relievo`, or with its replacement.
  void SetUniforms(vtkShaderProgram* program, const vtkRelievoFrameContext& context,
    const std::string& prefix = "relievo") const;
  void End() { this->Tree.Unbind(); }

  vtkIdType GetNumberOfTriangles() const { return this->Tree.GetNumberOfTriangles(); }
  std::string GetReport() const { return this->Others.GetReport(); } // about the other processes
  // Props and triangles that rays cannot intersect.
  int GetNumberOfPropsLeftOut() const { return this->Meshes.GetNumberOfPropsLeftOut(); }
  vtkIdType GetTooManyTriangles() const { return this->Meshes.GetTooManyTriangles(); }

  vtkIdType GetBytes() const { return this->Tree.GetBytes(); }
  void Release(vtkWindow* window);

private:
  std::string Update(vtkOpenGLRenderWindow* window, const std::vector<vtkRelievoPlacedMesh>& meshes,
    const glm::dvec3& origin);

  vtkRelievoTreeBuffer Tree;
  vtkRelievoOpaqueMeshes Meshes;
  vtkRelievoMeshExchange Others;
};

#endif
