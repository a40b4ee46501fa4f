// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowPixels.h"

#include "vtkRelievoShadowLight.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr double ConeMargin = 1e-3; // of its cosine
}

//------------------------------------------------------------------------------
vtkRelievoShadowPixels::vtkRelievoShadowPixels(const vtkRelievoView& view, const glm::dvec3& center)
  : ViewToScene(glm::inverse(view.WorldToView))
  , ViewToNDC(view.ViewToNDC)
  , Size(view.Viewport[2], view.Viewport[3])
  , Parallel(view.Parallel)
{
  this->ViewToScene[3] -= glm::dvec4(center, 0.0);
}

//------------------------------------------------------------------------------
vtkRelievoPixelRay vtkRelievoShadowPixels::GetRay(double x, double y) const
{
  const glm::dvec2 ndc = 2.0 * glm::dvec2(x, y) / this->Size - 1.0;
  const glm::dmat4& p = this->ViewToNDC;
  const int column = this->Parallel ? 3 : 2;
  const double sign = this->Parallel ? -1.0 : 1.0;
  const glm::dvec2 at(
    (ndc.x + sign * p[column][0]) / p[0][0], (ndc.y + sign * p[column][1]) / p[1][1]);
  const glm::dvec3 from = this->Parallel ? glm::dvec3(at, 0.0) : glm::dvec3(0.0);
  const glm::dvec3 ray = this->Parallel ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(at, -1.0);
  return { glm::dvec3(this->ViewToScene * glm::dvec4(from, 1.0)),
    glm::dmat3(this->ViewToScene) * ray };
}

//------------------------------------------------------------------------------
vtkRelievoToLight::vtkRelievoToLight(
  const vtkRelievoShadowLight& light, const glm::dvec3& place, const glm::dvec3& center)
{
  if (!light.Positional)
  {
    this->Ray = -light.Direction;
    this->Last = std::numeric_limits<double>::infinity();
    return;
  }
  this->Ray = light.Position - center - place;
  this->Last = 1.0;
  const double distance = glm::length(this->Ray);
  const double cosine = std::cos(glm::radians(light.ConeAngle));
  this->Lights = distance > 0.0 && (light.Reach <= 0.0 || distance < light.Reach) &&
    (!light.IsSpot() || glm::dot(-this->Ray, light.Direction) / distance >= cosine + ConeMargin);
}

//------------------------------------------------------------------------------
bool vtkRelievoMeetsAny(const std::vector<vtkRelievoBox>& boxes, const glm::dvec3& center,
  const glm::dvec3& from, const glm::dvec3& ray, double last)
{
  return std::any_of(boxes.begin(), boxes.end(), [&](const vtkRelievoBox& box) {
    double low = 0.0;
    double high = last;
    for (int i = 0; i < 3; ++i)
    {
      const double inverse = 1.0 / (std::abs(ray[i]) > 1e-290 ? ray[i] : 1e-290);
      const double a = (box.Min[i] - center[i] - from[i]) * inverse;
      const double b = (box.Max[i] - center[i] - from[i]) * inverse;
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    }
    return low <= high;
  });
}
