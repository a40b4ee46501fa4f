// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What hides the sky in a renderer, for the rays of shaders/ambient/shareFS.glsl: the opaque
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
  // Brings it up to date, and takes a texture unit. Returns why not, in words. Processes that draw
  // together all call it, also with what is `wrong` already.
  std::string Begin(const vtkRelievoFrameContext& context, const std::string& wrong);
  // Names of uniforms begin with `relievo`, or with what is in its place.
  void SetUniforms(vtkShaderProgram* program, const vtkRelievoFrameContext& context,
    const std::string& prefix = "relievo") const;
  void End() { this->Tree.Unbind(); }

  vtkIdType GetNumberOfTriangles() const { return this->Tree.GetNumberOfTriangles(); }
  std::string GetReport() const { return this->Others.GetReport(); } // of other processes
  // That rays cannot follow.
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
