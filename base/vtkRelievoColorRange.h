// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The range of a colour map for values that are all the same, or would be without rounding.
#ifndef vtkRelievoColorRange_h
#define vtkRelievoColorRange_h

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace relievo
{
// Relative rounding error of values of an array's type, and of magnitudes.
inline double GetRounding(int type)
{
  constexpr double steps = 8.0;
  return type == VTK_FLOAT ? steps * std::numeric_limits<float>::epsilon()
    : type == VTK_DOUBLE   ? steps * std::numeric_limits<double>::epsilon()
                           : 0.0;
}

// Whether the values of a range differ only by rounding: a colour map over it would show noise.
inline bool IsOneValue(const std::array<double, 2>& range, double rounding)
{
  const double size = std::max(std::abs(range[0]), std::abs(range[1]));
  return range[0] <= range[1] && range[1] - range[0] <= rounding * size;
}

// From zero to the value: a mesh that is seen as a whole looks seen, and rounding changes no
// colour, however large the value is.
inline std::array<double, 2> GetRangeOfOneValue(double value)
{
  return { std::min(value, 0.0), value == 0.0 ? 1.0 : std::max(value, 0.0) };
}
}

#endif
