// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FogTruth.h
 * @brief The length of a pixel's ray inside a sphere, in long double, from the camera's matrices.
 */
#ifndef relievoTestFogTruth_h
#define relievoTestFogTruth_h

#include <vtkRelievoFrameCamera.h>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace relievoTest
{
using Long3 = glm::tvec3<long double, glm::highp>;

/** The point of a pixel's ray at a depth; pixels from the viewport's lower left corner. */
inline Long3 PointAt(const vtkRelievoFrameCamera& view, double x, double y, long double depth)
{
  const glm::dmat4& p = view.ViewToNDC;
  const long double ndc[2] = { 2.0L * x / view.Viewport[2] - 1.0L,
    2.0L * y / view.Viewport[3] - 1.0L };
  const long double z = -depth;
  const long double w = p[2][3] * z + p[3][3];
  const long double right[2] = { ndc[0] * w - (p[2][0] * z + p[3][0]),
    ndc[1] * w - (p[2][1] * z + p[3][1]) };
  const long double a = p[0][0];
  const long double b = p[1][0];
  const long double c = p[0][1];
  const long double d = p[1][1];
  const long double determinant = a * d - b * c;
  return { (right[0] * d - right[1] * b) / determinant, (right[1] * a - right[0] * c) / determinant,
    z };
}

/**
 * The length inside the sphere of the ray from its beginning (the eye; in parallel projection depth
 * 0, or the near plane if that is behind) to `end`, a depth. `center` is in eye space.
 */
inline long double ChordTruth(const vtkRelievoFrameCamera& view, double x, double y,
  const glm::dvec3& center, double radius, double end)
{
  const long double begin = std::min(0.0, view.Near);
  const Long3 origin = PointAt(view, x, y, begin);
  const Long3 step = PointAt(view, x, y, begin + 1.0L) - origin; // per unit of depth
  const long double length = glm::length(step);
  const Long3 direction = step / length;
  const Long3 toCenter = Long3(center) - origin;
  const long double middle = glm::dot(toCenter, direction);
  const Long3 across = toCenter - middle * direction;
  const long double under =
    (radius - glm::length(across)) * (static_cast<long double>(radius) + glm::length(across));
  if (under <= 0.0L)
  {
    return 0.0L;
  }
  const long double half = std::sqrt(under);
  const long double last = (end - begin) * length;
  return std::max(0.0L, std::min(middle + half, last) - std::max(middle - half, 0.0L));
}

/** ChordTruth's length by summing steps: the closed form must agree within a step or two. */
inline long double ChordByQuadrature(const vtkRelievoFrameCamera& view, double x, double y,
  const glm::dvec3& center, double radius, double end, int steps)
{
  const double begin = std::min(0.0, view.Near);
  const Long3 origin = PointAt(view, x, y, begin);
  const Long3 step = PointAt(view, x, y, begin + 1.0L) - origin;
  const long double length = glm::length(step);
  const long double depth = -center.z;
  // All of the sphere lies between these depths.
  const long double first = std::max<long double>(begin, depth - radius);
  const long double last = std::min<long double>(end, depth + radius);
  if (last <= first)
  {
    return 0.0L;
  }
  int inside = 0;
  for (int i = 0; i < steps; ++i)
  {
    const long double at = first + (last - first) * (i + 0.5L) / steps;
    const Long3 offset = origin + (at - begin) * step - Long3(center);
    inside += glm::dot(offset, offset) < static_cast<long double>(radius) * radius ? 1 : 0;
  }
  return inside * ((last - first) / steps) * length;
}
}

#endif
