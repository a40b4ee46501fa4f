// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoParticleInterior.h"

#include "vtkRelievoFormulas.h"

#include "vtkSMPTools.h"

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace
{
// Lower purposes of random numbers are used elsewhere.
constexpr unsigned int FirstPurpose = 8;
}

//------------------------------------------------------------------------------
double vtkRelievoParticleRandom(vtkIdType particle, unsigned int purpose, unsigned int seed)
{
  const auto index = static_cast<std::uint64_t>(particle);
  return relievo::f64::relievoNoiseHash(static_cast<std::uint32_t>(index),
           static_cast<std::uint32_t>(index >> 32), purpose, seed) /
    4294967296.;
}

//------------------------------------------------------------------------------
vtkRelievoParticleInterior::vtkRelievoParticleInterior(const vtkRelievoParticleMaps& maps,
  const glm::dvec3& low, const glm::dvec3& high, unsigned int seed)
  : Maps(maps)
  , Low(low)
  , High(high)
  , Seed(seed)
{
  if (maps.Pairs)
  {
    this->FindColumns();
  }
  // Estimates the share of positions inside, equally for all particles and pieces.
  constexpr vtkIdType Samples = 65536;
  std::atomic<vtkIdType> inside{ 0 };
  vtkSMPTools::For(0, Samples, 1024, [&](vtkIdType begin, vtkIdType end) {
    glm::dvec3 position;
    vtkIdType count = 0;
    for (vtkIdType i = begin; i < end; ++i)
    {
      count += this->Draw(-1 - i, 0, position) ? 1 : 0;
    }
    inside += count;
  });
  // Fails for one particle in ten million.
  constexpr vtkIdType Enough = 16;
  this->Attempts =
    inside < Enough ? 0 : static_cast<unsigned int>((Enough * Samples + inside - 1) / inside);
}

//------------------------------------------------------------------------------
// Uses the axis with the least volume between front and back.
void vtkRelievoParticleInterior::FindColumns()
{
  for (std::size_t front = 0; front + 1 < this->Maps.Views.size(); front += 2)
  {
    const vtkRelievoParticleView& first = this->Maps.Views[front];
    const vtkRelievoParticleView& last = this->Maps.Views[front + 1];
    std::vector<double> lengths(first.GetNumberOfTexels());
    double sum = 0.;
    for (std::size_t texel = 0; texel < lengths.size(); ++texel)
    {
      const double length = first.IsSeen(texel) && last.IsSeen(texel)
        ? -last.GetDepth(texel) - first.GetDepth(texel)
        : 0.;
      sum += std::max(length, 0.);
      lengths[texel] = sum;
    }
    if (this->Lengths.empty() || sum < this->Lengths.back())
    {
      this->Lengths.swap(lengths);
      this->Front = front;
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleInterior::Draw(
  vtkIdType particle, unsigned int attempt, glm::dvec3& position) const
{
  const auto random = [&](unsigned int which) {
    return vtkRelievoParticleRandom(particle, FirstPurpose + 4 * attempt + which, this->Seed);
  };
  if (this->Lengths.empty())
  {
    position = glm::mix(this->Low, this->High, glm::dvec3(random(0), random(1), random(2)));
    return this->Maps.IsInside(position);
  }
  const double length = random(0) * this->Lengths.back();
  const auto found = std::upper_bound(this->Lengths.begin(), this->Lengths.end(), length);
  if (found == this->Lengths.end())
  {
    return false; // no space between front and back
  }
  const auto texel = static_cast<std::size_t>(found - this->Lengths.begin());
  const double before = texel > 0 ? this->Lengths[texel - 1] : 0.;
  const vtkRelievoParticleView& view = this->Maps.Views[this->Front];
  position = view.At(texel, 0.998 * (random(1) - 0.5), 0.998 * (random(2) - 0.5)).Position;
  const double depth =
    view.GetHeight(position) + random(3) * (*found - before) * view.GetTexelSize();
  position += depth * view.GetLook();
  return this->Maps.IsInside(position);
}

//------------------------------------------------------------------------------
bool vtkRelievoParticleInterior::Find(vtkIdType particle, glm::dvec3& position) const
{
  for (unsigned int attempt = 0; attempt < this->Attempts; ++attempt)
  {
    if (this->Draw(particle, attempt, position))
    {
      return true;
    }
  }
  return false;
}
