// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSoftLights.h"

#include "vtkRelievoFrameContext.h"
#include "vtkRelievoSampleLattice.h"
#include "vtkRelievoShadowLights.h"

#include <algorithm>

namespace
{
// Samples of soft lights and suns that share a few maps.
constexpr int MostFollowed = 64;
constexpr int MostFollowedSuns = 4;
}

//------------------------------------------------------------------------------
bool vtkRelievoSoftLights::HasSized(
  const vtkRelievoShadowLights& lights, vtkRenderer* renderer) const
{
  return lights.CountSized(renderer, this->Sizes, true) +
    lights.CountSized(renderer, this->Sizes, false) >
    0;
}

//------------------------------------------------------------------------------
bool vtkRelievoSoftLights::CanFollow(
  int samples, const vtkRelievoShadowLights& lights, vtkRenderer* renderer) const
{
  return samples <= MostFollowed && lights.CountSized(renderer, this->Sizes, true) == 0 &&
    lights.CountSized(renderer, this->Sizes, false) <= MostFollowedSuns;
}

//------------------------------------------------------------------------------
void vtkRelievoSoftLights::Begin(const vtkRelievoFrameContext& context, bool soft, int maps,
  const Room& room, vtkRelievoShadowLights& lights)
{
  this->Samples = soft ? context.Samples : 1;
  this->Gathered = soft ? context.Sample + 1 : 1;
  this->PartStep = glm::vec2(0.f);
  if (this->Samples > 1 && context.MeanLattice)
  {
    const int casting = std::max(1, static_cast<int>(lights.GetCasting().size()));
    const int parts =
      std::min(context.MeanLattice->GetNumberOfSamples(), std::max(1, room.Rays / casting));
    const bool divided = lights.Divide(this->Sizes, parts, maps, room.Maps / 2);
    this->Samples = this->Gathered = divided ? parts : 1;
    this->PartStep = glm::vec2(divided ? context.MeanLattice->GetNumberStep() : glm::ivec2(0));
  }
  else if (this->Samples > 1)
  {
    lights.Move(this->Sizes, context.Sample, context.Samples);
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoSoftLights::GetReport(bool together) const
{
  return this->PartStep != glm::vec2(0.f)
    ? ", " + std::to_string(this->Samples) + " parts of each sun are traced through its maps"
    : this->Samples > 1 ? ", " + std::to_string(this->Gathered) + " of " +
      std::to_string(this->Samples) + " samples of the lights' shapes gathered"
    : together ? ", lights are points: several processes draw together"
               : ", lights are points: none has a size, or there is no linear colour here";
}
