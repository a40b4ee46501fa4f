// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Converts between places in the world and in the picture.
 */
#ifndef Pick_h
#define Pick_h

#include <array>
#include <optional>

namespace viewer
{
class Picture;
class Probe;

/// The surface at a pixel, by the layers, or the ground below the scene; none for the background.
/// Pixels count from the lower left.
std::optional<std::array<double, 3>> Pick(const Picture& picture, Probe& probe, int x, int y);

/// Position of a place in a non-empty picture: -1 to 1 from left to right and from bottom to top,
/// and beyond that outside. Places behind the camera are outside.
std::array<double, 2> Project(const Picture& picture, const std::array<double, 3>& place);

/// The place behind a pixel at the depth of `from`, or of the focal point if `from` is behind the
/// camera.
std::array<double, 3> MoveInView(
  const Picture& picture, const std::array<double, 3>& from, int x, int y);
}

#endif
