// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sizes, places and turns that maps may have: few enough that most moves of the camera leave a
// map as it is, which it then is however the camera came there.
#ifndef vtkRelievoShadowSnapping_h
#define vtkRelievoShadowSnapping_h

#include "vtkRelievoShadowRegion.h"

namespace vtkRelievoShadowSnapping
{
// Of numbers that are equal but for rounding, always the same one is taken.
constexpr double Rounding = 1e-6;

// The least of whole * 2^(-k / perOctave), k = 0, 1, ..., that is not below the value; `whole` for
// what is above it.
double Up(double value, double whole, int perOctave);

// Widens an interval to one of those that its whole is divided into: in length by powers of two,
// in place by shares of the length.
void Snap(double& low, double& high, double wholeLow, double wholeHigh);

// The smallest of a few rectangles around the hull of what is in view. They follow from the hull of
// the whole scene, which the other is a part of, and start at an angle.
vtkRelievoShadowRegion::Rectangle Enclose(const std::vector<glm::dvec2>& hull,
  const std::vector<glm::dvec2>& whole, double angle, int turns);

// Of a grid of directions, the nearest.
glm::dvec3 Direction(const glm::dvec3& v);
}

#endif
