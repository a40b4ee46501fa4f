// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDelegate.h"

#include "vtkActor.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkRelievoAccess.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"

#include <algorithm>

vtkStandardNewMacro(vtkRelievoSentinelProp);
vtkStandardNewMacro(vtkRelievoWireFrameSentinel);

//------------------------------------------------------------------------------
int vtkRelievoDelegate::Render(
  vtkRenderPass* pass, const vtkRenderState* s, const DelegateEvents& events)
{
  vtkProp** props = s->GetPropArray();
  int count = s->GetPropArrayCount();
  if (count > 0 &&
    (events.OpaqueBegins || events.OpaqueEnds || events.TranslucentBegins || events.OverlayBegins))
  {
    this->Begin->Opaque = events.OpaqueBegins;
    this->Begin->TranslucentAsked = events.TranslucentAsked;
    if (events.TranslucentBegins)
    {
      this->Begin->Translucent = [&]() { events.TranslucentBegins(this->Begin); };
    }
    this->Begin->Volumes = events.VolumesBegin;
    this->Begin->Overlay = events.OverlayBegins;
    this->Props.assign(1, this->Begin);
    this->Props.insert(this->Props.end(), props, props + count);
    if (vtkHiddenLineRemovalPass::WireframePropsExist(props, count))
    {
      this->EndOfWireFrames->Reached = events.OpaqueEnds;
      this->Props.push_back(this->EndOfWireFrames);
    }
    else
    {
      this->End->Opaque = events.OpaqueEnds;
      this->Props.push_back(this->End);
    }
    props = this->Props.data();
    count = static_cast<int>(this->Props.size());
  }
  if (!pass && s->GetFrameBuffer())
  {
    if (!this->Steps)
    {
      this->Steps = vtkSmartPointer<vtkRenderStepsPass>::New();
    }
    pass = this->Steps;
  }
  const int drawn = pass ? RenderPass(pass, s, props, count) : RenderOwnSteps(s, props, count);
  this->Props.clear();
  this->Begin->Opaque = this->Begin->Overlay = nullptr;
  this->Begin->TranslucentAsked = this->Begin->Translucent = this->Begin->Volumes = nullptr;
  this->End->Opaque = nullptr;
  this->EndOfWireFrames->Reached = nullptr;
  return drawn;
}

//------------------------------------------------------------------------------
void vtkRelievoDelegate::LeaveTranslucentOut(vtkRenderer* renderer)
{
  const auto leave = [this](vtkProp* prop) -> vtkProp* {
    const bool out = vtkActor::SafeDownCast(prop) && prop->HasTranslucentPolygonalGeometry();
    return out ? this->End : prop;
  };
  std::transform(this->Props.begin(), this->Props.end(), this->Props.begin(), leave);
  vtkRelievoAccess::Renderer::ForProps(renderer, leave); // newer VTK has a copy of them
}

//------------------------------------------------------------------------------
void vtkRelievoDelegate::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Steps)
  {
    this->Steps->ReleaseGraphicsResources(window);
    this->Steps = nullptr;
  }
}

//------------------------------------------------------------------------------
int vtkRelievoDelegate::RenderPass(
  vtkRenderPass* pass, const vtkRenderState* s, vtkProp** props, int numberOfProps)
{
  vtkRenderState state(s->GetRenderer());
  state.SetFrameBuffer(s->GetFrameBuffer());
  state.SetRequiredKeys(s->GetRequiredKeys());
  state.SetPropArrayAndCount(props, numberOfProps);
  // ParaView's pass draws the renderer's own props instead of the state's.
  const vtkRelievoAccess::Renderer::Props inUse(s->GetRenderer(), props, numberOfProps);
  pass->Render(&state);
  return pass->GetNumberOfRenderedProps();
}

//------------------------------------------------------------------------------
int vtkRelievoDelegate::RenderOwnSteps(const vtkRenderState* s, vtkProp** props, int numberOfProps)
{
  auto* renderer = static_cast<vtkOpenGLRenderer*>(s->GetRenderer());
  vtkRelievoAccess::Renderer::RenderOwnSteps(renderer, props, numberOfProps);
  return renderer->GetNumberOfPropsRendered();
}
