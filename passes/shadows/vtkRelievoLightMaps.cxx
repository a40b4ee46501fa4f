// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLightMaps.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoLightSamples.h"
#include "vtkRelievoMeshTexels.h"
#include "vtkRelievoMessagesOnce.h"
#include "vtkRelievoShadowLights.h"
#include "vtkRelievoSoftwareOpenGL.h"
#include "vtkRenderer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace
{
// Share of a frame's time that the depths of volumes may take.
constexpr double VolumesShare = 0.5;
}

//------------------------------------------------------------------------------
void vtkRelievoLightMaps::UseMethod(int method, vtkOpenGLRenderWindow* window)
{
  if (method == this->Made)
  {
    return;
  }
  this->Method = vtkRelievoShadowMethod::Make(method);
  this->Made = method;
  this->Work.Cache.Refit();
  window->MakeCurrent(); // earlier resources may belong to another window
}

//------------------------------------------------------------------------------
bool vtkRelievoLightMaps::IsRefused(int method) const
{
  return method == this->Refused && this->Work.Props.GetState() == this->RefusedCasters;
}

//------------------------------------------------------------------------------
void vtkRelievoLightMaps::Refuse(int method)
{
  this->Refused = method;
  this->RefusedCasters = this->Work.Props.GetState();
}

//------------------------------------------------------------------------------
vtkRelievoShadowPlanning::Scene vtkRelievoLightMaps::GetScene(const vtkRelievoShadowLights& lights)
{
  return { this->Work, lights, this->Schedule.Exchange.IsOn(),
    this->IsRefused(vtkRelievoShadowMethods::EXACT) };
}

//------------------------------------------------------------------------------
// Creates the planned method, or maps, with a warning.
void vtkRelievoLightMaps::PrepareMethod(
  vtkRelievoFrameContext& context, vtkRelievoMessagesOnce& messages)
{
  const int method = this->Planning.Get().Chosen.Method;
  bool refused = this->IsRefused(method);
  const bool together = this->Schedule.Exchange.IsOn();
  if (together && (refused || method != vtkRelievoShadowMethods::EXACT))
  {
    const bool again =
      this->Work.Others.Decline(refused && method == vtkRelievoShadowMethods::EXACT);
    refused = refused && !again;
  }
  this->UseMethod(refused ? vtkRelievoShadowMethods::MAP : method, context.Window);
  this->Work.WithoutFollowed = false;
  this->Work.OwnSteps = context.OwnSteps;
  const std::string fault = this->Method->Prepare(this->Work, context.Renderer);
  if (method == this->Refused && !refused)
  {
    this->Refused = -1; // a refused request may fit now
  }
  if (!fault.empty())
  {
    this->Refuse(this->Work.Others.IsDeclined() ? -1 : method);
    this->UseMethod(vtkRelievoShadowMethods::MAP, context.Window);
    // Only one process reports.
    if (!together || this->Schedule.Exchange.IsRoot())
    {
      messages.Warn(fault, "Shadows are made with maps: " + fault);
    }
  }
  const vtkIdType triangles =
    this->Work.WithoutFollowed ? this->Work.Props.GetTooManyTriangles() : vtkIdType(0);
  if (triangles > 0)
  {
    messages.Warn("triangles",
      "A mesh of " + std::to_string(triangles) +
        " triangles casts its shadow by a map: rays follow at most " +
        std::to_string(vtkRelievoMeshTexels::GetMostTriangles()) +
        " of a mesh. Split it into several");
  }
}

//------------------------------------------------------------------------------
int vtkRelievoLightMaps::GetSizeHere(int size, vtkRelievoMessagesOnce& messages)
{
  const int largest = vtkRelievoShadowMaps::GetLargestSize();
  if (size > largest)
  {
    std::ostringstream out;
    out << "Shadow maps of " << size << " x " << size
        << " texels were requested, this OpenGL makes at most " << largest << " x " << largest
        << ": these are used";
    messages.Warn("size" + std::to_string(size), out.str());
  }
  return std::min(size, largest);
}

