// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowCertifier.h"

#include "vtkRelievoShadowCertificate.h"
#include "vtkRelievoThreads.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
// Steps in which OpenGL places edges in a pixel.
constexpr double SubPixel = 1.0 / 256.0;

// Surfaces are looked for where the layer depth has one, within a share of it; in parallel
// projection, of the whole depth.
constexpr double DepthWindow = 1e-3;

constexpr double TransmittanceSlack = 0.02;
constexpr std::size_t Batch = 8192;
}

//------------------------------------------------------------------------------
vtkRelievoShadowCertifier::Findings vtkRelievoShadowCertifier::Judge(int x, int y, int light) const
{
  const std::size_t pixel = static_cast<std::size_t>(y) * this->View.Viewport[2] + x;
  const double depth = this->Depth[pixel];
  if (!std::isfinite(depth))
  {
    return NOTHING;
  }
  const double window = this->GetDepthWindow(depth);
  const double wanted = this->CoarseDepth ? depth - window : depth;
  const vtkRelievoShadowPixels pixels(this->View, this->Rays.GetCenter());
  const vtkRelievoPixelRay eye = pixels.GetRay(x + 0.5, y + 0.5);
  const vtkRelievoCasterRays::Meeting seen =
    this->Rays.Find(eye.From, eye.Ray, depth - window, depth + window, wanted);
  const float drawn = this->Visibility[light][pixel];
  if (seen.Surface < 0 || !std::isfinite(drawn))
  {
    return UNKNOWN;
  }
  const glm::dvec3 place = eye.From + seen.T * eye.Ray;
  const vtkRelievoToLight to(this->Lights[light], place, this->Rays.GetCenter());
  if (!to.Lights || !this->Rays.GetSurfaces()[seen.Surface].Receives)
  {
    return UNLIT;
  }
  const double facing = glm::dot(glm::normalize(seen.Normal), glm::normalize(to.Ray));
  if (!(facing > vtkRelievoLeastFacing))
  {
    return GRAZING;
  }
  if (vtkRelievoMeetsAny(this->Unfollowed, this->Rays.GetCenter(), place, to.Ray, to.Last))
  {
    return UNKNOWN;
  }
  const double blur = vtkRelievoPlaceBlur * glm::length(seen.T * eye.Ray);
  const double truth = this->Rays.Pass(place, to.Ray, to.Last, seen, blur);
  // Before it is known what was drawn: it must not decide what is counted.
  for (int corner = 0; corner < 4; ++corner)
  {
    const vtkRelievoPixelRay beside = pixels.GetRay(
      x + 0.5 + (corner & 1 ? SubPixel : -SubPixel), y + 0.5 + (corner & 2 ? SubPixel : -SubPixel));
    const double t = glm::dot(seen.Normal, place - beside.From) / glm::dot(seen.Normal, beside.Ray);
    const glm::dvec3 at = beside.From + t * beside.Ray;
    const vtkRelievoToLight other(this->Lights[light], at, this->Rays.GetCenter());
    if (this->Rays.Pass(at, other.Ray, other.Last, seen, blur) != truth ||
      this->HasOtherNeighbour(
        beside, light, wanted + glm::clamp(t - seen.T, -window, window), seen, truth))
    {
      return TIE;
    }
  }
  return this->IsAlike(drawn, truth) ? RIGHT : drawn < truth ? FALSE_SHADOW : FALSE_LIGHT;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowCertifier::IsAlike(double a, double b) const
{
  return this->Attenuates ? std::abs(a - b) <= TransmittanceSlack : (a >= 0.5) == (b >= 0.5);
}

//------------------------------------------------------------------------------
// Whether a ray beside the pixel's centre meets another triangle, which has another verdict: OpenGL
// may draw either.
bool vtkRelievoShadowCertifier::HasOtherNeighbour(const vtkRelievoPixelRay& beside, int light,
  double wanted, const vtkRelievoCasterRays::Meeting& seen, double truth) const
{
  const double window = this->GetDepthWindow(wanted);
  const vtkRelievoCasterRays::Meeting found =
    this->Rays.Find(beside.From, beside.Ray, wanted - window, wanted + window, wanted);
  if (found.Surface < 0 || (found.Place == seen.Place && found.Triangle == seen.Triangle))
  {
    return false;
  }
  const glm::dvec3 place = beside.From + found.T * beside.Ray;
  const vtkRelievoToLight to(this->Lights[light], place, this->Rays.GetCenter());
  const double blur = vtkRelievoPlaceBlur * glm::length(found.T * beside.Ray);
  const double passes = glm::dot(found.Normal, to.Ray) > 0.0
    ? this->Rays.Pass(place, to.Ray, to.Last, found, blur)
    : 0.0;
  return !this->IsAlike(passes, truth);
}

//------------------------------------------------------------------------------
double vtkRelievoShadowCertifier::GetDepthWindow(double depth) const
{
  return DepthWindow *
    (this->View.Parallel ? std::max(std::abs(depth), this->View.Far - this->View.Near) : depth);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowCertifier::Certify(
  int rays, int seed, vtkRelievoShadowCertificate* certificate) const
{
  const std::size_t width = static_cast<std::size_t>(this->View.Viewport[2]);
  const std::size_t pixels = width * static_cast<std::size_t>(this->View.Viewport[3]);
  std::vector<std::size_t> order(pixels * this->Lights.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  vtkRelievoSplitMix64 lots(static_cast<std::uint64_t>(seed));
  std::vector<Findings> findings;
  for (std::size_t from = 0; from < order.size() && certificate->Judged < rays;)
  {
    const std::size_t to = std::min(order.size(), from + Batch);
    for (std::size_t i = from; i < to; ++i)
    {
      std::swap(order[i], order[i + lots.Next() % (order.size() - i)]);
    }
    findings.assign(to - from, NOTHING);
    vtkRelievoWithThreads([&]() {
      vtkSMPTools::For(
        static_cast<vtkIdType>(from), static_cast<vtkIdType>(to), [&](vtkIdType a, vtkIdType b) {
          for (vtkIdType i = a; i < b; ++i)
          {
            const std::size_t one = order[static_cast<std::size_t>(i)];
            const std::size_t pixel = one % pixels;
            findings[static_cast<std::size_t>(i) - from] =
              this->Judge(static_cast<int>(pixel % width), static_cast<int>(pixel / width),
                static_cast<int>(one / pixels));
          }
        });
    });
    for (std::size_t i = 0; i < findings.size() && certificate->Judged < rays; ++i)
    {
      const Findings found = findings[i];
      certificate->Judged += found <= FALSE_LIGHT ? 1 : 0;
      certificate->FalseShadow += found == FALSE_SHADOW ? 1 : 0;
      certificate->FalseLight += found == FALSE_LIGHT ? 1 : 0;
      certificate->Ties += found == TIE ? 1 : 0;
      certificate->Grazing += found == GRAZING ? 1 : 0;
      certificate->Unlit += found == UNLIT ? 1 : 0;
      certificate->Unknown += found == UNKNOWN ? 1 : 0;
    }
    from = to;
  }
}
