// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Places and directions as three numbers.
 */
#ifndef Triples_h
#define Triples_h

#include <array>
#include <cmath>
#include <vector>

namespace words
{
inline std::array<double, 3> Triple(const std::vector<double>& numbers, std::size_t first)
{
  return { numbers[first], numbers[first + 1], numbers[first + 2] };
}

inline std::array<double, 3> Minus(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline double Length(const std::array<double, 3>& v)
{
  return std::hypot(v[0], v[1], v[2]);
}
}

#endif
