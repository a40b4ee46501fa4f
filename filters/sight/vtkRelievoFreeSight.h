// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a surface point is the first hit of a ray to it, within rounding.
#ifndef vtkRelievoFreeSight_h
#define vtkRelievoFreeSight_h

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

// `nearest`: the distance of the first hit from the origin.
inline bool vtkRelievoIsFree(double nearest, const double origin[3], const double point[3])
{
  constexpr double share = 1e-9; // of the distance
  constexpr double steps =
    64.0; // units in the last place of the largest coordinate, which moves the ray
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    largest = std::max({ largest, std::abs(origin[i]), std::abs(point[i]) });
  }
  const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(origin, point));
  const double off = share * distance + steps * std::numeric_limits<double>::epsilon() * largest;
  return nearest >= distance - off;
}

#endif
