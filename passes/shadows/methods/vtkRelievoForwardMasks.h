// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Forward shadow mapping: which pixels each light reaches, found by carrying the samples of its
// maps into the camera's view (H. Zhang, Forward shadow mapping, 1998) and comparing them there, in
// eye space, with the depth of what is seen.
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

  // x, y, width, height of what is drawn to now.
  static void GetViewport(int region[4]);

  // True if what was drawn before is lost.
  bool Allocate(vtkOpenGLRenderWindow* window, int width, int height, int lights);

  // Draws the depth that the camera sees: `surfaces` is called with the framebuffer bound.
  void DrawDepth(const std::function<void()>& surfaces);

  // Between BeginLight and EndLight: marks what of one light's maps is seen, `layer` of the maps
  // bound to the texture unit. False if a shader does not compile.
  bool BeginLight(int light, const vtkRelievoFrameCamera& camera, int mapUnit, int mapSize);
  void DrawMap(const vtkRelievoShadowView& view, int layer, double tolerance);
  void EndLight();

  // False if OpenGL has no memory for them, or no texture unit is free.
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
  std::unique_ptr<vtkRelievoScopedState> Kept; // between Begin and End
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkShaderProgram* Program = nullptr; // the window's shader cache owns it
  glm::dmat4 WorldToView{ 1.0 };
  glm::dmat4 ViewToNDC{ 1.0 };
  unsigned int Masks = 0;
  unsigned int Arrays = 0; // without any: samples are made of their number
  int Width = 0;
  int Height = 0;
  int Lights = 0;
  int Unit = -1;
  int MapSize = 0;
};

#endif
