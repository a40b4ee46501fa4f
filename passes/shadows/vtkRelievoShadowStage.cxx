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
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePass.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoLampMaps.h"
#include "vtkRelievoLightSamples.h"
#include "vtkRelievoMeshTexels.h"
#include "vtkRelievoPlainActor.h"
#include "vtkRelievoSampleLattice.h"
#include "vtkRelievoShadowCertificate.h"
#include "vtkRelievoShadowCertifier.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowLights.h"
#include "vtkRelievoShadowMethod.h"
#include "vtkRelievoShadowMethodExact.h"
#include "vtkRelievoShadowPlanning.h"
#include "vtkRelievoShadowSchedule.h"
#include "vtkRelievoShadowStrengths.h"
#include "vtkRelievoShadowUniforms.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{
// Samples of soft lights and suns that share a few maps.
constexpr int MostFollowed = 64;
constexpr int MostFollowedSuns = 4;
}

class vtkRelievoShadowStage::Internals
{
public:
  vtkRelievoShadowLights Lights;
  vtkRelievoLightSizes Sizes; // of lights
  int Samples = 1;            // of the lights, in this frame
  int Gathered = 0;
  vtkRelievoShadowCasters Casters; // of all maps
  vtkRelievoShadowContext Work{ Casters };
  vtkRelievoShadowSchedule Schedule;
  vtkRelievoLampMaps Lamps{ Casters }; // from data
  vtkRelievoShadowPlanning Planning;
  std::unique_ptr<vtkRelievoShadowMethod> Method = vtkRelievoShadowMethod::Make(METHOD_MAP);
  int MethodMade = METHOD_MAP;
  int MethodRefused = -1; // method that could not make shadows of the casters
  std::vector<std::uint64_t> Refused;
  bool LayersAsked = false;                     // visibility is requested as a layer
  bool LampsAsked = false;                      // and for lamps from data
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // of the frame
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkRelievoFramePass> Frame;
  vtkSmartPointer<vtkRelievoShadowCertificate> Certificate;
  std::set<vtkShaderProgram*> ProgramsWithUniforms; // programs with this frame's uniforms
  std::set<std::string> Reported;                   // warnings and errors
  vtkRelievoShadowStrengths Strengths;              // of this frame's lights
  bool Spliced = false;

  // Creates the method if it differs from the previous frame's. The context is current.
  void UseMethod(int method, vtkOpenGLRenderWindow* window);

  // The input of the plan.
  static vtkRelievoShadowPlanning::Settings GetSettings(const vtkRelievoShadowStage& self)
  {
    return { self.Method, self.MapSize, self.Tolerance, self.TimeBudget, self.Bias,
      self.FilterRadius, self.ColoredShadows };
  }
  vtkRelievoShadowPlanning::Scene GetScene()
  {
    return { this->Work, this->Lights, this->Schedule.Exchange.IsOn(),
      this->MethodRefused == METHOD_EXACT && this->Work.Props.GetState() == this->Refused };
  }

  // While a map is being drawn: records the program that draws into it.
  bool IsDrawingMaps(vtkShaderProgram* program);

  // Whether shaders must differ from the previous frame's.
  bool UpdateStructure();
};

vtkStandardNewMacro(vtkRelievoShadowStage);

