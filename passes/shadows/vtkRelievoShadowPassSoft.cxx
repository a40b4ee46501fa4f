// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights with a size.
#include "vtkRelievoShadowInternals.h"

#include "vtkLight.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int MostSamples = 4096;
constexpr double WidestSun = 90.0;
constexpr double LargestLamp = 1e9;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetSunAngle(double degrees)
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
void vtkRelievoShadowPass::SetLampRadius(double radius)
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
void vtkRelievoShadowPass::SetLightSize(vtkLight* light, double size)
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
double vtkRelievoShadowPass::GetLightSize(vtkLight* light)
{
  return light ? this->Internal->Sizes.Get(light) : 0.0;
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::SetLightEdges(
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
void vtkRelievoShadowPass::DescribeSoft(vtkRelievoStageDescription& description)
{
  description.AddWhole(
    "soft_samples", this->SoftSamples, [this](int samples) { this->SetSoftSamples(samples); }, 0,
    MostSamples, "samples",
    "Soft shadows: samples of each light's shape that are gathered; 0: lights are points.");
  description.AddFlag(
    "soft_at_once", this->SoftAtOnce, [this](bool on) { this->SetSoftAtOnce(on); },
    "Whether every frame gathers all samples; otherwise one in each frame.");
  description.AddNumber(
    "sun_angle", this->SunAngle, [this](double degrees) { this->SetSunAngle(degrees); }, 0.0,
    WidestSun, "degrees", "Soft shadows: angle that directional lights appear under.");
  description.AddNumber(
    "lamp_radius", this->LampRadius, [this](double radius) { this->SetLampRadius(radius); }, 0.0,
    LargestLamp, "world units", "Soft shadows: radius of positional lights.");
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::DeclareSoft(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  const Internals& in = *this->Internal;
  if (this->SoftSamples > 1 && !in.Schedule.Exchange.IsOn() &&
    in.Lights.AreSized(context.Renderer, in.Sizes))
  {
    declaration.Samples = this->SoftSamples;
    declaration.AtOnce = this->SoftAtOnce;
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowPass::DescribeSamples() const
{
  const Internals& in = *this->Internal;
  if (this->SoftSamples <= 1)
  {
    return {};
  }
  return in.Samples > 1 ? ", " + std::to_string(in.Gathered) + " of " + std::to_string(in.Samples) +
      " samples of the lights' shapes gathered"
    : in.Schedule.Exchange.IsOn()
    ? ", lights are points: several processes draw together"
    : ", lights are points: none has a size, or there is no linear colour here";
}