//------------------------------------------------------------------------------
// Choices without enough OpenGL memory are recorded, and the plan chooses among the others.
std::string vtkRelievoLightMaps::Make(vtkRelievoFrameContext& context,
  const vtkRelievoShadowLights& lights, const Settings& settings, vtkRelievoMessagesOnce& messages)
{
  this->Work.Bias = settings.Bias;
  this->Work.ColoredShadows = settings.ColoredShadows;
  this->Planning.FindMoves(this->GetScene(lights), context.SteadyView);
  for (;;)
  {
    this->Planning.Make(this->GetScene(lights), settings, context);
    this->PrepareMethod(context, messages);
    const vtkRelievoShadowPlanner::Choice& chosen = this->Planning.Get().Chosen;
    const bool planned = this->Planning.IsPlanned() && this->Planning.Get().Milliseconds > 0.0;
    if (planned && chosen.Method == vtkRelievoShadowMethods::EXACT &&
      this->Made != vtkRelievoShadowMethods::EXACT)
    {
      continue;
    }
    const std::vector<vtkRelievoShadowLight>& casting = lights.GetCasting();
    const bool followed = std::any_of(casting.begin(), casting.end(),
      [](const vtkRelievoShadowLight& light) { return !light.Parts.empty(); });
    const int all = chosen.Size > 0 ? chosen.Size : settings.MapSize;
    const int size = followed ? std::max(16, all / 2) : all;
    std::string fault = this->Schedule.Fit(this->Work, casting, *this->Method,
      GetSizeHere(size, messages), settings.FilterRadius, context.Renderer);
    if (fault.empty() || !planned)
    {
      this->Planning.SetMade(fault.empty() && this->Made == chosen.Method);
      if (!fault.empty())
      {
        this->Work.Cache.Clear();
        this->Method->Unbind(); // releases resources reserved in Prepare
      }
      if (!this->Planning.IsPlanned() && !this->Method->Traces())
      {
        this->Work.Props.ForgetGlyphs();
      }
      return fault;
    }
    if (chosen.Method == vtkRelievoShadowMethods::EXACT)
    {
      this->Refuse(vtkRelievoShadowMethods::EXACT);
      continue;
    }
    this->Planning.RefuseRoom(size);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLightMaps::MakeNone(vtkOpenGLRenderWindow* window)
{
  this->Planning.SetNone();
  this->UseMethod(vtkRelievoShadowMethods::MAP, window);
  this->Work.WithoutFollowed = false;
  this->Work.Maps.Release(window);
  this->Work.Shade.Release(window);
  this->Work.Cache.Clear();
  this->Work.Others.Clear();
}

//------------------------------------------------------------------------------
std::string vtkRelievoLightMaps::MakeShade(vtkOpenGLRenderWindow* window, const Settings& settings,
  const vtkRelievoLightSizes& sizes, int samples, bool asked)
{
  std::vector<double> spreads;
  std::vector<vtkRelievoOpticalDepths::Source> sources;
  for (const auto& entry : this->Work.Cache.GetEntries())
  {
    const vtkRelievoShadowLight& light = entry.Light;
    sources.push_back(light.GetSource());
    // A sample stands for its share of the sun's disc.
    const double half = vtkMath::RadiansFromDegrees(0.5 * sizes.Get(light.Light));
    const bool soft = samples > 1 && !light.Positional;
    spreads.push_back(!soft   ? 0.0
        : light.Parts.empty() ? std::tan(half) / std::sqrt(static_cast<double>(samples))
                              : std::tan(half));
  }
  this->Work.Shade.SetSpreads(spreads);
  // Other processes may have receivers.
  const bool receives = asked || !this->Work.Props.GetReceiverBoxes().empty();
  const bool nowhere =
    this->Schedule.Exchange.IsOn() ? this->Schedule.Exchange.IsEverywhere(!receives) : !receives;
  const bool seen = !this->Work.WithoutVolumes && !nowhere;
  this->Work.Shade.SetCasters(
    seen ? this->Work.Props.GetVolumeCasters() : std::vector<vtkRelievoPlacedVolume>(),
    settings.ColoredShadows);
  this->Work.Shade.SetNodes(settings.VolumeNodes, settings.VolumeHarmonics,
    { settings.Tolerance, VolumesShare * settings.TimeBudget }, samples > 1);
  const std::string fault = this->Work.Shade.Update(window, sources);
  if (!this->Work.Shade.Bind())
  {
    this->Work.Shade.Release(window);
    return "all texture units of this OpenGL are taken; use fewer textures";
  }
  return fault;
}

//------------------------------------------------------------------------------
bool vtkRelievoLightMaps::UpdateStructure(
  vtkOpenGLRenderWindow* window, const vtkRelievoShadowLights& lights, bool unlit, bool direct)
{
  vtkRelievoShadowStructure structure;
  structure.Method = this->Method->GetShader();
  structure.Traced = this->Method->Traces();
  structure.Colored = this->Method->Colors();
  structure.Volumes = this->Work.Shade.IsMade();
  structure.Spread = structure.Volumes && this->Work.Shade.IsSpread();
  structure.Around = this->Work.Shade.IsAround();
  structure.Harmonics = structure.Volumes ? this->Work.Shade.GetHarmonics() : 0;
  structure.Tinted = structure.Volumes && this->Work.Shade.IsTinted();
  structure.Maps = !structure.Traced || this->Work.Cache.GetNumberOfMaps() > 0;
  structure.Numbers = static_cast<int>(lights.GetAll().size());
  structure.Unlit = unlit;
  structure.Direct = direct;
  structure.WideFilter = this->Work.Radius > 1;
  structure.Highlights = this->Work.Props.HasHighlights();
  structure.Parts = 0;
  for (const auto& entry : this->Work.Cache.GetEntries())
  {
    const int parts = static_cast<int>(entry.Light.Parts.size());
    const int maps = static_cast<int>(entry.Light.Centers.size());
    structure.Lights.push_back(
      { entry.Light.ShaderIndex, !entry.Light.Positional, entry.Cube, maps });
    structure.Parts = std::max(structure.Parts, parts);
  }
  structure.Nearest = structure.Parts > 0 && vtkRelievoIsSoftwareOpenGL() &&
    this->Work.Maps.GetNearest().Bind(window);
  if (!structure.Nearest)
  {
    this->Work.Maps.GetNearest().Release(window);
  }
  for (vtkActor* actor : this->Method->GetFound(structure.Lights.size()))
  {
    structure.Found.push_back(actor->GetMapper());
  }
  const bool changed = !(structure == this->Work.Structure);
  if (changed)
  {
    this->Work.Structure = structure;
  }
  return changed;
}

//------------------------------------------------------------------------------
void vtkRelievoLightMaps::UpdateNearest(vtkOpenGLRenderWindow* window)
{
  std::vector<double> reaches;
  for (const auto& entry : this->Work.Cache.GetEntries())
  {
    if (entry.Maps.size() != entry.Light.Centers.size())
    {
      continue; // a point
    }
    for (const vtkRelievoShadowLight::Part& part : entry.Light.Parts)
    {
      const auto& map = entry.Maps[static_cast<std::size_t>(part.Map)];
      const glm::dvec2 ray = glm::abs(this->Work.Maps.GetRay(map.View, part.Direction));
      const auto layer = static_cast<std::size_t>(map.Layer);
      reaches.resize(std::max(reaches.size(), layer + 1), 0.0);
      reaches[layer] = std::max({ reaches[layer], ray.x, ray.y });
    }
  }
  this->Work.Maps.GetNearest().Update(window, reaches);
}

//------------------------------------------------------------------------------
int vtkRelievoLightMaps::DrawMaps(vtkRenderer* renderer)
{
  const int draws = this->Schedule.Draw(this->Work, renderer);
  if (this->Work.Structure.Nearest)
  {
    this->UpdateNearest(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
  }
  this->Work.Maps.Bind(true);
  return draws;
}

//------------------------------------------------------------------------------
int vtkRelievoLightMaps::DrawMethod(vtkRenderer* renderer)
{
  return this->Method->Draw(this->Work, renderer);
}

//------------------------------------------------------------------------------
void vtkRelievoLightMaps::Unbind()
{
  this->Work.Maps.Unbind();
  this->Work.Shade.Unbind();
  this->Method->Unbind();
}

//------------------------------------------------------------------------------
vtkRelievoLightMaps::Known vtkRelievoLightMaps::GetKnown()
{
  return { this->Planning.GetProbe().HasScene(this->Work.Props), this->IsRefused(this->Refused) };
}

//------------------------------------------------------------------------------
void vtkRelievoLightMaps::Settle(const Known& known)
{
  this->Work.Cache.SetCasters(this->Work.Props, this->Work.WithoutFollowed);
  this->Method->Settle(this->Work);
  if (known.Probed)
  {
    this->Planning.GetProbe().Settle(this->Work.Props);
  }
  if (known.Refused)
  {
    this->Refuse(this->Refused);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLightMaps::Invalidate()
{
  this->Work.Cache.Invalidate();
  this->Method->Forget();
  this->Planning.ForgetView();
}

//------------------------------------------------------------------------------
double vtkRelievoLightMaps::GetExpectedWrongShare() const
{
  if (this->Planning.IsPlanned() && this->Planning.Get().Chosen.Method == this->Made)
  {
    return this->Planning.Get().Chosen.WrongShare;
  }
  vtkRelievoShadowDemand demand;
  demand.MapSize = this->Work.Maps.GetSize();
  return this->Method->Estimate(demand).WrongShare;
}

//------------------------------------------------------------------------------
std::string vtkRelievoLightMaps::GetReport() const
{
  const int maps = this->Work.Cache.GetNumberOfMaps();
  const int size = this->Work.Maps.GetSize();
  std::ostringstream out;
  out << maps << (maps == 1 ? " map of " : " maps of ") << size << " x " << size << " texels, "
      << this->Work.MapsDrawn << " drawn anew, expected share of wrong pixels "
      << std::setprecision(2) << 100.0 * this->GetExpectedWrongShare() << " %"
      << (this->Planning.IsPlanned() ? ", " + this->Planning.Get().Words : std::string())
      << this->Method->GetReport() << this->Work.Shade.GetReport()
      << this->Work.Props.GetVolumesWithout() << this->Work.Others.GetReport();
  return out.str();
}

//------------------------------------------------------------------------------
void vtkRelievoLightMaps::Release(vtkWindow* window)
{
  this->Work.Maps.Release(window);
  this->Work.Shade.Release(window);
  this->Method->Release(window);
  this->Work.PlainDraw.Release(window);
  this->Work.Props.ForgetGlyphs();
  this->Work.Props.ForgetPointGroups();
  this->Work.Cache.Clear();
  this->Refused = -1; // another window's OpenGL may have enough memory
  this->Planning.ForgetRoom({});
}
