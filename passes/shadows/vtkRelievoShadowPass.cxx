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
void vtkRelievoShadowPass::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "shadows";
  description.Help = "Shadows of lights (suns, spots and points) and of lamps from data.";
  description.Slot = vtkRelievoStageDescription::LIGHT_MAPS;
  description.Writes = { "shadow maps", "visibility", "lamp shadows" };
  description.OnByDefault = true;
  description.AddFlag(
    "visible", this->Visible, [this](bool on) { this->SetVisible(on); },
    "Whether shadows are seen in the picture.");
  description.AddChoice(
    "method", this->Method, [this](int method) { this->SetMethod(method); },
    { "map", "forward", "warped", "exact" }, "How shadows are computed.");
  description.AddWhole(
    "map_size", this->MapSize, [this](int size) { this->SetMapSize(size); }, 16, 16384, "texels",
    "Width and height of each light's map.");
  description.AddWhole(
    "filter_radius", this->FilterRadius, [this](int radius) { this->SetFilterRadius(radius); }, 0,
    16, "texels", "How soft the edges of shadows are.");
  description.AddNumber(
    "bias", this->Bias, [this](double bias) { this->SetBias(bias); }, 0.0, 100.0, "texels",
    "Distance by which receivers are moved towards the light before the comparison.");
  description.AddNumber(
    "strength", this->Strength, [this](double strength) { this->SetStrength(strength); }, 0.0, 1.0,
    "", "Fraction of a blocked light that is removed.");
  description.AddNumber(
    "tolerance", this->Tolerance, [this](double share) { this->SetTolerance(share); }, 0.0, 1.0, "",
    "Share of wrong pixels that method and map size are chosen for; 0: as they are set.");
  description.AddNumber(
    "time_budget", this->TimeBudget, [this](double time) { this->SetTimeBudget(time); }, 0.0,
    3600000.0, "ms", "Time of a frame that method and map size are chosen for; 0: any.");
  description.AddWhole(
    "lamp_map_size", this->LampMapSize, [this](int size) { this->SetLampMapSize(size); }, 16, 16384,
    "texels", "Width and height of each map of a lamp from data; a lamp has up to six.");
  this->DescribeSoft(description);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  // The visibility is for layers, and lamps are lit by their own stage, whether shadows of lights
  // are seen or not.
  declaration.Offers.clear();
  if (this->Visible)
  {
    declaration.Offers.emplace_back("shadow maps");
  }
  declaration.Words = this->Visible ? "" : "shadows are off";
  this->DeclareSoft(context, declaration);
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPass::Prepare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.BeginTiming();
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
  in.Work.Props.Collect(context.Renderer, context.Scene.Props);
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
    fault = this->MakeMaps(context);
  }
  else
  {
    in.Planned = false;
    in.UseMethod(METHOD_MAP, context.Window);
    work.Maps.Release(context.Window);
    work.Cache.Clear();
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
      in.Work.Cache.SetCasters(in.Work.Props);
      in.Lamps.Work.Cache.SetCasters(in.Work.Props);
      in.Method->Settle(in.Work);
      if (probed)
      {
        in.Probe.Settle(in.Work.Props);
      }
    }
  }
  this->EndTiming(context);
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
  this->Internal->Work.Cache.Clear();
  this->Internal->Lights.Clear();
  this->Internal->MethodRefused = -1; // another window's OpenGL may hold what this one did not
  this->Internal->RoomRefused = 0.0;
  this->Internal->Probe.Release();
  this->NumberOfMapsDrawn = 0;
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Visible: " << this->Visible << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "LampMapSize: " << this->LampMapSize << "\n";
  os << indent << "FilterRadius: " << this->FilterRadius << "\n";
  os << indent << "Bias: " << this->Bias << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "SoftSamples: " << this->SoftSamples << "\n";
  os << indent << "SoftAtOnce: " << this->SoftAtOnce << "\n";
  os << indent << "SunAngle: " << this->SunAngle << "\n";
  os << indent << "LampRadius: " << this->LampRadius << "\n";
  os << indent << "Casting lights: " << this->GetNumberOfCastingLights() << "\n";
  os << indent << "Maps: " << this->GetNumberOfMaps() << "\n";
}
