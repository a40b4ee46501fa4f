// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Properties of a picture's files that panels offer.
 */
#ifndef SceneFacts_h
#define SceneFacts_h

#include "Facts.h"
#include "LayerWords.h"
#include "LookOptions.h"

#include <array>
#include <optional>

namespace viewer
{
class Picture;

Facts GetFacts(const Picture& picture);

/// Values of the first and last colour; none: values do not give the colours.
std::optional<std::array<double, 2>> GetColorRange(const Picture& picture);

/// Whether values give colours: of surfaces, or of volumes.
bool HasColorsOfValues(const Picture& picture);

/// The layer of the array that gives the colours; empty: no surface has it, only volumes.
std::string FindColorLayer(const look::LookChoice& look, const Facts& facts);

/// The smallest and largest visible value of the array that gives the colours; for logarithmic
/// maps, of positive values. Draws the array's layer without changing the picture. None: no array,
/// or fewer than two visible values.
std::optional<std::array<double, 2>> FindSeenRange(
  const Picture& picture, const look::LookChoice& look, const Facts& facts);

/// The range of the layer shown in the last picture; infinite or equal: none.
std::array<double, 2> GetShownRange(const Picture& picture);

/// Names of the lights that cast shadows.
relievoQt::LightNames GetLightNames(const Picture& picture);
}

#endif
