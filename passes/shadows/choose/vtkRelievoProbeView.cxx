// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoProbeView.h"

#include "vtkRelievoTiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double LightSteps = 32.0;      // steps of a light per distance
constexpr double StepsPerView = 8.0;     // steps of the camera per half height of its view
constexpr double LeastAway = 1.0 / 64.0; // least share of the distance to the centre, in a box

glm::dvec3 Round(const glm::dvec3& v, double step)
{
  return step * glm::round(v / step);
}

double GetDistance(const vtkRelievoBox& box, const glm::dvec3& place)
{
  return glm::length(place - glm::clamp(place, box.Min, box.Max));
}

// Near and far in steps, because most cameras adapt them to the scene; only the sides of the view
// matter.
void SetDepths(vtkRelievoFrameCamera& view)
{
  double& n = view.Near;
  double& f = view.Far;
  glm::dmat4& p = view.ViewToNDC;
  if (!(f > n) || !(view.Parallel || n > 0.0))
  {
    return;
  }
  if (view.Parallel)
  {
    const double step = 0.5 * std::exp2(std::ceil(std::log2(f - n)));
    n = step * std::floor(n / step);
    f = step * std::ceil(f / step);
    p[2][2] = -2.0 / (f - n);
    p[3][2] = -(f + n) / (f - n);
    return;
  }
  n = std::exp2(std::floor(std::log2(n)));
  f = std::exp2(std::ceil(std::log2(f)));
  p[2][2] = -(f + n) / (f - n);
  p[3][2] = -2.0 * f * n / (f - n);
}
}

//------------------------------------------------------------------------------
vtkRelievoFrameCamera vtkRelievoProbeView::GetStep(const vtkRelievoFrameCamera& view,
  const glm::dvec3& center, const std::vector<vtkRelievoBox>& boxes)
{
  vtkRelievoFrameCamera stepped = view;
  const glm::dmat4 viewToWorld = glm::inverse(view.WorldToView);
  const glm::dvec3 eye(viewToWorld[3]);
  const double half = 1.0 / std::abs(view.ViewToNDC[1][1]); // at unit distance
  const double middle = std::max(glm::length(center - eye), 1e-300);
  double away = middle;
  for (const vtkRelievoBox& box : boxes)
  {
    away = std::min(away, std::max(GetDistance(box, eye), LeastAway * middle));
  }
  const double size = std::exp2(std::floor(std::log2(view.Parallel ? half : half * away)));
  if (!std::isfinite(size) || !(size > 0.0))
  {
    return view;
  }
  const double turn = (view.Parallel ? 0.25 : half) / StepsPerView;
  const glm::dvec3 back = glm::normalize(Round(glm::normalize(glm::dvec3(viewToWorld[2])), turn));
  glm::dvec3 up = Round(glm::normalize(glm::dvec3(viewToWorld[1])), 0.25 / StepsPerView);
  const glm::dvec3 right = glm::normalize(glm::cross(up, back));
  up = glm::cross(back, right);
  const glm::dvec3 from = Round(eye, size / StepsPerView);
  if (!(glm::length(right) > 0.5) || !(glm::length(back) > 0.5))
  {
    return view;
  }
  glm::dmat4 placed(1.0);
  placed[0] = glm::dvec4(right, 0.0);
  placed[1] = glm::dvec4(up, 0.0);
  placed[2] = glm::dvec4(back, 0.0);
  placed[3] = glm::dvec4(from, 1.0);
  stepped.WorldToView = glm::inverse(placed);
  SetDepths(stepped);
  return stepped;
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoShadowLight> vtkRelievoProbeView::GetStep(
  const std::vector<vtkRelievoShadowLight>& lights, const glm::dvec3& center)
{
  std::vector<vtkRelievoShadowLight> stepped = lights;
  for (vtkRelievoShadowLight& light : stepped)
  {
    light.Direction = glm::normalize(Round(light.Direction, 1.0 / LightSteps));
    const double size = std::exp2(std::floor(std::log2(glm::length(light.Position - center))));
    if (light.Positional && std::isfinite(size) && size > 0.0)
    {
      light.Position = Round(light.Position, size / LightSteps);
    }
  }
  return stepped;
}

//------------------------------------------------------------------------------
double vtkRelievoProbeView::GetFirst(
  const vtkRelievoFrameCamera& view, const std::vector<vtkRelievoBox>& boxes)
{
  const auto cut = [&view](const vtkRelievoBox& box) {
    double low = 1e300;
    double high = -1e300;
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec4 corner(i & 1 ? box.Max.x : box.Min.x, i & 2 ? box.Max.y : box.Min.y,
        i & 4 ? box.Max.z : box.Min.z, 1.0);
      const double depth = -(view.WorldToView * corner).z;
      low = std::min(low, depth);
      high = std::max(high, depth);
    }
    return low < view.Near && high > (view.Parallel ? -1e300 : 0.0);
  };
  if (!(view.Far > view.Near) || std::none_of(boxes.begin(), boxes.end(), cut))
  {
    return std::numeric_limits<double>::lowest();
  }
  if (view.Parallel)
  {
    const double step = std::exp2(std::floor(std::log2(view.Far - view.Near))) / 64.0;
    return step * std::floor(view.Near / step);
  }
  return view.Near > 0.0 ? std::exp2(std::floor(8.0 * std::log2(view.Near)) / 8.0) : 0.0;
}

//------------------------------------------------------------------------------
glm::dvec4 vtkRelievoProbeView::GetPart(
  const std::vector<vtkRelievoBox>& boxes, const glm::dmat4& worldToNDC)
{
  glm::dvec2 low(1.0);
  glm::dvec2 high(-1.0);
  for (const glm::dvec3& point :
    vtkRelievoShadowRegion::GetPoints(vtkRelievoShadowRegion::Cut(boxes, worldToNDC)))
  {
    const glm::dvec4 clip = worldToNDC * glm::dvec4(point, 1.0);
    if (!(clip.w > 0.0))
    {
      return glm::dvec4(0.0, 0.0, 1.0, 1.0);
    }
    low = glm::min(low, glm::dvec2(clip) / clip.w);
    high = glm::max(high, glm::dvec2(clip) / clip.w);
  }
  low = glm::clamp(low, -1.0, 1.0);
  high = glm::clamp(high, -1.0, 1.0);
  return high.x > low.x && high.y > low.y ? glm::dvec4(0.5 * low + 0.5, 0.5 * (high - low))
                                          : glm::dvec4(0.0, 0.0, 1.0, 1.0);
}

//------------------------------------------------------------------------------
vtkRelievoFrameCamera vtkRelievoProbeView::GetPicture(
  const vtkRelievoFrameCamera& view, vtkRenderer* renderer)
{
  vtkRelievoFrameCamera picture = view;
  const glm::dmat4 toPicture = vtkRelievoGetTileToPicture(renderer);
  picture.ViewToNDC = toPicture * view.ViewToNDC;
  for (int axis = 0; axis < 2; ++axis)
  {
    int& pixels = picture.Viewport[2 + axis];
    pixels = static_cast<int>(std::lround(pixels / toPicture[axis][axis]));
  }
  return picture;
}
