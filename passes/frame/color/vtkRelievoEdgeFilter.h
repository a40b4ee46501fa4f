// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's FXAA over the picture that is bound for drawing, whether its framebuffer has one sample of
// each pixel or several, all of one colour: those are resolved to be read.
#ifndef vtkRelievoEdgeFilter_h
#define vtkRelievoEdgeFilter_h

#include "vtkNew.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

class vtkRelievoFrameContext;
class vtkWindow;

class vtkRelievoEdgeFilter
{
public:
  void Execute(const vtkRelievoFrameContext& context);
  void Release(vtkWindow* window);

private:
  void Resolve(const vtkRelievoFrameContext& context);

  vtkNew<vtkOpenGLFXAAFilter> Filter;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkSmartPointer<vtkTextureObject> Resolved; // as large as to the viewport's far corner
};

#endif
