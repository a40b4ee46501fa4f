// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws the picture without Relievo's effects, by a pass or by the renderer's own steps, and
// reports when its opaque geometry begins and ends, and when translucent geometry, volumes and its
// overlay begin.
#ifndef vtkRelievoDelegate_h
#define vtkRelievoDelegate_h

#include "vtkNew.h"
#include "vtkRelievoSentinelProp.h"
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkRenderState;
class vtkRenderer;
class vtkWindow;

class vtkRelievoDelegate
{
public:
  // Called every time the delegate reaches the phase; empty functions cost nothing.
  struct DelegateEvents
  {
    std::function<void()> OpaqueBegins;
    std::function<void()> OpaqueEnds;
    std::function<void()> TranslucentAsked; // before the drawing, by most delegates
    // The argument is the sentinel, which has the keys of the passes that draw.
    std::function<void(vtkProp*)> TranslucentBegins;
    std::function<void()> VolumesBegin;
    std::function<void()> OverlayBegins;
  };

  // Renders by the pass, or without one by the renderer's own steps; inside an outer pass's
  // framebuffer, which those do not support, by an equivalent pass. Returns the number of props
  // drawn.
  int Render(vtkRenderPass* pass, const vtkRenderState* s, const DelegateEvents& events);

  // Spares the drawing of translucent props that were drawn otherwise; called by OpaqueEnds.
  void LeaveTranslucentOut(vtkRenderer* renderer);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  static int RenderPass(
    vtkRenderPass* pass, const vtkRenderState* s, vtkProp** props, int numberOfProps);
  static int RenderOwnSteps(const vtkRenderState* s, vtkProp** props, int numberOfProps);

  vtkSmartPointer<vtkRenderPass> Steps;
  vtkNew<vtkRelievoSentinelProp> Begin;
  vtkNew<vtkRelievoSentinelProp> End;
  vtkNew<vtkRelievoWireFrameSentinel> EndOfWireFrames;
  std::vector<vtkProp*> Props; // the frame's, between the sentinels
};

#endif
