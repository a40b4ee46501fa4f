// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScreenTriangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relievoTest
{
namespace
{
double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}
}

//------------------------------------------------------------------------------
ScreenTriangle::ScreenTriangle(const View& view, const std::array<glm::dvec3, 3>& corners)
{
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& here = corners[i];
    const glm::dvec3& next = corners[(i + 1) % 3];
    const double before = view.Depth(here) - view.Near;
    const double after = view.Depth(next) - view.Near;
    if (before >= 0. && view.Project(here, this->Points[this->Count]))
    {
      ++this->Count;
    }
    if ((before < 0.) != (after < 0.))
    {
      const double share = before / (before - after);
      if (view.Project(here + share * (next - here), this->Points[this->Count]))
      {
        ++this->Count;
      }
    }
  }
}

//------------------------------------------------------------------------------
double ScreenTriangle::Width() const
{
  double width = this->Count < 3 ? 0. : std::numeric_limits<double>::infinity();
  for (int i = 0; i < this->Count; ++i)
  {
    const glm::dvec2& from = this->Points[i];
    const glm::dvec2 edge = this->Points[(i + 1) % this->Count] - from;
    const double length = glm::length(edge);
    if (length == 0.)
    {
      continue;
    }
    double extent = 0.;
    for (int j = 0; j < this->Count; ++j)
    {
      extent = std::max(extent, std::abs(Cross(edge, this->Points[j] - from)) / length);
    }
    width = std::min(width, extent);
  }
  return width;
}

//------------------------------------------------------------------------------
double ScreenTriangle::Distance(const glm::dvec2& pixel) const
{
  double area = 0.;
  for (int i = 2; i < this->Count; ++i)
  {
    area += Cross(this->Points[i - 1] - this->Points[0], this->Points[i] - this->Points[0]);
  }
  bool inside = this->Count >= 3;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < this->Count; ++i)
  {
    const glm::dvec2& from = this->Points[i];
    const glm::dvec2 edge = this->Points[(i + 1) % this->Count] - from;
    const glm::dvec2 offset = pixel - from;
    const double length2 = glm::dot(edge, edge);
    const double share = length2 > 0. ? glm::clamp(glm::dot(offset, edge) / length2, 0., 1.) : 0.;
    nearest = std::min(nearest, glm::length(offset - share * edge));
    inside = inside && Cross(edge, offset) * area >= 0.;
  }
  return inside ? nearest : -nearest;
}
}
