// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Places in the world, and where the picture has them.
 */
#ifndef Pick_h
#define Pick_h

#include <array>
#include <optional>

namespace viewer
{
class Picture;
class Probe;

/// The surface there, by the layers, or the ground below the scene; none where neither is. Pixels
/// count from the lower left.
std::optional<std::array<double, 3>> Pick(const Picture& picture, Probe& probe, int x, int y);

/// Where a place is seen in a picture that is not empty: from -1 to 1 from left to right and from
/// bottom to top, and beyond that outside. What is behind the camera is outside.
std::array<double, 2> Project(const Picture& picture, const std::array<double, 3>& place);

/// The place behind a pixel that is as far along the view as `from`, or as what the camera turns
/// about where that is behind the camera.
std::array<double, 3> MoveInView(
  const Picture& picture, const std::array<double, 3>& from, int x, int y);
}

#endif
