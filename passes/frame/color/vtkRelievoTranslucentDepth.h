// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Window z of the nearest translucent surface at each pixel's centre, opaque surfaces ignored: for
// stages that process translucent surfaces by depth. Volumes have none. Shaders that read it
// include frame/translucent_depth.glsl.
#ifndef vtkRelievoTranslucentDepth_h
#define vtkRelievoTranslucentDepth_h

#include "vtkRelievoFrameModule.h" // for the export macro
#include "vtkRelievoResource.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRelievoFrameContext;
class vtkTextureObject;
class vtkWindow;

class VTKRELIEVOFRAME_EXPORT vtkRelievoTranslucentDepth : public vtkRelievoResource
{
public:
  vtkRelievoTranslucentDepth();
  ~vtkRelievoTranslucentDepth() override;
  vtkRelievoTranslucentDepth(const vtkRelievoTranslucentDepth&) = delete;
  void operator=(const vtkRelievoTranslucentDepth&) = delete;

  // Draws the frame's translucent surfaces. False if this OpenGL cannot.
  bool Draw(vtkRelievoFrameContext& context);

  vtkIdType GetBytes() const;
  void Release(vtkWindow* window);

  std::string GetDefines() const override;
  void Activate(vtkShaderProgram* program) override;
  void Deactivate() override;

private:
  bool Allocate(vtkRelievoFrameContext& context);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkSmartPointer<vtkTextureObject> Depth;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  int Size[2] = { 0, 0 };
  float Range[3] = { 0.0f, 0.0f, 0.0f }; // near, far, 1 if parallel
};

#endif
