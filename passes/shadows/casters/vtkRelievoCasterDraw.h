// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws the depth of plain meshes from their mappers' buffers, without the mappers' shaders: what a
// map needs of them, and all that most casters are. Composite meshes as well, where VTK has a
// mapper of helpers for them (before 9.3).
#ifndef vtkRelievoCasterDraw_h
#define vtkRelievoCasterDraw_h

#include "vtkRelievoFormulas.h" // for GLM
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <string>
#include <vector>

class vtkActor;
class vtkOpenGLPolyDataMapper;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkShaderProgram;
class vtkWindow;

class vtkRelievoCasterDraw
{
public:
  vtkRelievoCasterDraw() = default;
  ~vtkRelievoCasterDraw();
  vtkRelievoCasterDraw(const vtkRelievoCasterDraw&) = delete;
  void operator=(const vtkRelievoCasterDraw&) = delete;

  // The window that is drawn in; what another one held is released.
  void SetWindow(vtkOpenGLRenderWindow* window);

  // A mapper has drawn in this window: its buffers, as built now, are in this context.
  void Learn(vtkOpenGLPolyDataMapper* mapper);

  // The prop as an actor whose triangles are all that it casts, with buffers in this context that
  // are up to date; nullptr for anything else: textures, own shaders, clipping planes, lines, other
  // mappers.
  vtkActor* GetPlainActor(vtkProp* prop) const;

  // What GetPlainActor gives, and also an actor whose depths VTK moves by a little (IsOffset).
  vtkActor* GetSurface(vtkProp* prop) const;
  static bool IsOffset(vtkActor* actor);
  static glm::vec2 GetOffset(vtkActor* actor); // by slope, and constant

  // Changes when what it would draw is of other buffers.
  vtkMTimeType GetBuildTime(vtkActor* actor) const;

  // Between Begin and End, into what is bound for drawing. False if the shader does not compile.
  bool Begin(vtkOpenGLRenderWindow* window, const glm::dmat4& worldToNDC);

  // Begins drawing with another program, which may read MCVCMatrix and relievoSeenOffset as well.
  // False if the shader does not compile.
  bool Begin(vtkOpenGLRenderWindow* window, const glm::dmat4& worldToNDC,
    const glm::dmat4& worldToView, const std::string& vertexShader,
    const std::string& fragmentShader, const std::string& defines = std::string());
  int Draw(vtkActor* actor); // returns draw calls
  void End();

  void Release(vtkWindow* window);

private:
  // The mappers whose buffers are all that the actor draws; none if it draws otherwise.
  std::vector<vtkOpenGLPolyDataMapper*> GetBuffers(vtkActor* actor) const;
  bool IsBuilt(vtkOpenGLPolyDataMapper* mapper) const;
  int Draw(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkShaderProgram* Program = nullptr; // the window's shader cache owns it
  glm::dmat4 WorldToNDC{ 1.0 };
  glm::dmat4 WorldToView{ 1.0 };
  struct Known
  {
    vtkWeakPointer<vtkOpenGLPolyDataMapper> Mapper;
    vtkMTimeType BuildTime;
  };
  std::map<vtkOpenGLPolyDataMapper*, Known> Built;
  unsigned int Arrays = 0;
  int Attribute = -1;
};

#endif
