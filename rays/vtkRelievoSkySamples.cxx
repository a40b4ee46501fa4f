// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSkySamples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
constexpr double GoldenRatio = 0.6180339887498949;
constexpr double Spread = 0.5698402909980532; // from x^3 = x + 1, to the power of -2: out of phase

double GetPart(double value)
{
  return value - std::floor(value);
}
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoSkySamples::Point> vtkRelievoSkySamples::Get(int samples, bool spread)
{
  std::vector<int> order(static_cast<std::size_t>(samples));
  for (int i = 0; i < samples; ++i)
  {
    order[static_cast<std::size_t>(i)] = i;
  }
  if (spread)
  {
    std::stable_sort(order.begin(), order.end(),
      [](int a, int b) { return GetPart(a * Spread) < GetPart(b * Spread); });
  }
  std::vector<Point> points;
  points.reserve(order.size());
  for (const int i : order)
  {
    points.push_back({ static_cast<double>(i) / samples, GetPart(i * GoldenRatio) });
  }
  return points;
}
