// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the files of a picture hold, for panels to offer.
 */
#ifndef SceneFacts_h
#define SceneFacts_h

#include "Facts.h"
#include "LookOptions.h"

#include <array>
#include <optional>

namespace viewer
{
class Picture;

Facts GetFacts(const Picture& picture);

/// Values of the first and the last colour; none: no values give the colours.
std::optional<std::array<double, 2>> GetColorRange(const Picture& picture);

/// The layer of the array that gives the colours; empty: surfaces have none, only volumes.
std::string FindColorLayer(const scene::LookChoice& look, const Facts& facts);

/// The least and the greatest value that is seen of the array that gives the colours; by
/// logarithms, of those above zero. It draws the array's layer beside the picture. None: there is
/// no array, or fewer than two values are seen.
std::optional<std::array<double, 2>> FindSeenRange(
  const Picture& picture, const scene::LookChoice& look, const Facts& facts);

/// Those of the layer that is shown, in the last picture; infinite or equal: none.
std::array<double, 2> GetShownRange(const Picture& picture);
}

#endif
