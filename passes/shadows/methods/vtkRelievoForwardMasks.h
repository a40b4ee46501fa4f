// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Forward shadow mapping: finds the pixels lit by each light by transforming the samples of its
// maps into the camera's view (H. Zhang, Forward shadow mapping, 1998) and comparing them there, in
// eye space, with the visible depth.
#ifndef vtkRelievoForwardMasks_h
#define vtkRelievoForwardMasks_h

#include "vtkRelievoScopedState.h"
#include "vtkRelievoShadowFit.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <memory>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;
struct vtkRelievoFrameCamera;

class vtkRelievoForwardMasks
{
public:
  vtkRelievoForwardMasks();
  ~vtkRelievoForwardMasks();
  vtkRelievoForwardMasks(const vtkRelievoForwardMasks&) = delete;
  void operator=(const vtkRelievoForwardMasks&) = delete;

  // x, y, width, height of the present viewport.
  static void GetViewport(int region[4]);

  // True if the former contents are lost.
  bool Allocate(vtkOpenGLRenderWindow* window, int width, int height, int lights);

  // Draws the camera's depth: `surfaces` is called with the framebuffer bound.
  void DrawDepth(const std::function<void()>& surfaces);

  // Call between BeginLight and EndLight: marks the pixels seen by one of the light's maps, `layer`
  // of the maps bound to the texture unit. False if a shader does not compile.
  bool BeginLight(int light, const vtkRelievoFrameCamera& camera, int mapUnit, int mapSize);
  void DrawMap(const vtkRelievoShadowView& view, int layer, double tolerance);
  void EndLight();

  // False if OpenGL has no memory or no texture unit.
  bool Bind();
  void Unbind();
  int GetTextureUnit() const { return this->Unit; }

  bool IsThere() const { return this->Masks != 0; }
  vtkIdType GetBytes() const
  {
    return this->Masks ? GetBytes(this->Width, this->Height, this->Lights) : 0;
  }
  static vtkIdType GetBytes(int width, int height, int lights);
  void Release(vtkWindow* window);

private:
  void Begin();
  void DrawTo(unsigned int buffer);
  void End();

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  std::unique_ptr<vtkRelievoScopedState> SavedState; // between Begin and End
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkShaderProgram* Program = nullptr; // owned by the window's shader cache
  glm::dmat4 WorldToView{ 1.0 };
  glm::dmat4 ViewToNDC{ 1.0 };
  unsigned int Masks = 0;
  unsigned int Arrays = 0; // without attributes: the shader computes samples from their number
  int Width = 0;
  int Height = 0;
  int Lights = 0;
  int Unit = -1;
  int MapSize = 0;
};

#endif
