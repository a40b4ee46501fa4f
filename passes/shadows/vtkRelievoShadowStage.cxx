// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowStage.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoDeclaration.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePass.h"
#include "vtkRelievoLampMaps.h"
#include "vtkRelievoLightMaps.h"
#include "vtkRelievoMessagesOnce.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPlainActor.h"
#include "vtkRelievoShadowCatcher.h"
#include "vtkRelievoShadowCertificate.h"
#include "vtkRelievoShadowCertifier.h"
#include "vtkRelievoShadowLights.h"
#include "vtkRelievoShadowSplice.h"
#include "vtkRelievoShadowStrengths.h"
#include "vtkRelievoShadowUniforms.h"
#include "vtkRelievoShadowVolumes.h"
#include "vtkRelievoSoftLights.h"
#include "vtkRelievoTiles.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

static_assert(vtkRelievoShadowStage::METHOD_MAP == int(vtkRelievoShadowMethods::MAP), "");
static_assert(vtkRelievoShadowStage::METHOD_FORWARD == int(vtkRelievoShadowMethods::FORWARD), "");
static_assert(vtkRelievoShadowStage::METHOD_WARPED == int(vtkRelievoShadowMethods::WARPED), "");
static_assert(vtkRelievoShadowStage::METHOD_EXACT == int(vtkRelievoShadowMethods::EXACT), "");

class vtkRelievoShadowStage::Internals
{
public:
  explicit Internals(vtkRelievoShadowStage* stage)
    : Messages(stage)
  {
  }

  vtkRelievoShadowLights Lights;
  vtkRelievoSoftLights Soft;
  vtkRelievoShadowCasters Casters;     // of all maps
  vtkRelievoLightMaps Maps{ Casters }; // of lights
  vtkRelievoLampMaps Lamps{ Casters }; // from data
  vtkRelievoShadowStrengths Strengths; // of this frame's lights
  vtkRelievoShadowUniforms Uniforms;   // of receivers
  vtkRelievoShadowVolumes Volumes;     // that receive
  vtkRelievoMessagesOnce Messages;
  bool LayersAsked = false; // visibility is requested as a layer
  bool LampsAsked = false;  // and for lamps from data
  bool Spliced = false;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the frame
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkRelievoFramePass> Frame;
  vtkSmartPointer<vtkRelievoShadowCertificate> Certificate;

  static vtkRelievoLightMaps::Settings GetSettings(const vtkRelievoShadowStage& self)
  {
    return { self.Method, self.MapSize, self.Tolerance, self.TimeBudget, self.Bias,
      self.FilterRadius, self.ColoredShadows, self.VolumeNodes, self.VolumeHarmonics };
  }

  // While a map is being drawn: records the program that draws into it.
  bool IsDrawingMaps(vtkShaderProgram* program);
};

vtkStandardNewMacro(vtkRelievoShadowStage);

//------------------------------------------------------------------------------
vtkRelievoShadowStage::vtkRelievoShadowStage()
  : Internal(new Internals(this))
{
}

