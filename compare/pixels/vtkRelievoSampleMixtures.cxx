// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSampleMixtures.h"

#include <algorithm>
#include <cmath>

namespace relievo::compare
{
namespace
{
// The angle between normals, in degrees, from which they belong to two faces.
constexpr double CreaseAngle = 20.0;
}

//------------------------------------------------------------------------------
SampleMixtures::SampleMixtures(const FramePair& frames, const Limits& limits)
  : Frames(frames)
  , Bounds(limits)
{
  const int samples[2] = { frames.A.GetSamples(), frames.B.GetSamples() };
  if (samples[0] >= 0 && samples[1] >= 0 && samples[0] != samples[1])
  {
    this->Smoother = samples[0] > samples[1] ? &frames.A : &frames.B;
  }
}

//------------------------------------------------------------------------------
bool SampleMixtures::Explain(
  std::size_t pixel, const std::function<bool(std::size_t)>& isOpen) const
{
  const bool hasLayers = !this->Frames.A.Actor.empty() && !this->Frames.B.Actor.empty();
  bool isEdge = hasLayers && this->IsEdge(pixel);
  if ((isEdge || this->Smoother) && this->IsBetweenNeighbours(pixel, 0.0))
  {
    return true;
  }
  if (hasLayers && this->Smoother)
  {
    // With other numbers of samples, pixels near edges mix surfaces, and pixels at borders of cells
    // show cells whose values were extrapolated to the pixel's centre, from at most a pixel away:
    // by as much as the neighbours' values differ. A place that is extrapolated into the surface
    // is dark, in a single pixel.
    bool isBorder = false;
    bool isThin = false;
    int different = 0;
    this->Frames.ForNeighbours(pixel, [&](std::size_t near) {
      isThin = isThin || this->IsThin(near);
      isEdge = isEdge || this->IsEdge(near);
      isBorder = isBorder ||
        (!this->Frames.A.Cell.empty() && this->Frames.A.Cell[near] != this->Frames.A.Cell[pixel]);
      different += isOpen(near) ? 1 : 0;
    });
    const bool isOneShadow = different == 1 && !this->Frames.A.Shadow.empty() &&
      !this->Frames.B.Shadow.empty() && this->IsDarkerInSamples(pixel);
    if ((isEdge && (isThin || this->IsMixture(pixel))) ||
      (isBorder && (isOneShadow || this->IsBetweenNeighbours(pixel, 1.0))))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool SampleMixtures::IsEdge(std::size_t pixel) const
{
  bool found = false;
  const Layer* normals = FramePair::Find(this->Frames.A.Surface, "normal");
  const Layer* albedo = FramePair::Find(this->Frames.A.Surface, "albedo");
  for (const Frame* frame : { &this->Frames.A, &this->Frames.B })
  {
    const double depth = frame->GetDepth(pixel);
    const double footprint = frame->GetFootprint(pixel);
    this->Frames.ForNeighbours(pixel, [&](std::size_t other) {
      const auto differs = [&](const std::vector<int>& ids) {
        return !ids.empty() && ids[pixel] != ids[other];
      };
      found = found || differs(frame->Actor) || differs(frame->Block);
      found = found || std::abs(frame->GetDepth(other) - depth) > 4.0 * footprint;
      for (const auto& [light, shadow] : frame->Shadow)
      {
        found = found || shadow[pixel] != shadow[other];
      }
    });
  }
  if (normals && normals->Components == 3)
  {
    this->Frames.ForNeighbours(pixel, [&](std::size_t other) {
      found = found ||
        FramePair::GetAngle(
          normals->Values.data() + 3 * pixel, normals->Values.data() + 3 * other) > CreaseAngle;
    });
  }
  if (albedo)
  {
    const auto components = static_cast<std::size_t>(albedo->Components);
    const float most = albedo->IsBytes ? 8.f : 8.f / 255.f;
    this->Frames.ForNeighbours(pixel, [&](std::size_t other) {
      for (std::size_t c = 0; c < components; ++c)
      {
        found = found ||
          std::abs(
            albedo->Values[pixel * components + c] - albedo->Values[other * components + c]) > most;
      }
    });
  }
  return found;
}

//------------------------------------------------------------------------------
bool SampleMixtures::IsBetweenNeighbours(std::size_t pixel, double widening) const
{
  for (int c = 0; c < this->Frames.CountLevels(); ++c)
  {
    const auto value = [c](const Frame& frame, std::size_t at) { return frame.Level(at, c); };
    // Pixels of several samples are mixtures of the surfaces that other frames show unmixed.
    if (!(this->Smoother ? this->Frames.IsBetween(*this->Smoother,
                             this->Smoother == &this->Frames.A ? this->Frames.B : this->Frames.A,
                             pixel, this->Bounds.ColorLevels, value, widening)
                         : this->Frames.IsBetween(pixel, this->Bounds.ColorLevels, value)))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether the smoother frame's colours may be a mixture of surfaces in the other frame, of which a
// narrow one shows in a pixel beside the neighbours only, with values that are extrapolated by as
// much as those around differ.
bool SampleMixtures::IsMixture(std::size_t pixel) const
{
  const Frame& other = this->Smoother == &this->Frames.A ? this->Frames.B : this->Frames.A;
  for (int c = 0; c < this->Frames.CountLevels(); ++c)
  {
    const auto value = [c](const Frame& frame, std::size_t at) { return frame.Level(at, c); };
    if (!this->Frames.IsBetween(
          *this->Smoother, other, pixel, this->Bounds.ColorLevels, value, 1.0, 2))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether the pixel shows a point or a line, which have no normals: OpenGL smooths their shapes in
// frames of several samples, so that what they hide in the other frame may appear.
bool SampleMixtures::IsThin(std::size_t pixel) const
{
  const auto isThin = [pixel](const Frame& frame) {
    const Layer* normals = FramePair::Find(frame.Surface, "normal");
    const float* n =
      normals && normals->Components == 3 ? normals->Values.data() + 3 * pixel : nullptr;
    return n && frame.Actor[pixel] >= 0 && n[0] == 0.f && n[1] == 0.f && n[2] == 0.f;
  };
  return isThin(this->Frames.A) || isThin(this->Frames.B);
}

//------------------------------------------------------------------------------
// Only frames of several samples extrapolate.
bool SampleMixtures::IsDarkerInSamples(std::size_t pixel) const
{
  const auto isDarker = [&](const Frame& own, const Frame& other) {
    bool isDark = own.GetSamples() > 1;
    for (int c = 0; c < this->Frames.CountLevels(); ++c)
    {
      isDark = isDark && own.Level(pixel, c) <= other.Level(pixel, c) + this->Bounds.ColorLevels;
    }
    return isDark;
  };
  return isDarker(this->Frames.A, this->Frames.B) || isDarker(this->Frames.B, this->Frames.A);
}
}
