// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowPixels.h"

#include "vtkRelievoShadowLight.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr double ConeMargin = 1e-3; // tolerance of its cosine
}

//------------------------------------------------------------------------------
vtkRelievoShadowPixels::vtkRelievoShadowPixels(
  const vtkRelievoFrameCamera& view, const glm::dvec3& center)
  : ViewToScene(glm::inverse(view.WorldToView))
  , ViewToNDC(view.ViewToNDC)
  , Size(view.Viewport[2], view.Viewport[3])
{
  this->ViewToScene[3] -= glm::dvec4(center, 0.0);
}

//------------------------------------------------------------------------------
vtkRelievoPixelRay vtkRelievoShadowPixels::GetRay(double x, double y) const
{
  const glm::dvec2 ndc = 2.0 * glm::dvec2(x, y) / this->Size - 1.0;
  const glm::dmat4& p = this->ViewToNDC;
  // x and y visible in the view, as a linear function of z; projections may be sheared.
  glm::dmat2 slope;
  glm::dvec2 constant;
  glm::dvec2 alongZ;
  for (int row = 0; row < 2; ++row)
  {
    slope[0][row] = p[0][row] - ndc[row] * p[0][3];
    slope[1][row] = p[1][row] - ndc[row] * p[1][3];
    alongZ[row] = ndc[row] * p[2][3] - p[2][row];
    constant[row] = ndc[row] * p[3][3] - p[3][row];
  }
  const glm::dmat2 back = glm::inverse(slope);
  const glm::dvec3 from(back * constant, 0.0);
  const glm::dvec3 ray(-(back * alongZ), -1.0);
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
