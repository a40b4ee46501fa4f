// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A grid of sizes, places and angles for maps: so coarse that most camera moves leave a map
// unchanged, and independent of the camera's history.
#ifndef vtkRelievoShadowSnapping_h
#define vtkRelievoShadowSnapping_h

#include "vtkRelievoShadowRegion.h"

namespace vtkRelievoShadowSnapping
{
// Tolerance for equal numbers, so that rounding does not change a choice.
constexpr double Rounding = 1e-6;

// The smallest of whole * 2^(-k / perOctave), k = 0, 1, ..., not below the value; `whole` for
// larger values.
double Up(double value, double whole, int perOctave);

// Widens an interval to one of the grid of its whole: lengths are powers of two, places are
// multiples of a share of the length.
void Snap(double& low, double& high, double wholeLow, double wholeHigh);

// The smallest of a few rectangles around the hull of the visible region. They are given by the
// hull of the whole scene, which contains it, and a first angle.
vtkRelievoShadowRegion::Rectangle Enclose(const std::vector<glm::dvec2>& hull,
  const std::vector<glm::dvec2>& whole, double angle, int turns);

// The nearest of a grid of directions.
glm::dvec3 Direction(const glm::dvec3& v);
}

#endif
