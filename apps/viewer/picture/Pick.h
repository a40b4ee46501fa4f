// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is seen at a pixel of the picture, as a place in the world.
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
}

#endif