//------------------------------------------------------------------------------
vtkRelievoShadowStage::vtkRelievoShadowStage()
  : Internal(new Internals)
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
  return renderer ? this->Internal->Lights.GetLayers(renderer) : std::vector<std::string>();
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
  this->Internal->Work.Props.GetChoice(prop).Casts = casts;
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetPropCasts(vtkProp* prop)
{
  return this->Internal->Work.Props.GetChoice(prop).Casts;
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
  this->Internal->Work.Props.GetChoice(prop).Receives = receives;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowStage::GetPropReceives(vtkProp* prop)
{
  return this->Internal->Work.Props.GetChoice(prop).Receives;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetController(vtkMultiProcessController* controller)
{
  if (this->GetController() != controller)
  {
    this->Internal->Schedule.Exchange.SetController(controller);
    this->Internal->Lamps.Schedule.Exchange.SetController(controller);
    this->Internal->Work.Others.SetController(controller);
    this->Internal->Lamps.Work.Cache.Clear();
    this->Internal->Work.Cache.Clear(); // maps of this process alone, or of a former group
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkRelievoShadowStage::GetController()
{
  return this->Internal->Schedule.Exchange.GetController();
}

//------------------------------------------------------------------------------
double vtkRelievoShadowStage::GetMergeSeconds()
{
  return this->Internal->Schedule.Exchange.GetSeconds();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetNumberOfCastingLights()
{
  return static_cast<int>(this->Internal->Lights.GetCasting().size());
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetNumberOfMaps()
{
  return this->Internal->Work.Cache.GetNumberOfMaps();
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowStage::Prepare(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Planning.Begin(context.Picture);
  vtkRelievoAccess::Renderer::FollowCamera(context.Renderer);
  // VTK counts lights here, and builds the maps' shaders for them.
  static_cast<vtkOpenGLRenderer*>(context.Renderer)->UpdateLights();
  in.LayersAsked = context.IsAsked(this, "visibility");
  in.LampsAsked = context.IsAsked(this, "lamp shadows");
  const bool lights = in.LayersAsked || context.IsAsked(this, "shadow maps");
  lights ? this->CollectLights(context) : in.Lights.Clear();
  if (in.Lights.GetCasting().empty() && !in.LampsAsked)
  {
    in.Planning.SetNone();
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
  in.Work.SteadyView = context.SteadyView;
  in.Work.Props.SetAttenuates(this->ColoredShadows);
  in.Work.Props.Collect(context.Renderer, context.Scene.Props);
  const bool traces =
    this->Method == METHOD_EXACT || this->Tolerance > 0.0 || this->TimeBudget > 0.0;
  // Another process may have translucent props.
  context.ColorsLight = this->Enabled && this->ColoredShadows && traces &&
    !in.Lights.GetCasting().empty() &&
    (in.Work.Others.IsOn() || in.Work.Props.HasTranslucentCasters());
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkRelievoShadowContext& work = in.Work;
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
    if (!in.Planning.IsPlanned() && !in.Method->Traces())
    {
      work.Props.ForgetGlyphs();
    }
  }
  else
  {
    in.Planning.SetNone();
    in.UseMethod(METHOD_MAP, context.Window);
    work.WithoutFollowed = false;
    work.Maps.Release(context.Window);
    work.Cache.Clear();
    work.Others.Clear();
  }
  // Processes that draw together fit their maps together, even if there are none.
  const bool lamps =
    in.LampsAsked && (!context.CastingLamps.empty() || in.Lamps.Schedule.Exchange.IsOn());
  std::vector<std::string> words;
  if (!fault.empty())
  {
    this->ReportOnce("No shadows: " + fault);
    words.push_back(fault);
    work.Cache.Clear();
    in.Method->Unbind(); // releases resources reserved in Prepare
  }
  if (in.UpdateStructure())
  {
    this->ModifyShaders();
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
  work.Props.AddPass(this);
  in.ProgramsWithUniforms.clear();
  if (lights && fault.empty())
  {
    this->DrawLights(context);
    words.push_back(this->DescribeMaps());
  }
  if (lamps)
  {
    words.push_back(this->DrawLamps(context));
  }
  in.ProgramsWithUniforms.clear();
  std::string all;
  for (const std::string& each : words)
  {
    all += (all.empty() ? "" : "; ") + each;
  }
  this->Explain("ran", all);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::ReportOnce(const std::string& error)
{
  if (this->Internal->Reported.insert(error).second)
  {
    vtkErrorMacro(<< error << ".");
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::Finish(vtkRelievoFrameContext& context)
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
      // Some mappers mark themselves as modified when they draw.
      const bool probed = in.Planning.GetProbe().HasScene(in.Work.Props);
      in.Work.Props.Collect(context.Renderer, context.Scene.Props);
      in.Work.Cache.SetCasters(in.Work.Props, in.Work.WithoutFollowed);
      in.Lamps.Work.Cache.SetCasters(in.Work.Props, false);
      in.Method->Settle(in.Work);
      if (probed)
      {
        in.Planning.GetProbe().Settle(in.Work.Props);
      }
    }
  }
  if (context.Window->GetAbortRender())
  {
    // Mappers skip drawing from there on: maps and masks are incomplete.
    in.Work.Cache.Invalidate();
    in.Lamps.Work.Cache.Invalidate();
    in.Method->Forget();
    in.Planning.ForgetView();
  }
  else
  {
    // The time of an aborted frame is meaningless.
    in.Planning.End(
      in.GetScene(), context.Picture, this->NumberOfMapsDrawn > 0, this->GetShaderTime());
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoShadowStage::GetBytesHeld()
{
  return this->Internal->Work.Maps.GetBytes() + this->Internal->Method->GetBytes() +
    this->Internal->Lamps.Work.Maps.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Work.Maps.Release(window);
  this->Internal->Method->Release(window);
  this->Internal->Lamps.Release(window);
  this->Internal->Work.PlainDraw.Release(window);
  this->Internal->Work.Props.ForgetGlyphs();
  this->Internal->Work.Cache.Clear();
  this->Internal->Lights.Clear();
  this->Internal->MethodRefused = -1; // another window's OpenGL may have enough memory
  this->Internal->Planning.ForgetRoom({});
  this->NumberOfMapsDrawn = 0;
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::Internals::UseMethod(int method, vtkOpenGLRenderWindow* window)
{
  if (method == this->MethodMade)
  {
    return;
  }
  this->Method = vtkRelievoShadowMethod::Make(method);
  this->MethodMade = method;
  this->Work.Cache.Refit();
  window->MakeCurrent(); // earlier resources may belong to another window
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowStage::Internals::UpdateStructure()
{
  vtkRelievoShadowSplice::Structure structure;
  structure.Method = this->Method->GetShader();
  structure.Traced = this->Method->Traces();
  structure.Colored = this->Method->Colors();
  structure.Maps = !structure.Traced || this->Work.Cache.GetNumberOfMaps() > 0;
  structure.Numbers = static_cast<int>(this->Lights.GetAll().size());
  structure.Unlit = this->LayersAsked;
  structure.WideFilter = this->Work.Radius > 1;
  structure.Parts = 0;
  for (const auto& entry : this->Work.Cache.GetEntries())
  {
    const int parts = static_cast<int>(entry.Light.Parts.size());
    const int maps = static_cast<int>(entry.Light.Centers.size());
    structure.Lights.push_back(
      { entry.Light.ShaderIndex, !entry.Light.Positional, entry.Cube, maps });
    structure.Parts = std::max(structure.Parts, parts);
  }
  for (vtkActor* actor : this->Method->GetFound(structure.Lights.size()))
  {
    structure.Found.emplace_back(actor, actor->GetMapper());
  }
  const bool changed = !(structure == this->Work.Structure);
  if (changed)
  {
    this->Work.Structure = structure;
  }
  return changed;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowStage::Internals::IsDrawingMaps(vtkShaderProgram* program)
{
  if (this->Work.DrawingMaps)
  {
    this->Schedule.AddProgram(program);
  }
  if (this->Lamps.Work.DrawingMaps)
  {
    this->Lamps.Schedule.AddProgram(program);
  }
  return this->Work.DrawingMaps || this->Lamps.Work.DrawingMaps;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "shadows";
  description.Help = "Shadows of lights (suns, spots and points) and of lamps from data.";
  description.Slot = vtkRelievoStageDescription::LIGHT_MAPS;
  description.Writes = { "shadow maps", "visibility", "lamp shadows" };
  description.ServesWhenOff = true;
  description.AddChoice(
    "method", this->Method, [this](int method) { this->SetMethod(method); },
    { "map", "forward", "warped", "exact" },
    "How shadows are computed: by a depth map seen from the light (map), with more of a sun's map "
    "near the camera, for landscapes (warped), in the camera's view (forward), or by a ray from "
    "each pixel past the meshes' own triangles, which is slower (exact).");
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
  description
    .AddFlag(
      "colored_shadows", this->ColoredShadows, [this](bool on) { this->SetColoredShadows(on); },
      "Exact shadows: translucent surfaces cast, and colour the light that passes them.")
    .OnlyIf = "method=exact";
  description
    .AddNumber(
      "tolerance", this->Tolerance, [this](double share) { this->SetTolerance(share); }, 0.0, 1.0,
      "", "Share of wrong pixels that method and map size are chosen for; 0: as they are set.")
    .Advanced = true;
  description
    .AddNumber(
      "time_budget", this->TimeBudget, [this](double time) { this->SetTimeBudget(time); }, 0.0,
      3600000.0, "ms", "Time of a frame that method and map size are chosen for; 0: any.")
    .Advanced = true;
  description
    .AddWhole(
      "lamp_map_size", this->LampMapSize, [this](int size) { this->SetLampMapSize(size); }, 16,
      16384, "texels", "Width and height of each map of a lamp from data; a lamp has up to six.")
    .Advanced = true;
  this->DescribeSoft(description);
}

//------------------------------------------------------------------------------
// Whether the samples of all soft lights can share a few maps.
bool vtkRelievoShadowStage::FollowsSuns(vtkRenderer* renderer) const
{
  const Internals& in = *this->Internal;
  return this->SoftMaps > 0 && this->SoftSamples <= MostFollowed && this->Method == METHOD_MAP &&
    !in.Schedule.Exchange.IsOn() && !this->ColoredShadows &&
    in.Lights.CountSized(renderer, in.Sizes, true) == 0 &&
    in.Lights.CountSized(renderer, in.Sizes, false) <= MostFollowedSuns;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  // Visibility is needed only for layers, and lamps are lit by their own stage.
  declaration.OptionalWrites = { "shadow maps" };
  this->DeclareSoft(context, declaration);
  // Methods other than these depend on the visible surfaces.
  const bool ofAnyRaster = this->Tolerance == 0.0 && this->TimeBudget == 0.0 &&
    (this->Method == METHOD_MAP || this->Method == METHOD_WARPED);
  declaration.AnyRaster =
    ofAnyRaster && (declaration.Samples == 1 || this->FollowsSuns(context.Renderer));
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
constexpr int MostSamples = 4096;
constexpr double WidestSun = 90.0;
constexpr double LargestLamp = 1e9;

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
    vtkErrorMacro(
      "SetSunAngle was given " << degrees << "; give it 0 to " << WidestSun << " degrees.");
    return;
  }
  degrees = std::min(std::max(degrees, 0.0), WidestSun);
  if (this->SunAngle != degrees)
  {
    this->SunAngle = this->Internal->Sizes.SunAngle = degrees;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetLampRadius(double radius)
{
  if (!std::isfinite(radius))
  {
    vtkErrorMacro(
      "SetLampRadius was given " << radius << "; give it 0 to " << LargestLamp << " world units.");
    return;
  }
  radius = std::min(std::max(radius, 0.0), LargestLamp);
  if (this->LampRadius != radius)
  {
    this->LampRadius = this->Internal->Sizes.LampRadius = radius;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::SetLightSize(vtkLight* light, double size)
{
  const double most = light && light->GetPositional() ? LargestLamp : WidestSun;
  if (!light || !(size <= most))
  {
    vtkErrorMacro("SetLightSize was given "
      << (light ? "size " + std::to_string(size) : std::string("no light"))
      << "; give it a vtkLight, and 0 to " << most << (most == WidestSun ? " degrees" : "")
      << ", or -1 for the pass's own size.");
    return;
  }
  this->Internal->Sizes.Set(light, size);
  this->Modified();
}

//------------------------------------------------------------------------------
double vtkRelievoShadowStage::GetLightSize(vtkLight* light)
{
  return light ? this->Internal->Sizes.Get(light) : 0.0;
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
  this->Internal->Sizes.SetEdges(
    light, glm::dvec3(first[0], first[1], first[2]), glm::dvec3(second[0], second[1], second[2]));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::DescribeSoft(vtkRelievoStageDescription& description)
{
  description.AddWhole(
    "soft_samples", this->SoftSamples, [this](int samples) { this->SetSoftSamples(samples); }, 0,
    MostSamples, "samples",
    "Samples of each light's size that are gathered; 0: lights are points, and edges are hard.");
  description.Parameters.back().Label = "Samples";
  const auto onlyIfSoft = [&description] {
    description.Parameters.back().OnlyIf = "soft_samples!=0";
  };
  description
    .AddFlag(
      "soft_at_once", this->SoftAtOnce, [this](bool on) { this->SetSoftAtOnce(on); },
      "Whether every frame gathers all samples; otherwise one in each frame.")
    .Label = "All Samples At Once";
  description.Parameters.back().Advanced = true;
  onlyIfSoft();
  description
    .AddWhole(
      "soft_maps", this->SoftMaps, [this](int maps) { this->SetSoftMaps(maps); }, 0, 64, "maps",
      "Maps, of half the width, in which all samples of a sun are looked up where they are drawn "
      "at once, which is faster than a map for each; 0: a map for each.")
    .Label = "Maps for All Samples";
  description.Parameters.back().Advanced = true;
  onlyIfSoft();
  description.AddNumber(
    "sun_angle", this->SunAngle, [this](double degrees) { this->SetSunAngle(degrees); }, 0.0,
    WidestSun, "degrees", "Angle that suns appear under which have no softness of their own.");
  description.Parameters.back().Label = "Softness of Suns";
  description.Parameters.back().Advanced = true;
  onlyIfSoft();
  description.AddNumber(
    "lamp_radius", this->LampRadius, [this](double radius) { this->SetLampRadius(radius); }, 0.0,
    LargestLamp, "world units",
    "Radius of spots and point lights that have no softness of their own.");
  description.Parameters.back().Label = "Softness of Lamps";
  description.Parameters.back().Advanced = true;
  onlyIfSoft();
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::DeclareSoft(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  const Internals& in = *this->Internal;
  if (this->SoftSamples > 1 && !in.Schedule.Exchange.IsOn() &&
    in.Lights.CountSized(context.Renderer, in.Sizes, true) +
        in.Lights.CountSized(context.Renderer, in.Sizes, false) >
      0)
  {
    declaration.Samples = this->SoftSamples;
    declaration.AtOnce = this->SoftAtOnce;
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowStage::DescribeSamples() const
{
  const Internals& in = *this->Internal;
  if (this->SoftSamples <= 1)
  {
    return {};
  }
  return in.Work.PartStep != glm::vec2(0.f)
    ? ", " + std::to_string(in.Samples) + " parts of each sun are traced through its maps"
    : in.Samples > 1 ? ", " + std::to_string(in.Gathered) + " of " + std::to_string(in.Samples) +
      " samples of the lights' shapes gathered"
    : in.Schedule.Exchange.IsOn()
    ? ", lights are points: several processes draw together"
    : ", lights are points: none has a size, or there is no linear colour here";
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
    this->Internal->Planning.ForgetRoom(Internals::GetSettings(*this));
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
    this->Internal->Planning.ForgetRoom(Internals::GetSettings(*this));
    this->Internal->Planning.ForgetTimes();
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
  in.Planning.UpdateProbe(in.GetScene(), Internals::GetSettings(*this), in.Renderer);
  return in.Planning.GetShareInView(in.GetScene(), Internals::GetSettings(*this), method, size);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::PrepareMethod(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const int method = in.Planning.Get().Chosen.Method;
  bool refused = method == in.MethodRefused && in.Work.Props.GetState() == in.Refused;
  const bool together = in.Schedule.Exchange.IsOn();
  if (together && (refused || method != METHOD_EXACT))
  {
    const bool again = in.Work.Others.Decline(refused && method == METHOD_EXACT);
    refused = refused && !again;
  }
  in.UseMethod(refused ? METHOD_MAP : method, context.Window);
  in.Work.WithoutFollowed = false;
  in.Work.OwnSteps = context.OwnSteps;
  const std::string fault = in.Method->Prepare(in.Work, context.Renderer);
  if (fault.empty() && !refused && method == in.MethodRefused)
  {
    in.MethodRefused = -1; // the new setting may work
  }
  else if (method == in.MethodRefused && !refused)
  {
    in.MethodRefused = -1; // a refused request may fit now
  }
  if (!fault.empty())
  {
    in.MethodRefused = in.Work.Others.IsDeclined() ? -1 : method;
    in.Refused = in.Work.Props.GetState();
    in.UseMethod(METHOD_MAP, context.Window);
    // Only one process reports.
    if ((!together || in.Schedule.Exchange.IsRoot()) && in.Reported.insert(fault).second)
    {
      vtkWarningMacro("Shadows are made with maps: " << fault << ".");
    }
  }
  const vtkIdType triangles =
    in.Work.WithoutFollowed ? in.Work.Props.GetTooManyTriangles() : vtkIdType(0);
  if (triangles > 0 && in.Reported.insert("triangles").second)
  {
    vtkWarningMacro("A mesh of " << triangles << " triangles casts its shadow by a map: rays "
                                 << "follow at most " << vtkRelievoMeshTexels::GetMostTriangles()
                                 << " of a mesh. Split it into several.");
  }
}

//------------------------------------------------------------------------------
// Choices without enough OpenGL memory are recorded, and the plan chooses among the others.
std::string vtkRelievoShadowStage::MakeMaps(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Planning.FindMoves(in.GetScene(), context.SteadyView);
  for (;;)
  {
    in.Planning.Make(in.GetScene(), Internals::GetSettings(*this), context);
    this->PrepareMethod(context);
    const vtkRelievoShadowPlanner::Choice& chosen = in.Planning.Get().Chosen;
    const bool planned = in.Planning.IsPlanned() && in.Planning.Get().Milliseconds > 0.0;
    if (planned && chosen.Method == METHOD_EXACT && in.MethodMade != METHOD_EXACT)
    {
      continue;
    }
    const std::vector<vtkRelievoShadowLight>& casting = in.Lights.GetCasting();
    const bool followed = std::any_of(casting.begin(), casting.end(),
      [](const vtkRelievoShadowLight& light) { return !light.Parts.empty(); });
    const int all = chosen.Size > 0 ? chosen.Size : this->MapSize;
    const int size = followed ? std::max(16, all / 2) : all;
    std::string fault = in.Schedule.Fit(
      in.Work, casting, *in.Method, this->GetSizeHere(size), this->FilterRadius, context.Renderer);
    if (fault.empty() || !planned)
    {
      in.Planning.SetMade(fault.empty() && in.MethodMade == chosen.Method);
      return fault;
    }
    if (chosen.Method == METHOD_EXACT)
    {
      in.MethodRefused = METHOD_EXACT;
      in.Refused = in.Work.Props.GetState();
      continue;
    }
    in.Planning.RefuseRoom(size);
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowStage::GetPlan()
{
  return this->Internal->Planning.IsPlanned() ? this->Internal->Planning.Get().Words
                                              : std::string();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetMethodUsed()
{
  return this->Internal->MethodMade;
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetMapSizeUsed()
{
  return this->Internal->Work.Maps.GetSize();
}

//------------------------------------------------------------------------------
double vtkRelievoShadowStage::GetExpectedMilliseconds()
{
  return this->Internal->Planning.IsPlanned() ? this->Internal->Planning.Get().Milliseconds : -1.0;
}

//------------------------------------------------------------------------------
double vtkRelievoShadowStage::GetMillisecondsTaken()
{
  return this->Internal->Planning.IsPlanned() ? this->Internal->Planning.GetMillisecondsTaken()
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
double vtkRelievoShadowStage::GetExpectedWrongShare() const
{
  if (this->Internal->Planning.IsPlanned() &&
    this->Internal->Planning.Get().Chosen.Method == this->Internal->MethodMade)
  {
    return this->Internal->Planning.Get().Chosen.WrongShare;
  }
  vtkRelievoShadowDemand demand;
  demand.MapSize = this->Internal->Work.Maps.GetSize();
  return this->Internal->Method->Estimate(demand).WrongShare;
}

//------------------------------------------------------------------------------
std::map<std::string, vtkVariant> vtkRelievoShadowStage::GetFacts()
{
  const Internals& in = *this->Internal;
  const vtkRelievoShadowPlanning& planning = in.Planning;
  const vtkRelievoShadowContext& lamps = in.Lamps.Work;
  const bool ran = this->GetReasonCode() == "ran" && !in.Lights.GetCasting().empty();
  return { { "expected_wrong_share",
             ran ? vtkVariant(this->GetExpectedWrongShare()) : vtkVariant() },
    { "soft_samples", vtkVariant(ran ? in.Samples : 1) },
    { "soft_gathered", vtkVariant(ran ? in.Gathered : 1) },
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
void vtkRelievoShadowStage::CollectLights(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Lights.Collect(context.Renderer, vtkRelievoShadowMaps::GetMostFaces());
  if (in.Schedule.Exchange.IsOn())
  {
    in.Lights.KeepOnly(in.Schedule.Exchange.FindCommon(in.Lights.GetNumbers()));
  }
  const bool soft = this->SoftSamples > 1;
  in.Samples = soft ? context.Samples : 1;
  in.Gathered = soft ? context.Sample + 1 : 1;
  in.Work.PartStep = glm::vec2(0.f);
  if (in.Samples > 1 && context.MeanLattice)
  {
    const int lights = std::max(1, static_cast<int>(in.Lights.GetCasting().size()));
    const int parts = std::min(context.MeanLattice->GetNumberOfSamples(),
      std::max(1, vtkRelievoShadowMaps::GetMostRays() / lights));
    const bool divided =
      in.Lights.Divide(in.Sizes, parts, this->SoftMaps, vtkRelievoShadowMaps::GetMostFaces() / 2);
    in.Samples = in.Gathered = divided ? parts : 1;
    in.Work.PartStep = glm::vec2(divided ? context.MeanLattice->GetNumberStep() : glm::ivec2(0));
  }
  else if (in.Samples > 1)
  {
    in.Lights.Move(in.Sizes, context.Sample, context.Samples);
  }
  for (const vtkRelievoShadowLight& light : in.Lights.GetAll())
  {
    if (light.Broken && in.Reported.insert(std::to_string(light.Number) + light.NoShadow).second)
    {
      vtkWarningMacro(<< in.Lights.GetName(light) << " casts no shadow: " << light.NoShadow << ".");
    }
  }
}

//------------------------------------------------------------------------------
int vtkRelievoShadowStage::GetSizeHere(int size)
{
  const int largest = vtkRelievoShadowMaps::GetLargestSize();
  if (size > largest && this->Internal->Reported.insert("size" + std::to_string(size)).second)
  {
    vtkWarningMacro("Shadow maps of "
      << size << " x " << size << " texels were requested, this OpenGL makes at most " << largest
      << " x " << largest << ": these are used.");
  }
  return std::min(size, largest);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowStage::DrawLights(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkRelievoShadowContext& work = in.Work;
  const int mapDraws = in.Schedule.Draw(work, context.Renderer);
  this->NumberOfMapsDrawn = work.MapsDrawn;
  work.Maps.Bind(true);
  in.Strengths.Set(work, this->Enabled ? this->Strength : 0.0);
  context.Provide("shadow maps", &in.Strengths);
  in.ProgramsWithUniforms.clear();
  const int methodDraws = in.Method->Draw(work, context.Renderer);
  in.ProgramsWithUniforms.clear();
  this->DrawCalls += mapDraws + methodDraws; // mappers that draw by themselves have counted theirs
  if (!in.Method->GetFault().empty())
  {
    this->ReportOnce("Shadows use the maps alone: " + in.Method->GetFault());
  }
}

//------------------------------------------------------------------------------
// Returns a description of the shadows.
std::string vtkRelievoShadowStage::DrawLamps(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Lamps.Work.Bias = this->Bias;
  const std::string fault = in.Lamps.Draw(
    context, this->GetSizeHere(this->LampMapSize), this->FilterRadius, this->Strength);
  if (!fault.empty())
  {
    this->ReportOnce("No shadows of lamps: " + fault);
    in.Lamps.Release(context.Window);
    return "no shadows of lamps: " + fault;
  }
  this->DrawCalls += in.Lamps.GetDrawCalls();
  context.Provide("lamp shadows", &in.Lamps);
  return in.Lamps.GetReport();
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowStage::DescribeMaps() const
{
  const Internals& in = *this->Internal;
  const vtkRelievoShadowPlanning& planning = in.Planning;
  const auto& casting = in.Lights.GetCasting();
  std::ostringstream out;
  out << casting.size() << (casting.size() == 1 ? " light casts" : " lights cast");
  for (const vtkRelievoShadowLight& light : casting)
  {
    out << (&light == casting.data() ? " (" : ", ") << in.Lights.GetName(light);
  }
  out << "), " << in.Work.Cache.GetNumberOfMaps()
      << (in.Work.Cache.GetNumberOfMaps() == 1 ? " map of " : " maps of ") << in.Work.Maps.GetSize()
      << " x " << in.Work.Maps.GetSize() << " texels, " << this->NumberOfMapsDrawn
      << " drawn anew, expected share of wrong pixels " << std::setprecision(2)
      << 100.0 * this->GetExpectedWrongShare() << " %" << std::setprecision(6)
      << (planning.IsPlanned() ? ", " + planning.Get().Words : std::string())
      << in.Method->GetReport() << in.Work.Others.GetReport() << this->DescribeSamples()
      << in.Schedule.Exchange.GetReport() << in.Lights.GetReport();
  return out.str();
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
      shaders.Vertex, shaders.Geometry, shaders.Fragment, mapper, actor, in.Work.Structure);
  });
  // Gaussian splats cast and do not receive by design: a user cannot change that.
  const bool known = mapper->IsA("vtkOpenGLPointGaussianMapperHelper") != 0;
  if (!known && this->IsNews(mapper, outcome))
  {
    vtkErrorMacro(
      "No shadows on surfaces drawn by " << mapper->GetClassName() << ": " << outcome.Wrong << ".");
  }
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
    in.Work.PlainDraw.Learn(mapper);
  }
  const bool drawingMaps = in.IsDrawingMaps(program);
  this->DrawCalls += drawingMaps || in.Work.DrawingDepth ? 1 : 0;
  if (drawingMaps)
  {
    // A sheet blocks light from both sides.
    vtkRelievoShadowMaps::DrawBothSides(in.Window);
  }
  if (program->IsUniformUsed("relievoFromLight"))
  {
    program->SetUniformi("relievoFromLight", drawingMaps ? 1 : 0);
  }
  if (!program->IsUniformUsed("relievoShadowMaps") &&
    !program->IsUniformUsed("relievoSeenVerdicts"))
  {
    return true;
  }
  if (vtkRelievoIsProjective(actor->GetMatrix()) && in.Reported.insert("projective").second)
  {
    vtkWarningMacro(
      "An actor's matrix is projective: its last row is not 0 0 0 1. VTK lights it "
      "elsewhere than it draws it, and shadows on it are of there; those that it casts "
      "are right. Move its points instead, with vtkTransformFilter.");
  }
  if (in.ProgramsWithUniforms.insert(program).second)
  {
    // Another renderer's lights may be newer, and both may share a program in VTK's shader cache.
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
    vtkRelievoShadowUniforms::SetFrame(
      program, in.Work, *in.Method, this->Enabled ? this->Strength : 0.0);
    in.Method->SetFrameUniforms(program, in.Work);
  }
  vtkRelievoShadowUniforms::SetActor(program, in.Work, actor);
  in.Method->SetActorUniforms(program, in.Work, actor);
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
  if (this->SoftSamples > 1 && !in.Schedule.Exchange.IsOn())
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
    { frame, renderer, in.Work, in.Lights, in.Method }, rays, seed, fault);
  if (!fault.empty())
  {
    vtkErrorMacro("Certify could not draw the picture again: " << fault << ".");
  }
  return in.Certificate;
}
