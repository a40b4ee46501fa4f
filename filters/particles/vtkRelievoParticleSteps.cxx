// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoParticleSteps.h"

#include "vtkSMPTools.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace
{
// Long steps are divided, so that no part crosses more than a texel: maximum number of parts.
constexpr int Parts = 512;

// The longest time up to `time` in which this speed covers at most half a texel.
double Limit(double time, double texel, double speed)
{
  return speed * time > 0.5 * texel ? 0.5 * texel / speed : time;
}
}

//------------------------------------------------------------------------------
void vtkRelievoParticleSteps::SetVelocities(
  vtkRelievoParticleMaps& maps, const vtkRelievoParticleField& field)
{
  for (vtkRelievoParticleView& view : maps.Views)
  {
    const auto texels = static_cast<vtkIdType>(view.GetNumberOfTexels());
    vtkSMPTools::For(0, texels, 4096, [&](vtkIdType begin, vtkIdType end) {
      vtkRelievoParticleField::Reader reader(field);
      for (auto texel = static_cast<std::size_t>(begin); texel < static_cast<std::size_t>(end);
           ++texel)
      {
        if (view.IsSeen(texel))
        {
          const vtkRelievoParticlePlace place = view.At(texel);
          view.SetVelocity(
            texel, glm::vec3(reader.OnSurface(place.Position, glm::dvec3(place.Normal))));
        }
      }
    });
  }
}

//------------------------------------------------------------------------------
vtkRelievoParticleSteps::vtkRelievoParticleSteps(
  const vtkRelievoParticleMaps& maps, const vtkRelievoParticleField& field, bool inside)
  : Maps(maps)
  , Field(field)
  , Inside(inside)
{
}

//------------------------------------------------------------------------------
void vtkRelievoParticleSteps::Begin(
  vtkRelievoParticleState start, double timeStep, int numberOfSteps, int checkpoints)
{
  this->Cached.clear();
  this->Cached.emplace(0, std::move(start));
  this->Latest = 0;
  this->TimeStep = timeStep;
  this->Interval = numberOfSteps / (checkpoints + 1) + 1;
}

//------------------------------------------------------------------------------
const vtkRelievoParticleState* vtkRelievoParticleSteps::Get(
  double steps, const std::function<bool(double)>& goesOn)
{
  // Rounding must not turn a whole step into two.
  double part = steps - std::floor(steps);
  const int whole = static_cast<int>(std::floor(steps)) + (part > 1. - 1e-6 ? 1 : 0);
  part = part < 1e-6 || part > 1. - 1e-6 ? 0. : part;

  auto before = std::prev(this->Cached.upper_bound(whole));
  const int from = before->first;
  if (from < whole)
  {
    // A state that no later time needs is moved, not copied.
    const bool isCached = from % this->Interval == 0;
    vtkRelievoParticleState state;
    if (isCached)
    {
      state = before->second;
    }
    else
    {
      state = std::move(before->second);
      this->Cached.erase(before);
    }
    for (int step = from; step < whole; ++step)
    {
      if (!goesOn(static_cast<double>(step - from) / (whole - from)))
      {
        return nullptr;
      }
      this->Advance(state, this->TimeStep);
      if ((step + 1) % this->Interval == 0 && step + 1 < whole)
      {
        this->Cached.emplace(step + 1, state);
      }
    }
    if (this->Latest % this->Interval != 0)
    {
      this->Cached.erase(this->Latest);
    }
    this->Latest = whole;
    before = this->Cached.emplace(whole, std::move(state)).first;
  }
  if (part == 0.)
  {
    return &before->second;
  }
  this->Between = before->second;
  this->Advance(this->Between, part * this->TimeStep);
  return &this->Between;
}

//------------------------------------------------------------------------------
double vtkRelievoParticleSteps::GetBytesHeld() const
{
  auto particles = static_cast<double>(this->Between.Positions.size());
  for (const auto& cached : this->Cached)
  {
    particles += static_cast<double>(cached.second.Positions.size());
  }
  return particles * static_cast<double>(vtkRelievoParticleState::GetBytesPerParticle());
}

//------------------------------------------------------------------------------
double vtkRelievoParticleSteps::EstimateBytes(
  vtkIdType particles, int numberOfSteps, int checkpoints)
{
  // Besides the checkpoints: the first, the last, the moving state, and a fraction of a step.
  const double stored = std::min(checkpoints, numberOfSteps) + 4.;
  return static_cast<double>(particles) *
    (stored * static_cast<double>(vtkRelievoParticleState::GetBytesPerParticle()) + 90.);
}

//------------------------------------------------------------------------------
void vtkRelievoParticleSteps::Advance(vtkRelievoParticleState& state, double time) const
{
  const auto count = static_cast<vtkIdType>(state.Positions.size());
  vtkSMPTools::For(0, count, 2048, [&](vtkIdType begin, vtkIdType end) {
    vtkRelievoParticleField::Reader reader(this->Field);
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
    {
      if (this->Inside)
      {
        this->AdvanceInside(reader, state.Positions[i], time);
      }
      else
      {
        this->AdvanceOnSurface(state.Positions[i], state.Views[i], time);
      }
    }
  });
}

//------------------------------------------------------------------------------
// Midpoint rule, in parts of half a texel by the speeds here and halfway.
void vtkRelievoParticleSteps::AdvanceOnSurface(
  glm::dvec3& position, unsigned char& view, double time) const
{
  double rest = time;
  vtkRelievoParticlePlace here;
  vtkRelievoParticlePlace next;
  if (!this->Maps.Views[view].Find(position, true, here))
  {
    return;
  }
  for (int part = 0; part < Parts && rest > 0.; ++part)
  {
    const double speed = static_cast<double>(glm::length(here.Velocity));
    if (!(speed > 0.))
    {
      return;
    }
    const double texel = this->Maps.Views[view].GetTexelSize();
    double step = Limit(rest, texel, speed);
    glm::dvec3 velocity = here.Velocity;
    int held = view;
    const glm::dvec3 middle = here.Position + 0.5 * step * velocity;
    glm::vec3 there;
    if (this->Maps.Views[view].FindVelocity(middle, there))
    {
      velocity = there - glm::dot(there, here.Normal) * here.Normal;
    }
    else if (this->Maps.Hold(middle, here, held, next))
    {
      velocity = next.Velocity;
    }
    step = Limit(step, texel, glm::length(velocity));
    held = view;
    if (!this->Maps.Hold(here.Position + step * velocity, here, held, next))
    {
      return; // at the end of the visible surface
    }
    here = next;
    position = here.Position;
    view = static_cast<unsigned char>(held);
    rest -= step;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoParticleSteps::AdvanceInside(
  vtkRelievoParticleField::Reader& field, glm::dvec3& position, double time) const
{
  const double texel = this->Maps.GetTexelSize();
  double rest = time;
  for (int part = 0; part < Parts && rest > 0.; ++part)
  {
    glm::dvec3 velocity = field.InSpace(position);
    const double speed = glm::length(velocity);
    if (!(speed > 0.))
    {
      return;
    }
    double step = Limit(rest, texel, speed);
    const glm::dvec3 middle = position + 0.5 * step * velocity;
    if (!this->Field.IsUniform() && this->Maps.IsInside(middle))
    {
      velocity = field.InSpace(middle);
      step = Limit(step, texel, glm::length(velocity));
    }
    glm::dvec3 to = position + step * velocity;
    if (!this->Maps.IsInside(to) && !this->Maps.PushInside(to, 2. * texel))
    {
      return; // cannot move on
    }
    position = to;
    rest -= step;
  }
}
