// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowInternals.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <vector>

vtkStandardNewMacro(vtkRelievoShadowPass);

//------------------------------------------------------------------------------
vtkRelievoShadowPass::vtkRelievoShadowPass()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoShadowPass::~vtkRelievoShadowPass() = default;

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetLightCasts(vtkLight* light, bool casts)
{
  this->Internal->Lights.SetCasts(light, casts);
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::GetLightCasts(vtkLight* light)
{
  return this->Internal->Lights.Casts(light);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetLightName(vtkLight* light, const std::string& name)
{
  this->Internal->Lights.SetName(light, name);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowPass::GetLightName(vtkRenderer* renderer, vtkLight* light)
{
  return this->Internal->Lights.GetName(renderer, light);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowPass::GetLightLayer(vtkRenderer* renderer, vtkLight* light)
{
  return this->Internal->Lights.GetLayer(renderer, light);
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoShadowPass::GetShadowLayers(vtkRenderer* renderer)
{
  return this->Internal->Lights.GetLayers(renderer);
}

//------------------------------------------------------------------------------
std::map<std::string, int> vtkRelievoShadowPass::FindLights(
  const std::vector<std::string>& layers, vtkRenderer* renderer) const
{
  return this->Internal->Lights.Find(layers, renderer);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetPropCasts(vtkProp* prop, int casts)
{
  if (!prop || casts < CASTS_IF_OPAQUE || casts > CASTS_ALWAYS)
  {
    vtkErrorMacro("SetPropCasts was given " << (prop ? "casting " : "no prop and casting ") << casts
                                            << "; give it a vtkProp of the renderer, and "
                                            << "-1 (if opaque), 0 (never) or 1 (always).");
    return;
  }
  this->Internal->Work.Props.GetChoice(prop).Casts = casts;
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetPropCasts(vtkProp* prop)
{
  return this->Internal->Work.Props.GetChoice(prop).Casts;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::AddPlainActorClass(const std::string& name)
{
  vtkRelievoCasterDraw::AddActorClass(name);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetPropReceives(vtkProp* prop, bool receives)
{
  if (!prop)
  {
    vtkErrorMacro("SetPropReceives was given no prop; give it a vtkProp of the renderer.");
    return;
  }
  this->Internal->Work.Props.GetChoice(prop).Receives = receives;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::GetPropReceives(vtkProp* prop)
{
  return this->Internal->Work.Props.GetChoice(prop).Receives;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetController(vtkMultiProcessController* controller)
{
  if (this->GetController() != controller)
  {
    this->Internal->Schedule.Exchange.SetController(controller);
    this->Internal->Lamps.Schedule.Exchange.SetController(controller);
    this->Internal->Work.Others.SetController(controller);
    this->Internal->Lamps.Work.Cache.Clear();
    this->Internal->Work.Cache.Clear(); // maps of this process alone, or of others that are gone
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkRelievoShadowPass::GetController()
{
  return this->Internal->Schedule.Exchange.GetController();
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPass::GetMergeSeconds()
{
  return this->Internal->Schedule.Exchange.GetSeconds();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetNumberOfCastingLights()
{
  return static_cast<int>(this->Internal->Lights.GetCasting().size());
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetNumberOfMaps()
{
  return this->Internal->Work.Cache.GetNumberOfMaps();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::Prepare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.BeginTiming(context.Picture);
  vtkRelievoAccess::Renderer::FollowCamera(context.Renderer);
  // The shaders that draw the maps are built for the lights that VTK counts here.
  static_cast<vtkOpenGLRenderer*>(context.Renderer)->UpdateLights();
  in.LayersAsked = context.IsAsked(this, "visibility");
  in.LampsAsked = context.IsAsked(this, "lamp shadows");
  const bool lights = in.LayersAsked || context.IsAsked(this, "shadow maps");
  lights ? this->CollectLights(context) : in.Lights.Clear();
  if (in.Lights.GetCasting().empty() && !in.LampsAsked)
  {
    in.Planned = false;
    this->Explain("no_lights", "no light casts" + in.Lights.GetReport());
    return false;
  }
  if (!in.LampsAsked)
  {
    in.Lamps.Release(context.Window);
  }
  this->DrawCalls = 0;
  this->NumberOfMapsDrawn = 0;
  in.Work.View = context.View;
  in.Work.Props.SetAttenuates(this->ColoredShadows);
  in.Work.Props.Collect(context.Renderer, context.Scene.Props);
  const bool traces =
    this->Method == METHOD_EXACT || this->Tolerance > 0.0 || this->TimeBudget > 0.0;
  // What is translucent may be another process's.
  context.ColorsLight = this->Visible && this->ColoredShadows && traces &&
    !in.Lights.GetCasting().empty() &&
    (in.Work.Others.IsOn() || in.Work.Props.HasTranslucentCasters());
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkRelievoShadowWork& work = in.Work;
  if (work.View.Viewport[2] <= 0 || work.View.Viewport[3] <= 0)
  {
    return;
  }
  in.Window = context.Window;
  in.Renderer = context.Renderer;
  in.Frame = context.Frame;
  work.PlainDraw.SetWindow(in.Window);
  const bool lights = !in.Lights.GetCasting().empty();
  std::string fault;
  if (lights)
  {
    work.Bias = this->Bias;
    work.ColoredShadows = this->ColoredShadows;
    fault = this->MakeMaps(context);
    if (!in.Planned && !in.Method->Traces())
    {
      work.Props.ForgetGlyphs();
    }
  }
  else
  {
    in.Planned = false;
    in.UseMethod(METHOD_MAP, context.Window);
    work.WithoutFollowed = false;
    work.Maps.Release(context.Window);
    work.Cache.Clear();
    work.Others.Clear();
  }
  // Processes that draw together fit their maps together, though there be none.
  const bool lamps =
    in.LampsAsked && (!context.CastingLamps.empty() || in.Lamps.Schedule.Exchange.IsOn());
  std::vector<std::string> words;
  if (!fault.empty())
  {
    this->SayOnce("No shadows: " + fault);
    words.push_back(fault);
    work.Cache.Clear();
    in.Method->Unbind(); // what it took in Prepare
  }
  in.UpdateStructure();
  if (!lamps)
  {
    in.Lamps.Release(context.Window);
  }
  if ((!lights || !fault.empty()) && !lamps)
  {
    this->Explain(lights ? "failed" : "idle", lights ? fault : "no lamp that is seen casts");
    return;
  }
  in.Spliced = true;
  work.Props.AddPass(this);
  in.Told.clear();
  if (lights && fault.empty())
  {
    this->DrawLights(context);
    words.push_back(this->DescribeMaps());
  }
  if (lamps)
  {
    words.push_back(this->DrawLamps(context));
  }
  in.Told.clear();
  std::string all;
  for (const std::string& each : words)
  {
    all += (all.empty() ? "" : "; ") + each;
  }
  this->Explain("ran", all);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SayOnce(const std::string& error)
{
  if (this->Internal->Said.insert(error).second)
  {
    vtkErrorMacro(<< error << ".");
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Finish(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (in.Spliced)
  {
    in.Work.Props.RemovePass(this);
    in.Work.Maps.Unbind();
    in.Lamps.Unbind();
    in.Method->Unbind();
    in.Spliced = false;
    if (in.Work.Props.ChangesByDrawing())
    {
      // Some mappers count themselves as modified when they draw.
      const bool probed = in.Probe.HasScene(in.Work.Props);
      in.Work.Props.Collect(context.Renderer, context.Scene.Props);
      in.Work.Cache.SetCasters(in.Work.Props, in.Work.WithoutFollowed);
      in.Lamps.Work.Cache.SetCasters(in.Work.Props, false);
      in.Method->Settle(in.Work);
      if (probed)
      {
        in.Probe.Settle(in.Work.Props);
      }
    }
  }
  if (context.Window->GetAbortRender())
  {
    // Mappers draw nothing from there on: what maps and masks hold is not all that casts.
    in.Work.Cache.Invalidate();
    in.Lamps.Work.Cache.Invalidate();
    in.Method->Forget();
    in.TimedView = glm::dmat4(0.0); // the next frame finds everything anew
  }
  else
  {
    this->EndTiming(context); // of an aborted frame the time tells nothing
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoShadowPass::GetBytesHeld()
{
  return this->Internal->Work.Maps.GetBytes() + this->Internal->Method->GetBytes() +
    this->Internal->Lamps.Work.Maps.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Work.Maps.Release(window);
  this->Internal->Method->Release(window);
  this->Internal->Lamps.Release(window);
  this->Internal->Work.PlainDraw.Release(window);
  this->Internal->Work.Props.ForgetGlyphs();
  this->Internal->Work.Cache.Clear();
  this->Internal->Lights.Clear();
  this->Internal->MethodRefused = -1; // another window's OpenGL may hold what this one did not
  this->Internal->RoomRefused = 0.0;
  this->Internal->Probe.Release();
  this->NumberOfMapsDrawn = 0;
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
