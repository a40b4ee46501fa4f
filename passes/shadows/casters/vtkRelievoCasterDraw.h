// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws the depth of plain meshes from their mappers' buffers, without the mappers' shaders: a map
// needs no more, and most casters are plain. Also draws composite meshes if VTK has a mapper of
// helpers for them (before 9.3).
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
class vtkRelievoDepthRaster;
class vtkRenderer;
class vtkShaderProgram;
class vtkWindow;

class vtkRelievoCasterDraw
{
public:
  vtkRelievoCasterDraw() = default;
  ~vtkRelievoCasterDraw();
  vtkRelievoCasterDraw(const vtkRelievoCasterDraw&) = delete;
  void operator=(const vtkRelievoCasterDraw&) = delete;

  // Sets the window to draw in; resources of another one are released.
  void SetWindow(vtkOpenGLRenderWindow* window);

  // Records that a mapper has drawn in this window: its buffers are then in this context.
  void Learn(vtkOpenGLPolyDataMapper* mapper);

  // The prop as an actor that casts with all of its triangles and nothing else, with up-to-date
  // buffers in this context; nullptr for any other prop: textures, custom shaders, clipping planes,
  // lines, other mappers.
  vtkActor* GetPlainActor(vtkProp* prop) const;

  // Like GetPlainActor, but also accepts an actor with a small depth offset by VTK (IsOffset).
  vtkActor* GetSurface(vtkProp* prop) const;
  static bool DrawsOnlyFaces(vtkActor* actor); // as its property and its mapper's settings are
  static bool IsOffset(vtkActor* actor);
  static glm::vec2 GetOffset(vtkActor* actor); // slope factor and constant

  // Changes when Draw would use other buffers.
  vtkMTimeType GetBuildTime(vtkActor* actor) const;

  // Call Draw between Begin and End; it draws into the bound framebuffer. False if the shader does
  // not compile.
  bool Begin(vtkOpenGLRenderWindow* window, const glm::dmat4& worldToNDC);

  // Begins drawing with another program, which may use MCVCMatrix and relievoSeenOffset as well.
  // False if the shader does not compile.
  bool Begin(vtkOpenGLRenderWindow* window, const glm::dmat4& worldToNDC,
    const glm::dmat4& worldToView, const std::string& vertexShader,
    const std::string& fragmentShader, const std::string& defines = std::string());
  int Draw(vtkActor* actor); // returns draw calls
  vtkShaderProgram* GetProgram() const { return this->Program; }
  void End();

  // Fills the buffers of a plain mesh, or of many spheres, that the frame has yet to draw, unless
  // another window may have some.
  void Build(vtkProp* prop, vtkRenderer* renderer);

  // Whether GetPlainActor may find the prop, which it does not now, once VTK has drawn it.
  bool LacksBuffers(vtkProp* prop) const;

  // Draws by the processor, from the buffers, into a part of the map (vtkRelievoDepthRaster), not
  // between Begin and End. Throws std::bad_alloc, also if OpenGL does not hand out the buffers.
  void Rasterize(vtkActor* actor, const glm::dmat4& worldToNDC, const int region[4], bool clamps,
    vtkRelievoDepthRaster& raster) const;

  void Release(vtkWindow* window);

private:
  // The mappers whose buffers contain all of the actor's geometry; none if it draws anything else.
  std::vector<vtkOpenGLPolyDataMapper*> GetBuffers(vtkActor* actor) const;
  bool IsKnown(vtkOpenGLPolyDataMapper* mapper) const; // by its present buffers
  static bool IsCurrent(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);
  bool IsBuilt(vtkOpenGLPolyDataMapper* mapper) const;
  static glm::dmat4 GetBufferToWorld(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);
  int Draw(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkShaderProgram* Program = nullptr; // owned by the window's shader cache
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
