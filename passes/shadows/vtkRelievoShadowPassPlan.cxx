// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass chooses its method and the size of its maps, for a tolerance or a time.
#include "vtkRelievoShadowInternals.h"

#include "vtkOpenGLError.h" // for OpenGL
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoProbeView.h"
#include "vtkRelievoShadowMethodExact.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace
{
const int Sizes[] = { 1024, 2048, 4096, 8192 };

// Where rays cannot tell: measurements are within so many times the law.
constexpr double LawsFactor = 2.5;

// Maps of more bytes are not chosen.
constexpr vtkIdType MostBytes = vtkIdType(1) << 31;

bool IsSoftware()
{
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = name ? name : "";
  return renderer.find("llvmpipe") != std::string::npos ||
    renderer.find("softpipe") != std::string::npos;
}

double GetNow()
{
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetTolerance(double share)
{
  if (!(share >= 0.0 && share <= 1.0))
  {
    vtkErrorMacro("SetTolerance was given " << share << "; give it the share of wrong pixels that "
                                            << "is tolerable, from 0 (none is set) to 1; 0.05 % "
                                            << "is 0.0005.");
    return;
  }
  if (this->Tolerance != share)
  {
    this->Tolerance = share;
    this->Internal->RoomRefused = 0.0;
    if (this->Tolerance + this->TimeBudget == 0.0)
    {
      this->Internal->Probe.Release();
    }
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetTimeBudget(double milliseconds)
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
    this->Internal->RoomRefused = 0.0;
    if (this->Tolerance + this->TimeBudget == 0.0)
    {
      this->Internal->Probe.Release();
    }
    this->Internal->Planner.Forget();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPass::EstimateWrongShareInView(int method, int size)
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
  this->UpdateProbe();
  return this->GetShareInView(method, size);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::UpdateProbe()
{
  Internals& in = *this->Internal;
  if (!in.Schedule.Exchange.IsOn())
  {
    in.Work.Bias = this->Bias;
    in.Work.Radius = this->FilterRadius;
    in.Probe.Update(
      in.Work, in.Lights.GetUnmoved(), vtkRelievoProbeView::GetPicture(in.Work.View, in.Renderer));
  }
}

//------------------------------------------------------------------------------
// As the probe is.
double vtkRelievoShadowPass::GetShareInView(int method, int size)
{
  const Internals& in = *this->Internal;
  const double law = this->EstimateWrongShare(method, size);
  const bool alone = !in.Schedule.Exchange.IsOn();
  if (method == METHOD_EXACT)
  {
    vtkRelievoShadowDemand demand;
    demand.Farness = vtkRelievoShadowMethodExact::GetFarness(in.Work);
    // What cannot be followed is looked up in maps.
    return alone && !in.Probe.HasUnfollowed()
      ? vtkRelievoShadowMethod::Make(METHOD_EXACT)->Estimate(demand).WrongShare
      : std::min(1.0, LawsFactor * this->EstimateWrongShare(METHOD_MAP, this->MapSize));
  }
  if (!alone || !in.Probe.IsKnown())
  {
    return std::min(1.0, LawsFactor * law);
  }
  const double share = in.Probe.GetWrongShare(size, method == METHOD_WARPED);
  return method == METHOD_FORWARD
    ? std::min(1.0, share * law / this->EstimateWrongShare(METHOD_MAP, size))
    : share;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::MakePlan(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const vtkRelievoShadowPlanner::Way before = in.Plan.Chosen;
  const bool planned = in.Planned;
  // Several processes have no time in common.
  in.Planned = this->Tolerance > 0.0 || (this->TimeBudget > 0.0 && !in.Schedule.Exchange.IsOn());
  const bool refused = in.MethodRefused == METHOD_EXACT && in.Work.Props.GetState() == in.Refused;
  const auto hasRoom = [&](int size) {
    const double texels = static_cast<double>(size) * size * in.Load.Maps;
    return in.RoomRefused == 0.0 || texels < in.RoomRefused;
  };
  const vtkRelievoView picture = vtkRelievoProbeView::GetPicture(context.View, context.Renderer);
  const bool tiled = picture.Viewport[2] != context.View.Viewport[2] ||
    picture.Viewport[3] != context.View.Viewport[3];
  const int updates = in.Probe.GetUpdates();
  if (in.Planned)
  {
    const double began = GetNow();
    this->UpdateProbe();
    in.Planning += GetNow() - began;
  }
  const bool part = !context.Picture || tiled || context.Sample > 0;
  if (planned && in.Planned && this->TimeBudget > 0.0 && part && updates == in.Probe.GetUpdates() &&
    !(refused && before.Method == METHOD_EXACT) && hasRoom(before.Size))
  {
    return; // layers, tiles and samples of a picture are made as the picture was
  }
  in.Plan = vtkRelievoShadowPlanner::Plan();
  in.Plan.Chosen.Method = this->Method;
  in.Plan.Chosen.Size = this->MapSize;
  if (!in.Planned)
  {
    return;
  }
  const std::vector<vtkRelievoShadowLight>& casting = in.Lights.GetCasting();
  const bool together = in.Schedule.Exchange.IsOn();
  const bool suns = std::any_of(casting.begin(), casting.end(),
    [](const vtkRelievoShadowLight& light) { return !light.Positional; });
  in.Load.Pixels = static_cast<double>(picture.Viewport[2]) * picture.Viewport[3];
  in.Load.Lights = static_cast<double>(casting.size());
  // Processes choose alike: by what all of them know.
  const auto own = [together](double load) { return together ? 0.0 : load; };
  in.Load.Maps = together ? in.Load.Lights : in.Probe.GetNumberOfMaps();
  in.Load.Triangles = own(static_cast<double>(in.Probe.GetNumberOfTriangles()));
  in.Load.Props = own(static_cast<double>(in.Work.Props.GetAllBoxes().size()));
  in.Load.Software = !together && IsSoftware();
  const auto fits = [&](int method, int size) {
    const int maps = static_cast<int>(in.Load.Maps);
    return size <= vtkRelievoShadowMaps::GetLargestSize() && hasRoom(size) &&
      this->EstimateBytes(method, size, maps, static_cast<int>(casting.size()), 0, 0) <= MostBytes;
  };
  std::vector<vtkRelievoShadowPlanner::Way> ways;
  for (const int method : { METHOD_MAP, METHOD_WARPED })
  {
    for (const int size : Sizes)
    {
      if ((method == METHOD_MAP || suns) && fits(method, size))
      {
        ways.push_back({ method, size, this->GetShareInView(method, size) });
      }
    }
  }
  // What cannot be followed by rays needs maps.
  if (!together && !refused && (!in.Probe.HasUnfollowed() || hasRoom(this->MapSize)))
  {
    if (this->ColoredShadows && in.Work.Props.HasTranslucentCasters())
    {
      ways.clear(); // maps have neither shares nor colours: the picture would be another
    }
    ways.push_back({ METHOD_EXACT, 0, this->GetShareInView(METHOD_EXACT, 1) });
  }
  if (ways.empty())
  {
    in.Plan.Words = "nothing was chosen: no maps fit in the memory";
    return;
  }
  in.Plan = in.Planner.Choose({ this->Tolerance, own(this->TimeBudget) }, ways, in.Load);
  in.Fresh = !(in.Plan.Chosen == before);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::PrepareMethod(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  const int method = in.Plan.Chosen.Method;
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
    in.MethodRefused = -1; // it can be done now
  }
  else if (method == in.MethodRefused && !refused)
  {
    in.MethodRefused = -1; // what was refused once may fit by now
  }
  if (!fault.empty())
  {
    in.MethodRefused = in.Work.Others.IsDeclined() ? -1 : method;
    in.Refused = in.Work.Props.GetState();
    in.UseMethod(METHOD_MAP, context.Window);
    // One process speaks for all.
    if ((!together || in.Schedule.Exchange.IsRoot()) && in.Said.insert(fault).second)
    {
      vtkWarningMacro("Shadows are made with maps: " << fault << ".");
    }
  }
}

//------------------------------------------------------------------------------
// Ways that OpenGL has no memory for are remembered, and the choice is made among the others.
std::string vtkRelievoShadowPass::MakeMaps(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.FindMoves(context.View);
  for (;;)
  {
    this->MakePlan(context);
    this->PrepareMethod(context);
    const vtkRelievoShadowPlanner::Way& chosen = in.Plan.Chosen;
    const bool planned = in.Planned && in.Plan.Milliseconds > 0.0;
    if (planned && chosen.Method == METHOD_EXACT && in.MethodMade != METHOD_EXACT)
    {
      continue;
    }
    const int size = chosen.Size > 0 ? chosen.Size : this->MapSize;
    std::string fault = in.Schedule.Fit(in.Work, in.Lights.GetCasting(), *in.Method,
      this->GetSizeHere(size), this->FilterRadius, context.Renderer);
    if (fault.empty() || !planned)
    {
      in.Failed = !fault.empty() || in.MethodMade != chosen.Method;
      return fault;
    }
    if (chosen.Method == METHOD_EXACT)
    {
      in.MethodRefused = METHOD_EXACT;
      in.Refused = in.Work.Props.GetState();
      continue;
    }
    const double texels = static_cast<double>(size) * size * in.Load.Maps;
    in.RoomRefused = in.RoomRefused > 0.0 ? std::min(in.RoomRefused, texels) : texels;
  }
}

//------------------------------------------------------------------------------
// Frames of layers alone leave what the picture took.
void vtkRelievoShadowPass::Internals::BeginTiming(bool picture)
{
  this->Began = GetNow();
  this->Took = picture ? -1.0 : this->Took;
  this->Planning = 0.0;
}

//------------------------------------------------------------------------------
// Of frames with a plan that draw a picture; those that build shaders tell nothing of the next.
void vtkRelievoShadowPass::EndTiming(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.TimedCasters = in.Work.Props.GetState(); // some have changed by being drawn
  if (!in.Planned || !context.Picture)
  {
    return;
  }
  glFinish();
  in.Took = GetNow() - in.Began;
  const bool built = in.TimedStructure != in.StructureTime.GetMTime();
  in.TimedStructure = in.StructureTime.GetMTime();
  if (in.Fresh || built)
  {
    return; // what is drawn anew for that tells nothing either
  }
  const bool maps = this->NumberOfMapsDrawn > 0;
  in.Planner.AddFrame({ in.Moves.Maps || maps, in.Moves.Rays });
  if (!in.Failed)
  {
    in.Planner.AddTime(in.Plan.Chosen, in.Load, { maps, in.Moves.Rays }, in.Took, in.Planning);
  }
}

//------------------------------------------------------------------------------
// What has moved since the frame before, for every method: maps are drawn anew when casters or
// lights move, and verdicts of rays are kept only while the view stays as well.
void vtkRelievoShadowPass::Internals::FindMoves(const vtkRelievoView& view)
{
  const glm::dmat4 seen = view.ViewToNDC * view.WorldToView;
  std::vector<double> lights;
  for (const vtkRelievoShadowLight& light : this->Lights.GetCasting())
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
    !first && (lights != this->TimedLights || this->Work.Props.GetState() != this->TimedCasters);
  this->Moves = { moved, moved || (!first && seen != this->TimedView) };
  this->TimedView = seen;
  this->TimedLights = lights;
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowPass::GetPlan()
{
  return this->Internal->Planned ? this->Internal->Plan.Words : std::string();
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetMethodUsed()
{
  return this->Internal->MethodMade;
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetMapSizeUsed()
{
  return this->Internal->Work.Maps.GetSize();
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPass::GetExpectedMilliseconds()
{
  return this->Internal->Planned ? this->Internal->Plan.Milliseconds : -1.0;
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPass::GetMillisecondsTaken()
{
  return this->Internal->Planned ? this->Internal->Took : -1.0;
}