//------------------------------------------------------------------------------
vtkRelievoShadowStage::~vtkRelievoShadowStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetLightCasts(vtkLight* light, bool casts)
{
  this->Internal->Lights.SetCasts(light, casts);
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowStage::GetLightCasts(vtkLight* light)
{
  return this->Internal->Lights.Casts(light);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetLightName(vtkLight* light, RELIEVO_TEXT name)
{
  this->Internal->Lights.SetName(light, name);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowStage::GetLightName(vtkRenderer* renderer, vtkLight* light)
{
  return renderer ? this->Internal->Lights.GetName(renderer, light) : std::string();
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowStage::GetLightLayer(vtkRenderer* renderer, vtkLight* light)
{
  return renderer ? this->Internal->Lights.GetLayer(renderer, light) : std::string();
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkRelievoShadowStage::GetShadowLayers(vtkRenderer* renderer)
{
  const Internals& in = *this->Internal;
  const bool soft = this->SoftSamples > 1 && !in.Maps.Schedule.Exchange.IsOn();
  return renderer ? in.Lights.GetLayers(renderer, soft ? &in.Soft.Sizes : nullptr)
                  : std::vector<std::string>();
}

//------------------------------------------------------------------------------
std::map<std::string, int> vtkRelievoShadowStage::FindLights(
  const std::vector<std::string>& layers, vtkRenderer* renderer) const
{
  return this->Internal->Lights.Find(layers, renderer);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetPropCasts(vtkProp* prop, int casts)
{
  if (!prop || casts < CASTS_IF_OPAQUE || casts > CASTS_ALWAYS)
  {
    vtkErrorMacro("SetPropCasts was given " << (prop ? "casting " : "no prop and casting ") << casts
                                            << "; give it a vtkProp of the renderer, and "
                                            << "-1 (if opaque), 0 (never) or 1 (always).");
    return;
  }
  this->Internal->Casters.Props.GetChoice(prop).Casts = casts;
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetPropCasts(vtkProp* prop)
{
  return this->Internal->Casters.Props.GetChoice(prop).Casts;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::AddPlainActorClass(RELIEVO_TEXT name)
{
  vtkRelievoPlainActor::AddClass(name);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetPropReceives(vtkProp* prop, bool receives)
{
  if (!prop)
  {
    vtkErrorMacro("SetPropReceives was given no prop; give it a vtkProp of the renderer.");
    return;
  }
  this->Internal->Casters.Props.GetChoice(prop).Receives = receives;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowStage::GetPropReceives(vtkProp* prop)
{
  return this->Internal->Casters.Props.GetChoice(prop).Receives;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetController(vtkMultiProcessController* controller)
{
  if (this->GetController() != controller)
  {
    this->Internal->Maps.Schedule.Exchange.SetController(controller);
    this->Internal->Lamps.Schedule.Exchange.SetController(controller);
    this->Internal->Maps.Work.Others.SetController(controller);
    this->Internal->Maps.Work.Shade.SetController(controller);
    // Maps of this process alone, or of a former group.
    this->Internal->Lamps.Work.Cache.Clear();
    this->Internal->Maps.Work.Cache.Clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkRelievoShadowStage::GetController()
{
  return this->Internal->Maps.Schedule.Exchange.GetController();
}

//------------------------------------------------------------------------------
double vtkRelievoShadowStage::GetMergeSeconds()
{
  return this->Internal->Maps.Schedule.Exchange.GetSeconds();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetNumberOfCastingLights()
{
  return static_cast<int>(this->Internal->Lights.GetCasting().size());
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetNumberOfMaps()
{
  return this->Internal->Maps.Work.Cache.GetNumberOfMaps();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowStage::Prepare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Maps.Planning.Begin(context.Picture);
  vtkRelievoAccess::Renderer::FollowCamera(context.Renderer);
  // VTK counts lights here, and builds the maps' shaders for them.
  static_cast<vtkOpenGLRenderer*>(context.Renderer)->UpdateLights();
  in.LayersAsked = context.IsAsked(this, vtkRelievoResources::Visibility);
  in.LampsAsked = context.IsAsked(this, vtkRelievoResources::LampShadows);
  const bool lights = in.LayersAsked || context.IsAsked(this, vtkRelievoResources::ShadowMaps);
  lights ? this->CollectLights(context) : in.Lights.Clear();
  if (in.Lights.GetCasting().empty() && !in.LampsAsked)
  {
    in.Maps.Planning.SetNone();
    this->Explain("no_lights", "no light casts" + in.Lights.GetReport());
    return false;
  }
  if (!in.LampsAsked)
  {
    in.Lamps.Release(context.Window);
  }
  this->DrawCalls = 0;
  this->NumberOfMapsDrawn = 0;
  in.Maps.Work.View = context.View;
  in.Maps.Work.BackgroundRise = vtkRelievoShadowCatcher::GetRise(context.Renderer);
  in.Maps.Work.TileToPicture = vtkRelievoGetTileToPicture(context.Renderer);
  in.Maps.Work.SteadyView = context.SteadyView;
  in.Casters.Props.SetAttenuates(this->ColoredShadows);
  in.Casters.Props.Collect(context.Renderer, context.Scene.Props);
  const bool traces =
    this->Method == METHOD_EXACT || this->Tolerance > 0.0 || this->TimeBudget > 0.0;
  // Another process may have translucent props, or volumes.
  context.ColorsLight = this->Enabled && this->ColoredShadows && !in.Lights.GetCasting().empty() &&
    (in.Maps.Work.Others.IsOn() || (traces && in.Casters.Props.HasTranslucentCasters()) ||
      !in.Casters.Props.GetVolumeCasters().empty());
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::CollectLights(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkRelievoShadowExchange& exchange = in.Maps.Schedule.Exchange;
  const int most = vtkRelievoShadowMaps::GetMostFaces();
  const bool separates = context.IsPlanned(vtkRelievoResources::DirectLight) ||
    !vtkRelievoShadowCatcher::Find(context).empty();
  const bool soft = this->SoftSamples > 1 && context.Samples > 1;
  in.Lights.Collect(context.Renderer, most, soft ? &in.Soft.Sizes : nullptr, separates);
  if (exchange.IsOn())
  {
    in.Lights.KeepOnly(exchange.FindCommon(in.Lights.GetNumbers()));
  }
  in.Soft.Begin(
    context, soft, this->SoftMaps, { most, vtkRelievoShadowMaps::GetMostRays() }, in.Lights);
  in.Maps.Work.PartStep = in.Soft.GetPartStep();
  for (const vtkRelievoShadowLight& light : in.Lights.GetAll())
  {
    if (light.Broken)
    {
      in.Messages.Warn(std::to_string(light.Number) + light.NoShadow,
        in.Lights.GetName(light) + " casts no shadow: " + light.NoShadow);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const vtkRelievoFrameCamera& view = in.Maps.Work.View;
  if (view.Viewport[2] <= 0 || view.Viewport[3] <= 0)
  {
    return;
  }
  in.Window = context.Window;
  in.Renderer = context.Renderer;
  in.Frame = context.Frame;
  in.Casters.PlainDraw.SetWindow(in.Window);
  const bool lights = !in.Lights.GetCasting().empty();
  std::string fault;
  if (lights)
  {
    fault = in.Maps.Make(context, in.Lights, Internals::GetSettings(*this), in.Messages);
  }
  else
  {
    in.Maps.MakeNone(context.Window);
  }
  // Processes that draw together fit their maps together, even if there are none.
  const bool lamps =
    in.LampsAsked && (!context.CastingLamps.empty() || in.Lamps.Schedule.Exchange.IsOn());
  if (!fault.empty())
  {
    in.Messages.Error("No shadows: " + fault);
  }
  if (lights && fault.empty())
  {
    const std::string noShade = in.Maps.MakeShade(in.Window, Internals::GetSettings(*this),
      in.Soft.Sizes, in.Soft.GetSamples(), in.LayersAsked);
    if (!noShade.empty())
    {
      in.Messages.Error("No shadows of volumes: " + noShade);
    }
  }
  const bool direct = context.IsPlanned(vtkRelievoResources::DirectLight) &&
    !context.IsPlanned(vtkRelievoResources::Shading);
  if (in.Maps.UpdateStructure(in.Window, in.Lights, in.LayersAsked, direct))
  {
    this->ModifyShaders();
    in.Volumes.ModifyShaders();
  }
  if (!lamps)
  {
    in.Lamps.Release(context.Window);
  }
  if ((!lights || !fault.empty()) && !lamps)
  {
    this->Explain(lights ? "failed" : "idle", lights ? fault : "no visible lamp casts");
    return;
  }
  in.Spliced = true;
  in.Casters.Props.AddPass(this);
  in.Uniforms.Forget();
  std::string words = fault;
  if (lights && fault.empty())
  {
    words = this->DrawLights(context);
  }
  if (lamps)
  {
    words += (words.empty() ? "" : "; ") + this->DrawLamps(context);
  }
  in.Uniforms.Forget();
  this->Explain("ran", words);
}

//------------------------------------------------------------------------------
// Returns a description of the shadows.
std::string vtkRelievoShadowStage::DrawLights(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const int mapDraws = in.Maps.DrawMaps(context.Renderer);
  this->NumberOfMapsDrawn = in.Maps.Work.MapsDrawn;
  in.Strengths.Set(in.Maps.Work, this->Enabled ? this->Strength : 0.0);
  context.Provide(vtkRelievoResources::ShadowMaps, &in.Strengths);
  in.Volumes.Begin({ in.Maps.Work, *in.Maps.GetMethod(), this->Enabled ? this->Strength : 0.0,
    in.Renderer, [&in](const std::string& message) {
      in.Messages.Error("No shadows on volumes: " + message);
    } });
  in.Uniforms.Forget();
  const int methodDraws = in.Maps.DrawMethod(context.Renderer);
  this->DrawCalls += mapDraws + methodDraws; // mappers that draw by themselves have counted theirs
  const std::string fault = in.Maps.GetMethod()->GetFault();
  if (!fault.empty())
  {
    in.Messages.Error("Shadows use the maps alone: " + fault);
  }
  const vtkRelievoShadowExchange& exchange = in.Maps.Schedule.Exchange;
  return in.Lights.GetCastingReport() + ", " + in.Maps.GetReport() +
    (this->SoftSamples > 1 ? in.Soft.GetReport(exchange.IsOn()) : std::string()) +
    exchange.GetReport() + in.Lights.GetReport();
}

//------------------------------------------------------------------------------
// Returns a description of the shadows.
std::string vtkRelievoShadowStage::DrawLamps(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Lamps.Work.Bias = this->Bias;
  const int size = vtkRelievoLightMaps::GetSizeHere(this->LampMapSize, in.Messages);
  const std::string fault = in.Lamps.Draw(context, size, this->FilterRadius, this->Strength);
  if (!fault.empty())
  {
    in.Messages.Error("No shadows of lamps: " + fault);
    in.Lamps.Release(context.Window);
    return "no shadows of lamps: " + fault;
  }
  this->DrawCalls += in.Lamps.GetDrawCalls();
  context.Provide(vtkRelievoResources::LampShadows, &in.Lamps);
  return in.Lamps.GetReport();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::Finish(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  if (in.Spliced)
  {
    in.Casters.Props.RemovePass(this);
    in.Volumes.End();
    in.Maps.Unbind();
    in.Lamps.Unbind();
    in.Spliced = false;
    if (in.Casters.Props.ChangesByDrawing())
    {
      // Some mappers mark themselves as modified when they draw.
      const vtkRelievoLightMaps::Known known = in.Maps.GetKnown();
      in.Casters.Props.Collect(context.Renderer, context.Scene.Props);
      in.Maps.Settle(known);
      in.Lamps.Work.Cache.SetCasters(in.Casters.Props, false);
    }
  }
  if (context.Window->GetAbortRender())
  {
    // Mappers skip drawing from there on: maps and masks are incomplete.
    in.Maps.Invalidate();
    in.Lamps.Work.Cache.Invalidate();
  }
  else
  {
    // The time of an aborted frame is meaningless.
    in.Maps.Planning.End(in.Maps.GetScene(in.Lights), context.Picture, this->NumberOfMapsDrawn > 0,
      this->GetShaderTime());
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoShadowStage::GetBytesHeld()
{
  return this->Internal->Maps.GetBytes() + this->Internal->Lamps.Work.Maps.GetBytes() +
    this->Internal->Casters.Props.GetPointGroupBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Maps.Release(window);
  this->Internal->Lamps.Release(window);
  this->Internal->Lights.Clear();
  this->NumberOfMapsDrawn = 0;
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "shadows";
  description.Help = "Shadows of lights (suns, spots and points) and of lamps from data.";
  description.Slot = vtkRelievoStageDescription::LIGHT_MAPS;
  description.Writes = { vtkRelievoResources::ShadowMaps, vtkRelievoResources::Visibility,
    vtkRelievoResources::LampShadows };
  description.ServesWhenOff = true;
  description.AddChoice(
    "method", this->Method, [this](int method) { this->SetMethod(method); },
    { "map", "forward", "warped", "exact" },
    "How shadows are computed. Map, for most scenes: a depth map seen from the light. Warped, for "
    "landscapes: more of a sun's map near the camera. Forward, to compare methods: the map's "
    "samples in the picture's own pixels; slow. Exact, to measure and to print: a ray from each "
    "pixel through the meshes' triangles; slower than a map.");
  description
    .AddWhole(
      "map_size", this->MapSize, [this](int size) { this->SetMapSize(size); }, 16, 16384, "texels",
      "Width and height of each light's map. Twice the size halves the error at edges and takes "
      "four times the memory.")
    .Advanced = true;
  description
    .AddWhole(
      "filter_radius", this->FilterRadius, [this](int radius) { this->SetFilterRadius(radius); }, 0,
      16, "texels", "How far edges are smoothed over texels of the map.")
    .Advanced = true;
  description
    .AddNumber(
      "bias", this->Bias, [this](double bias) { this->SetBias(bias); }, 0.0, 100.0, "texels",
      "Distance by which receivers are moved towards the light before the comparison.")
    .Advanced = true;
  description.AddNumber(
    "strength", this->Strength, [this](double strength) { this->SetStrength(strength); }, 0.0, 1.0,
    "", "Fraction of a blocked light that is removed.");
  description.AddFlag(
    "colored_shadows", this->ColoredShadows, [this](bool on) { this->SetColoredShadows(on); },
    "With exact shadows, translucent surfaces cast, and colour the light that passes them. With "
    "every method, coloured volumes colour the light.");
  description
    .AddNumber(
      "tolerance", this->Tolerance, [this](double share) { this->SetTolerance(share); }, 0.0, 1.0,
      "", "Share of wrong pixels by which method and map size are chosen; 0: as they are set.")
    .Advanced = true;
  description
    .AddNumber(
      "time_budget", this->TimeBudget, [this](double time) { this->SetTimeBudget(time); }, 0.0,
      3600000.0, "ms", "Time of a frame by which method and map size are chosen; 0: any.")
    .Advanced = true;
  description
    .AddWhole(
      "lamp_map_size", this->LampMapSize, [this](int size) { this->SetLampMapSize(size); }, 16,
      16384, "texels", "Width and height of each map of a lamp from data; a lamp has up to six.")
    .Advanced = true;
  description
    .AddWhole(
      "volume_nodes", this->VolumeNodes, [this](int nodes) { this->SetVolumeNodes(nodes); }, 16,
      1024, "nodes",
      "Largest number of nodes along an axis of the grids that store the light through volumes. A "
      "grid has a node for each voxel, up to this number.")
    .Advanced = true;
  description
    .AddWhole(
      "volume_harmonics", this->VolumeHarmonics,
      [this](int harmonics) { this->SetVolumeHarmonics(harmonics); }, 0, 31, "",
      "Harmonics of a Fourier series along each ray of light through volumes, instead of nodes: "
      "less memory, more error. 0: nodes.")
    .Advanced = true;
  this->DescribeSoft(description);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::DescribeSoft(vtkRelievoStageDescription& description)
{
  description.AddWhole(
    "soft_samples", this->SoftSamples, [this](int samples) { this->SetSoftSamples(samples); }, 0,
    4096, "samples",
    "Number of samples of each light's shape; 0: lights are points, and edges are hard.");
  description.Parameters.back().Label = "Samples";
  const auto onlyIfSoft = [&description] {
    description.Parameters.back().OnlyIf = "soft_samples!=0";
  };
  description
    .AddFlag(
      "soft_at_once", this->SoftAtOnce, [this](bool on) { this->SetSoftAtOnce(on); },
      "Whether every frame draws all samples; otherwise each frame adds one.")
    .Label = "All Samples At Once";
  description.Parameters.back().Advanced = true;
  onlyIfSoft();
  description
    .AddWhole(
      "soft_maps", this->SoftMaps, [this](int maps) { this->SetSoftMaps(maps); }, 0, 64, "maps",
      "Number of maps, of half the width, for all samples of a sun that are drawn at once, which "
      "is faster than a map for each sample; 0: a map for each.")
    .Label = "Maps for All Samples";
  description.Parameters.back().Advanced = true;
  onlyIfSoft();
  description.AddNumber(
    "sun_angle", this->SunAngle, [this](double degrees) { this->SetSunAngle(degrees); }, 0.0,
    vtkRelievoLightSizes::WidestSun, "degrees",
    "Angular diameter of suns that have no softness of their own.");
  description.Parameters.back().Label = "Softness of Suns";
  description.Parameters.back().Advanced = true;
  onlyIfSoft();
  description.AddNumber(
    "lamp_radius", this->LampRadius, [this](double radius) { this->SetLampRadius(radius); }, 0.0,
    vtkRelievoLightSizes::LargestLamp, "world units",
    "Radius of spots and point lights that have no softness of their own.");
  description.Parameters.back().Label = "Softness of Lamps";
  description.Parameters.back().Advanced = true;
  onlyIfSoft();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  const Internals& in = *this->Internal;
  // Visibility is needed only for layers, and lamps are lit by their own stage.
  declaration.OptionalWrites = { vtkRelievoResources::ShadowMaps };
  const bool together = in.Maps.Schedule.Exchange.IsOn();
  if (this->SoftSamples > 1 && !together && in.Soft.HasSized(in.Lights, context.Renderer))
  {
    declaration.Samples = this->SoftSamples;
    declaration.AtOnce = this->SoftAtOnce;
  }
  // Methods other than these depend on the visible surfaces.
  const bool ofAnyRaster = this->Tolerance == 0.0 && this->TimeBudget == 0.0 &&
    (this->Method == METHOD_MAP || this->Method == METHOD_WARPED);
  const bool follows = this->SoftMaps > 0 && this->Method == METHOD_MAP && !together &&
    !this->ColoredShadows && in.Soft.CanFollow(this->SoftSamples, in.Lights, context.Renderer);
  declaration.AnyRaster = ofAnyRaster && (declaration.Samples == 1 || follows);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Casting lights: " << this->GetNumberOfCastingLights() << "\n";
  os << indent << "Maps: " << this->GetNumberOfMaps() << "\n";
}

namespace
{
bool IsPossible(int method, const vtkRelievoShadowDemand& demand)
{
  return method >= vtkRelievoShadowStage::METHOD_MAP &&
    method <= vtkRelievoShadowStage::METHOD_EXACT &&
    std::min({ demand.MapSize - 1, demand.Maps, demand.Lights, demand.Props, demand.Width,
      demand.Height }) >= 0;
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetSunAngle(double degrees)
{
  if (!std::isfinite(degrees))
  {
    vtkErrorMacro("SetSunAngle was given " << degrees << "; give it 0 to "
                                           << vtkRelievoLightSizes::WidestSun << " degrees.");
    return;
  }
  degrees = std::min(std::max(degrees, 0.0), vtkRelievoLightSizes::WidestSun);
  if (this->SunAngle != degrees)
  {
    this->SunAngle = this->Internal->Soft.Sizes.SunAngle = degrees;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetLampRadius(double radius)
{
  if (!std::isfinite(radius))
  {
    vtkErrorMacro("SetLampRadius was given "
      << radius << "; give it 0 to " << vtkRelievoLightSizes::LargestLamp << " world units.");
    return;
  }
  radius = std::min(std::max(radius, 0.0), vtkRelievoLightSizes::LargestLamp);
  if (this->LampRadius != radius)
  {
    this->LampRadius = this->Internal->Soft.Sizes.LampRadius = radius;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetLightSize(vtkLight* light, double size)
{
  const double most = light && light->GetPositional() ? vtkRelievoLightSizes::LargestLamp
                                                      : vtkRelievoLightSizes::WidestSun;
  if (!light || !(size <= most))
  {
    vtkErrorMacro("SetLightSize was given "
      << (light ? "size " + std::to_string(size) : std::string("no light"))
      << "; give it a vtkLight, and 0 to " << most
      << (most == vtkRelievoLightSizes::WidestSun ? " degrees" : "")
      << ", or -1 for the pass's own size.");
    return;
  }
  this->Internal->Soft.Sizes.Set(light, size);
  this->Modified();
}

//------------------------------------------------------------------------------
double vtkRelievoShadowStage::GetLightSize(vtkLight* light)
{
  return light ? this->Internal->Soft.Sizes.Get(light) : 0.0;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetLightEdges(
  vtkLight* light, const double first[3], const double second[3])
{
  bool finite = light && light->GetPositional();
  for (int i = 0; i < 3 && finite; ++i)
  {
    finite = std::isfinite(first[i]) && std::isfinite(second[i]);
  }
  if (!finite)
  {
    vtkErrorMacro("SetLightEdges was given "
      << (!light                      ? "no light"
             : light->GetPositional() ? "edges that are not finite"
                                      : "a directional light")
      << "; give it a positional vtkLight and two edges in world units.");
    return;
  }
  this->Internal->Soft.Sizes.SetEdges(
    light, glm::dvec3(first[0], first[1], first[2]), glm::dvec3(second[0], second[1], second[2]));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetTolerance(double share)
{
  if (!(share >= 0.0 && share <= 1.0))
  {
    vtkErrorMacro("SetTolerance was given " << share << "; give it the tolerable share of wrong "
                                            << "pixels, from 0 (no goal) to 1; 0.05 % is "
                                            << "0.0005.");
    return;
  }
  if (this->Tolerance != share)
  {
    this->Tolerance = share;
    this->Internal->Maps.Planning.ForgetRoom(Internals::GetSettings(*this));
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetTimeBudget(double milliseconds)
{
  if (!(milliseconds >= 0.0 && std::isfinite(milliseconds)))
  {
    vtkErrorMacro("SetTimeBudget was given " << milliseconds << "; give it the milliseconds that a "
                                             << "frame may take, or 0 for any.");
    return;
  }
  if (this->TimeBudget != milliseconds)
  {
    this->TimeBudget = milliseconds;
    this->Internal->Maps.Planning.ForgetRoom(Internals::GetSettings(*this));
    this->Internal->Maps.Planning.ForgetTimes();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkRelievoShadowStage::EstimateWrongShareInView(int method, int size)
{
  Internals& in = *this->Internal;
  const double law = this->EstimateWrongShare(method, size);
  if (law < 0.0)
  {
    return law;
  }
  if (in.Lights.GetCasting().empty() || !in.Renderer)
  {
    vtkErrorMacro("EstimateWrongShareInView: the last frame made no shadows of lights. Switch them "
                  "on, add a light that casts, and render first.");
    return -1.0;
  }
  const vtkRelievoLightMaps::Settings settings = Internals::GetSettings(*this);
  const vtkRelievoShadowPlanning::Scene scene = in.Maps.GetScene(in.Lights);
  in.Maps.Planning.UpdateProbe(scene, settings, in.Renderer);
  return in.Maps.Planning.GetShareInView(scene, settings, method, size);
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowStage::GetPlan()
{
  return this->Internal->Maps.Planning.IsPlanned() ? this->Internal->Maps.Planning.Get().Words
                                                   : std::string();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetMethodUsed()
{
  return this->Internal->Maps.GetMethodMade();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetMapSizeUsed()
{
  return this->Internal->Maps.Work.Maps.GetSize();
}

//------------------------------------------------------------------------------
double vtkRelievoShadowStage::GetExpectedMilliseconds()
{
  return this->Internal->Maps.Planning.IsPlanned()
    ? this->Internal->Maps.Planning.Get().Milliseconds
    : -1.0;
}

//------------------------------------------------------------------------------
double vtkRelievoShadowStage::GetMillisecondsTaken()
{
  return this->Internal->Maps.Planning.IsPlanned()
    ? this->Internal->Maps.Planning.GetMillisecondsTaken()
    : -1.0;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoShadowStage::EstimateBytes(
  int method, int size, int maps, int lights, int width, int height)
{
  vtkRelievoShadowDemand demand;
  demand.MapSize = size;
  demand.Maps = maps;
  demand.Lights = lights;
  demand.Width = width;
  demand.Height = height;
  if (!IsPossible(method, demand))
  {
    vtkErrorMacro("EstimateBytes was given method "
      << method << ", size " << size << ", " << maps << " maps, " << lights << " lights, " << width
      << " x " << height
      << " pixels; give it a method from 0 (map) to 3 (exact), a size from 1 on, "
      << "and no negative numbers.");
    return -1;
  }
  return vtkRelievoShadowMethod::Make(method)->Estimate(demand).Bytes;
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::EstimateDrawCalls(int method, int maps, int props)
{
  vtkRelievoShadowDemand demand;
  demand.Maps = maps;
  demand.Props = props;
  if (!IsPossible(method, demand))
  {
    vtkErrorMacro("EstimateDrawCalls was given method "
      << method << ", " << maps << " maps and " << props << " props; give it a method from 0 (map) "
      << "to 3 (exact), and no negative numbers.");
    return -1;
  }
  return vtkRelievoShadowMethod::Make(method)->Estimate(demand).DrawCalls;
}

//------------------------------------------------------------------------------
double vtkRelievoShadowStage::EstimateWrongShare(int method, int size)
{
  vtkRelievoShadowDemand demand;
  demand.MapSize = size;
  if (!IsPossible(method, demand))
  {
    vtkErrorMacro("EstimateWrongShare was given method "
      << method << " and size " << size << "; give it a method from 0 (map) to 3 (exact), and a "
      << "size from 1 on.");
    return -1.0;
  }
  return vtkRelievoShadowMethod::Make(method)->Estimate(demand).WrongShare;
}

//------------------------------------------------------------------------------
std::map<std::string, vtkVariant> vtkRelievoShadowStage::GetFacts()
{
  const Internals& in = *this->Internal;
  const vtkRelievoShadowPlanning& planning = in.Maps.Planning;
  const vtkRelievoShadowContext& lamps = in.Lamps.Work;
  const bool ran = this->GetReasonCode() == "ran" && !in.Lights.GetCasting().empty();
  const vtkRelievoVolumeShade& volumes = in.Maps.Work.Shade;
  return { { "expected_wrong_share",
             ran ? vtkVariant(in.Maps.GetExpectedWrongShare()) : vtkVariant() },
    { "volume_nodes", vtkVariant(ran ? volumes.GetNodesMade() : 0) },
    { "volume_wrong_share",
      ran && volumes.GetExpectedWrongShare() >= 0.0 ? vtkVariant(volumes.GetExpectedWrongShare())
                                                    : vtkVariant() },
    { "volume_bytes", vtkVariant(static_cast<long long>(volumes.GetBytes())) },
    { "soft_samples", vtkVariant(ran ? in.Soft.GetSamples() : 1) },
    { "soft_gathered", vtkVariant(ran ? in.Soft.GetGathered() : 1) },
    { "shadow_plan", planning.IsPlanned() ? vtkVariant(planning.Get().Words) : vtkVariant() },
    { "expected_frame_ms",
      planning.IsPlanned() ? vtkVariant(planning.Get().Milliseconds) : vtkVariant() },
    { "frame_ms",
      planning.IsPlanned() && planning.GetMillisecondsTaken() >= 0.0
        ? vtkVariant(planning.GetMillisecondsTaken())
        : vtkVariant() },
    { "lamp_maps", vtkVariant(lamps.Cache.GetNumberOfMaps()) },
    { "lamp_maps_drawn", vtkVariant(lamps.MapsDrawn) },
    { "lamp_maps_bytes", vtkVariant(static_cast<long long>(lamps.Maps.GetBytes())) } };
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowStage::IsSplicing() const
{
  return this->Internal->Spliced;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::MarkShaders(const vtkRelievoShaderTexts& shaders)
{
  vtkRelievoShadowSplice::Mark(shaders.Vertex, shaders.Geometry, shaders.Fragment);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SpliceShaders(
  const vtkRelievoShaderTexts& shaders, vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  Internals& in = *this->Internal;
  const vtkRelievoTrialSplice::Outcome outcome = TrySplice(shaders, in.Window, actor, [&]() {
    return vtkRelievoShadowSplice::Fill(
      shaders.Vertex, shaders.Geometry, shaders.Fragment, mapper, actor, in.Maps.Work.Structure);
  });
  // Gaussian splats cast and do not receive by design: a user cannot change that.
  const bool known = mapper->IsA("vtkOpenGLPointGaussianMapperHelper") != 0;
  if (!known && this->IsNews(mapper, outcome))
  {
    vtkErrorMacro(
      "No shadows on surfaces drawn by " << mapper->GetClassName() << ": " << outcome.Error << ".");
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowStage::Internals::IsDrawingMaps(vtkShaderProgram* program)
{
  if (this->Maps.Work.DrawingMaps)
  {
    this->Maps.Schedule.AddProgram(program);
  }
  if (this->Lamps.Work.DrawingMaps)
  {
    this->Lamps.Schedule.AddProgram(program);
  }
  return this->Maps.Work.DrawingMaps || this->Lamps.Work.DrawingMaps;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowStage::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* abstractMapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!in.Spliced || !actor)
  {
    return true;
  }
  if (auto* mapper = vtkOpenGLPolyDataMapper::SafeDownCast(abstractMapper))
  {
    in.Casters.PlainDraw.Learn(mapper);
  }
  const bool drawingMaps = in.IsDrawingMaps(program);
  this->DrawCalls += drawingMaps || in.Maps.Work.DrawingDepth ? 1 : 0;
  if (drawingMaps)
  {
    // A sheet blocks light from both sides.
    vtkRelievoShadowMaps::DrawBothSides(in.Window);
  }
  if (program->IsUniformUsed("relievoFromLight"))
  {
    // Masks are of the mesh, too: vtkRelievoCasterDraw draws most surfaces, without their relief.
    program->SetUniformi("relievoFromLight", drawingMaps ? 1 : in.Maps.Work.DrawingDepth ? -1 : 0);
  }
  if (!program->IsUniformUsed("relievoShadowMaps") &&
    !program->IsUniformUsed("relievoSeenVerdicts"))
  {
    return true;
  }
  if (vtkRelievoIsProjective(actor->GetMatrix()))
  {
    in.Messages.Warn("projective",
      "An actor's matrix is projective: its last row is not 0 0 0 1. VTK lights it "
      "elsewhere than it draws it, and shadows on it are of there; those that it casts "
      "are right. Move its points instead, with vtkTransformFilter");
  }
  in.Uniforms.Set(
    program, in.Maps.Work, *in.Maps.GetMethod(), this->Enabled ? this->Strength : 0.0, actor);
  return true;
}

//------------------------------------------------------------------------------
vtkRelievoShadowCertificate* vtkRelievoShadowStage::Certify(int rays, int seed)
{
  Internals& in = *this->Internal;
  in.Certificate = nullptr;
  if (rays <= 0)
  {
    vtkErrorMacro("Certify was given " << rays << " rays; give it 1 or more. 6000 without an error "
                                       << "prove a share of wrong verdicts below 0.05 %.");
    return nullptr;
  }
  if (this->SoftSamples > 1 && !in.Maps.Schedule.Exchange.IsOn())
  {
    vtkErrorMacro("Certify judges verdicts of lights that are points, and SoftSamples is "
      << this->SoftSamples << "; set it to 0 and render first.");
    return nullptr;
  }
  vtkRenderer* const renderer = in.Renderer;
  vtkRelievoFramePass* const frame = in.Frame;
  if (!frame || !renderer || !renderer->GetRenderWindow() || in.Lights.GetCasting().empty())
  {
    vtkErrorMacro("Certify has no picture: the last frame made no shadows of lights. Switch them "
                  "on, add a light that casts, and render first.");
    return nullptr;
  }
  std::string fault;
  in.Certificate = vtkRelievoShadowCertifier::CertifyPicture(
    { frame, renderer, in.Maps.Work, in.Lights, in.Maps.GetMethod() }, rays, seed, fault);
  if (!fault.empty())
  {
    vtkErrorMacro("Certify could not judge the picture: " << fault << ".");
  }
  return in.Certificate;
}
