// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowSnapping.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

using vtkRelievoShadowRegion::Rectangle;

namespace
{
// A map is at most 2^(1/16), 1.05 times, longer than necessary, and a little more for its place.
constexpr int SizesPerOctave = 16;
constexpr int PlacesPerLength = 16;
constexpr double Shortest = 1e-9; // share of the whole

// Directions per half side of a cube: at most 14 degrees apart.
constexpr double DirectionSteps = 4.0;
}

//------------------------------------------------------------------------------
double vtkRelievoShadowSnapping::Up(double value, double whole, int perOctave)
{
  if (!(value > 0.0) || !(value < whole))
  {
    return whole;
  }
  return whole *
    std::exp2(-std::floor(perOctave * std::log2(whole / value) + Rounding) / perOctave);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowSnapping::Snap(double& low, double& high, double wholeLow, double wholeHigh)
{
  const double whole = wholeHigh - wholeLow;
  const double least = std::max(high - low, Shortest * whole);
  if (whole > 0.0)
  {
    for (double k = std::floor(SizesPerOctave * std::log2(whole / least) + Rounding); k > 0.0; --k)
    {
      const double length = whole * std::exp2(-k / SizesPerOctave);
      const double step = length / PlacesPerLength;
      const double from = std::min(
        wholeLow + step * std::floor((low - wholeLow) / step + Rounding), wholeHigh - length);
      if (high <= from + length + Rounding * step)
      {
        low = from;
        high = from + length;
        return;
      }
    }
  }
  low = wholeLow;
  high = wholeHigh;
}

//------------------------------------------------------------------------------
Rectangle vtkRelievoShadowSnapping::Enclose(const std::vector<glm::dvec2>& hull,
  const std::vector<glm::dvec2>& whole, double angle, int turns)
{
  Rectangle best;
  for (int i = 0; i < turns; ++i)
  {
    const double turned = angle + 0.5 * vtkMath::Pi() * i / turns;
    Rectangle rectangle = vtkRelievoShadowRegion::EncloseAt(hull, turned);
    const Rectangle all = vtkRelievoShadowRegion::EncloseAt(whole, turned);
    Snap(rectangle.Min.x, rectangle.Max.x, all.Min.x, all.Max.x);
    Snap(rectangle.Min.y, rectangle.Max.y, all.Min.y, all.Max.y);
    if (i == 0 || rectangle.GetLength() < (1.0 - Rounding) * best.GetLength())
    {
      best = rectangle;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoShadowSnapping::Direction(const glm::dvec3& v)
{
  const glm::dvec3 size = glm::abs(v);
  const glm::dvec3 onCube = v * (DirectionSteps / std::max({ size.x, size.y, size.z }));
  return glm::normalize(glm::floor(onCube + 0.5 + Rounding));
}
