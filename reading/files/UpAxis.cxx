// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UpAxis.h"

#include "Readers.h"

#include <algorithm>
#include <cmath>

namespace reading
{
namespace
{
// Largest height of a flat mesh, as a share of both its width and its length.
constexpr double LowShare = 0.34;
}

//------------------------------------------------------------------------------
int FindUpAxis(const std::string& path, const double bounds[6])
{
  if (IsModel(path))
  {
    return 1; // y is up in these formats, or their readers make it so
  }
  const auto extent = [bounds](int axis) { return bounds[2 * axis + 1] - bounds[2 * axis]; };
  const double largest = std::max({ extent(0), extent(1), extent(2) });
  const auto standsOn = [&](int axis) {
    return extent(axis) > 1e-3 * largest && std::abs(bounds[2 * axis]) <= 1e-3 * largest;
  };
  // A mesh that is low along z lies flat: a terrain, a plate, a scan of the ground. A mesh that
  // stands on y = 0 over the origin is a figure; a terrain may begin there too, but then x begins
  // at the origin as well.
  const bool low =
    extent(2) > 1e-3 * largest && extent(2) < LowShare * std::min(extent(0), extent(1));
  const bool overOrigin = std::min(-bounds[0], bounds[1]) > 1e-3 * largest;
  if (low && !(standsOn(1) && overOrigin))
  {
    return 2;
  }
  if (standsOn(1) != standsOn(2))
  {
    return standsOn(2) ? 2 : 1;
  }
  if (low)
  {
    return 2;
  }
  return HasZUp(path) && extent(2) > 1e-3 * largest ? 2 : 1;
}
}
