// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UpAxis.h"

#include "OptionRows.h"
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
  if (IsRaster(path))
  {
    return 2; // also for level ground
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

//------------------------------------------------------------------------------
void AddUpOption(OptionRows& rows, int& axis)
{
  rows
    .AddChoice("--up", "AXIS", { "x", "y", "z" },
      "the up axis, @choices@, of --environment, the fitted camera, the ground, "
      "--texture-coordinates and the shadows of --markers (y with --preset none; else by "
      "the first file: y for models; z for GeoTIFFs, and for data that is low along z, unless it "
      "stands on y = 0 like a figure; y or z for data that stands on y = 0 or on z = 0; else z for "
      "STL and grids with depth, y for others)",
      [&axis](std::size_t place) { axis = static_cast<int>(place); })
    .Is(OptionRows::Option::READS_FILES | OptionRows::Option::SHAPES_SURFACE)
    .NamedIn("Scene", "Up")
    .DropAs("the up axis");
}
}
