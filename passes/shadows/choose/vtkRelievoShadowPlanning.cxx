// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowPlanning.h"

#include "vtkRelievoFrameContext.h"
#include "vtkRelievoProbeView.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowLights.h"
#include "vtkRelievoShadowMethodExact.h"
#include "vtkRelievoShadowMethods.h"
#include "vtkRelievoSoftwareOpenGL.h"

#include <algorithm>
#include <chrono>
#include <string>

namespace
{
const int Sizes[] = { 1024, 2048, 4096, 8192 };

// Without rays, measured shares are within this factor of the law.
constexpr double LawsFactor = 2.5;

// Maps with more bytes are not chosen.
constexpr vtkIdType MostBytes = vtkIdType(1) << 31;

double GetNow()
{
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}

double GetLaw(int method, int size)
{
  vtkRelievoShadowDemand demand;
  demand.MapSize = size;
  return vtkRelievoShadowMethod::Make(method)->Estimate(demand).WrongShare;
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPlanning::ForgetRoom(const Settings& settings)
{
  this->RoomRefused = 0.0;
  if (!settings.HasGoal())
  {
    this->Probe.Release();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPlanning::UpdateProbe(
  const Scene& scene, const Settings& settings, vtkRenderer* renderer)
{
  if (!scene.Together)
  {
    scene.Work.Bias = settings.Bias;
    scene.Work.Radius = settings.FilterRadius;
    this->Probe.Update(scene.Work, scene.Lights.GetUnmoved(),
      vtkRelievoProbeView::GetPicture(scene.Work.View, renderer));
  }
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPlanning::GetShareInView(
  const Scene& scene, const Settings& settings, int method, int size)
{
  const double law = GetLaw(method, size);
  if (method == vtkRelievoShadowMethods::EXACT)
  {
    if (scene.Together || this->Probe.HasUnfollowed())
    {
      // Casters that rays cannot trace are drawn into maps.
      return std::min(1.0, LawsFactor * GetLaw(vtkRelievoShadowMethods::MAP, settings.MapSize));
    }
    vtkRelievoShadowDemand demand;
    demand.Farness =
      vtkRelievoShadowMethodExact::GetFarness(scene.Work, this->Probe.GetRoundedReach());
    demand.EdgeShare = this->Probe.GetEdgeShare();
    demand.Height = scene.Work.View.Viewport[3];
    return vtkRelievoShadowMethod::Make(vtkRelievoShadowMethods::EXACT)
      ->Estimate(demand)
      .WrongShare;
  }
  if (scene.Together || !this->Probe.IsKnown())
  {
    return std::min(1.0, LawsFactor * law);
  }
  const double share = this->Probe.GetWrongShare(size, method == vtkRelievoShadowMethods::WARPED);
  return method == vtkRelievoShadowMethods::FORWARD
    ? std::min(1.0, share * law / GetLaw(vtkRelievoShadowMethods::MAP, size))
    : share;
}

//------------------------------------------------------------------------------
// Frames that draw only layers do not change the picture's time.
void vtkRelievoShadowPlanning::Begin(bool picture)
{
  this->Began = GetNow();
  this->Took = picture ? -1.0 : this->Took;
  this->Spent = 0.0;
}

//------------------------------------------------------------------------------
// Changes since the previous frame, for every method: maps are redrawn when casters or lights
// change; verdicts of rays also depend on the view.
void vtkRelievoShadowPlanning::FindMoves(const Scene& scene, const vtkRelievoFrameCamera& view)
{
  const glm::dmat4 seen = view.ViewToNDC * view.WorldToView;
  std::vector<double> lights;
  for (const vtkRelievoShadowLight& light : scene.Lights.GetCasting())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      lights.push_back(light.Positional ? light.Position[axis] : 0.0);
      lights.push_back(light.Direction[axis]);
    }
    lights.push_back(light.ConeAngle);
  }
  const bool first = this->TimedLights.empty();
  const bool moved =
    !first && (lights != this->TimedLights || scene.Work.Props.GetState() != this->TimedCasters);
  this->Moves = { moved, moved || (!first && seen != this->TimedView) };
  this->TimedView = seen;
  this->TimedLights = lights;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPlanning::HasRoom(int size) const
{
  const double texels = static_cast<double>(size) * size * this->Cost.Maps;
  return this->RoomRefused == 0.0 || texels < this->RoomRefused;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPlanning::RefuseRoom(int size)
{
  const double texels = static_cast<double>(size) * size * this->Cost.Maps;
  this->RoomRefused = this->RoomRefused > 0.0 ? std::min(this->RoomRefused, texels) : texels;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowPlanning::Fits(int method, int size, int lights) const
{
  vtkRelievoShadowDemand demand;
  demand.MapSize = size;
  demand.Maps = static_cast<int>(this->Cost.Maps);
  demand.Lights = lights;
  return size <= vtkRelievoShadowMaps::GetLargestSize() && this->HasRoom(size) &&
    vtkRelievoShadowMethod::Make(method)->Estimate(demand).Bytes <= MostBytes;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoShadowPlanner::Choice> vtkRelievoShadowPlanning::GetChoices(
  const Scene& scene, const Settings& settings)
{
  const std::vector<vtkRelievoShadowLight>& casting = scene.Lights.GetCasting();
  const bool suns = std::any_of(casting.begin(), casting.end(),
    [](const vtkRelievoShadowLight& light) { return !light.Positional; });
  std::vector<vtkRelievoShadowPlanner::Choice> choices;
  for (const int method : { vtkRelievoShadowMethods::MAP, vtkRelievoShadowMethods::WARPED })
  {
    for (const int size : Sizes)
    {
      if ((method == vtkRelievoShadowMethods::MAP || suns) &&
        this->Fits(method, size, static_cast<int>(casting.size())))
      {
        choices.push_back({ method, size, this->GetShareInView(scene, settings, method, size) });
      }
    }
  }
  // Casters that rays cannot trace need maps.
  if (!scene.Together && !scene.ExactRefused &&
    (!this->Probe.HasUnfollowed() || this->HasRoom(settings.MapSize)))
  {
    if (settings.ColoredShadows && scene.Work.Props.HasTranslucentCasters())
    {
      choices.clear(); // maps lack transmittances and colours: the picture would differ
    }
    choices.push_back({ vtkRelievoShadowMethods::EXACT, 0,
      this->GetShareInView(scene, settings, vtkRelievoShadowMethods::EXACT, 1) });
  }
  return choices;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPlanning::Make(
  const Scene& scene, const Settings& settings, const vtkRelievoFrameContext& context)
{
  const vtkRelievoShadowPlanner::Choice before = this->Plan.Chosen;
  const bool planned = this->Planned;
  // Several processes have no common time.
  this->Planned = settings.Tolerance > 0.0 || (settings.TimeBudget > 0.0 && !scene.Together);
  const vtkRelievoFrameCamera picture =
    vtkRelievoProbeView::GetPicture(context.SteadyView, context.Renderer);
  const bool tiled = picture.Viewport[2] != context.SteadyView.Viewport[2] ||
    picture.Viewport[3] != context.SteadyView.Viewport[3];
  const int updates = this->Probe.GetUpdates();
  if (this->Planned)
  {
    const double began = GetNow();
    this->UpdateProbe(scene, settings, context.Renderer);
    this->Spent += GetNow() - began;
  }
  const bool part = !context.Picture || tiled || context.Sample > 0;
  if (planned && this->Planned && settings.TimeBudget > 0.0 && part &&
    updates == this->Probe.GetUpdates() &&
    !(scene.ExactRefused && before.Method == vtkRelievoShadowMethods::EXACT) &&
    this->HasRoom(before.Size))
  {
    return; // layers, tiles and samples of a picture use the picture's plan
  }
  this->Plan = vtkRelievoShadowPlanner::Plan();
  this->Plan.Chosen.Method = settings.Method;
  this->Plan.Chosen.Size = settings.MapSize;
  if (!this->Planned)
  {
    return;
  }
  // All processes make the same choice, from shared data.
  const auto own = [&scene](double cost) { return scene.Together ? 0.0 : cost; };
  this->Cost.Pixels = static_cast<double>(picture.Viewport[2]) * picture.Viewport[3];
  this->Cost.Lights = static_cast<double>(scene.Lights.GetCasting().size());
  this->Cost.Maps = scene.Together ? this->Cost.Lights : this->Probe.GetNumberOfMaps();
  this->Cost.Triangles = own(static_cast<double>(this->Probe.GetNumberOfTriangles()));
  this->Cost.Props = own(static_cast<double>(scene.Work.Props.GetAllBoxes().size()));
  this->Cost.Software = !scene.Together && vtkRelievoIsSoftwareOpenGL();
  const std::vector<vtkRelievoShadowPlanner::Choice> choices = this->GetChoices(scene, settings);
  if (choices.empty())
  {
    this->Plan.Words = "nothing was chosen: no maps fit in the memory";
    return;
  }
  this->Plan =
    this->Planner.Choose({ settings.Tolerance, own(settings.TimeBudget) }, choices, this->Cost);
  this->Fresh = !(this->Plan.Chosen == before);
}

//------------------------------------------------------------------------------
// Frames with a plan that draw a picture; a frame that builds shaders predicts nothing.
void vtkRelievoShadowPlanning::End(
  const Scene& scene, bool picture, bool mapsDrawn, vtkMTimeType shaderTime)
{
  this->TimedCasters = scene.Work.Props.GetState(); // drawing has changed the state of some
  if (!this->Planned || !picture)
  {
    return;
  }
  glFinish();
  this->Took = GetNow() - this->Began;
  const bool built = this->TimedShaders != shaderTime;
  this->TimedShaders = shaderTime;
  if (this->Fresh || built)
  {
    return; // a frame redrawn for this reason predicts nothing either
  }
  this->Planner.AddFrame({ this->Moves.Maps || mapsDrawn, this->Moves.Rays });
  if (!this->Failed)
  {
    this->Planner.AddTime(
      this->Plan.Chosen, this->Cost, { mapsDrawn, this->Moves.Rays }, this->Took, this->Spent);
  }
}
