// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NightSky.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace look
{
namespace
{
// Factors of displayed colours. Civil, nautical and astronomical twilight end at -6, -12 and -18
// degrees; a sky of their true luminances would be black long before.
struct Hour
{
  double Elevation;
  std::array<double, 3> Horizon, Above;
};

constexpr Hour Hours[] = {
  { -18.0, { 0.10, 0.11, 0.15 }, { 0.10, 0.11, 0.14 } },
  { -12.0, { 0.17, 0.19, 0.26 }, { 0.16, 0.17, 0.22 } },
  { -6.0, { 0.45, 0.40, 0.46 }, { 0.32, 0.32, 0.40 } },
  { 0.0, { 0.98, 0.78, 0.62 }, { 0.76, 0.74, 0.78 } },
  { 4.0, { 1.0, 0.94, 0.86 }, { 0.94, 0.95, 0.96 } },
  { 10.0, { 1.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0 } },
};
}

//------------------------------------------------------------------------------
std::optional<double> FindSunElevation(const std::vector<LightChoice>& lights)
{
  std::optional<double> highest;
  for (const LightChoice& light : lights)
  {
    const std::optional<SunAngles> angles = light.GetAngles();
    if (angles)
    {
      const double lowest = light.Time ? -90.0 : 0.0; // a sun by angles lights from beneath
      highest = std::max({ highest.value_or(lowest), lowest, angles->Elevation });
    }
  }
  return highest;
}

//------------------------------------------------------------------------------
std::vector<std::array<double, 3>> DarkenSky(
  const std::vector<std::array<double, 3>>& colors, bool outdoors, double elevation)
{
  const double at =
    std::clamp(elevation, std::begin(Hours)->Elevation, std::prev(std::end(Hours))->Elevation);
  const Hour* after = std::find_if(std::next(std::begin(Hours)), std::prev(std::end(Hours)),
    [at](const Hour& hour) { return at <= hour.Elevation; });
  const Hour* before = std::prev(after);
  const double share = (at - before->Elevation) / (after->Elevation - before->Elevation);
  std::vector<std::array<double, 3>> darker = colors;
  for (std::array<double, 3>& color : darker)
  {
    const auto factors = outdoors && &color == &darker.front() ? &Hour::Horizon : &Hour::Above;
    for (std::size_t i = 0; i < 3; ++i)
    {
      color[i] *= (1.0 - share) * (before->*factors)[i] + share * (after->*factors)[i];
    }
  }
  return darker;
}
}
