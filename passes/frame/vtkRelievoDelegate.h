// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draws the picture as it would be without Relievo, by a pass or by the renderer's own steps, and
// tells when its opaque geometry begins and ends, when what is translucent, volumes and its overlay
// begin.
#ifndef vtkRelievoDelegate_h
#define vtkRelievoDelegate_h

#include "vtkNew.h"
#include "vtkRelievoSentinelProp.h"
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkRenderState;
class vtkWindow;

class vtkRelievoDelegate
{
public:
  // Called as often as the delegate draws opaque geometry, and so on; empty ones cost nothing.
  struct DelegateEvents
  {
    std::function<void()> OpaqueBegins;
    std::function<void()> OpaqueEnds;
    std::function<void()> TranslucentAsked; // before it is drawn by most delegates, not by all
    // With the sentinel, which has the keys of the passes that draw.
    std::function<void(vtkProp*)> TranslucentBegins;
    std::function<void()> VolumesBegin;
    std::function<void()> OverlayBegins;
  };

  // Without a pass the renderer's own steps; into a framebuffer of an outer pass, which those know
  // nothing of, the same steps as a pass. Returns the number of props drawn.
  int Render(vtkRenderPass* pass, const vtkRenderState* s, const DelegateEvents& events);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  static int RenderPass(
    vtkRenderPass* pass, const vtkRenderState* s, vtkProp** props, int numberOfProps);
  static int RenderOwnSteps(const vtkRenderState* s, vtkProp** props, int numberOfProps);

  vtkSmartPointer<vtkRenderPass> Steps;
  vtkNew<vtkRelievoSentinelProp> Begin;
  vtkNew<vtkRelievoSentinelProp> End;
  vtkNew<vtkRelievoWireFrameSentinel> EndOfWireFrames;
  std::vector<vtkProp*> Props; // of the frame, between the sentinels
};

#endif
