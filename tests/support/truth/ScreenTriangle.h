// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ScreenTriangle.h
 * @brief A triangle as drawn in a view: a convex polygon in pixels.
 */
#ifndef relievoTestScreenTriangle_h
#define relievoTestScreenTriangle_h

#include "View.h"

#include <array>

namespace relievoTest
{
/** The projected part of a triangle in front of the near plane; may be empty. */
class ScreenTriangle
{
public:
  ScreenTriangle(const View& view, const std::array<glm::dvec3, 3>& corners);

  /** Smallest extent in any direction, in pixels; 0 for an empty or edge-on triangle. */
  double Width() const;

  /** Distance in pixels from a place to the nearest edge: positive inside, negative outside. */
  double Distance(const glm::dvec2& pixel) const;

private:
  // A triangle cut by one plane has at most four corners.
  std::array<glm::dvec2, 4> Points;
  int Count = 0;
};
}

#endif
