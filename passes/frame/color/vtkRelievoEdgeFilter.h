// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Applies VTK's FXAA to the picture bound for drawing, single-sampled or multisampled with equal
// samples in each pixel, which are resolved for reading.
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
  vtkSmartPointer<vtkTextureObject> Resolved; // extends to the viewport's far corner
};

#endif
