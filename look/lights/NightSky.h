// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The background of presets when the sun is low or has set.
 */
#ifndef NightSky_h
#define NightSky_h

#include "LightOptions.h"
#include "LookNames.h"

#include <array>
#include <optional>
#include <vector>

namespace look
{
/// The greatest elevation, in degrees, of suns given by time or angles; none: there are none. Those
/// by angles are never below 0: they light from beneath.
std::optional<double> FindSunElevation(const std::vector<LightChoice>& lights);

/// Colours of a background from bottom to top, as they are at noon, for an elevation of the sun:
/// dark below -18 degrees. `outdoors`: reddish above the horizon at dusk.
std::vector<std::array<double, 3>> DarkenSky(
  const std::vector<std::array<double, 3>>& colors, bool outdoors, double elevation);
}

#endif
