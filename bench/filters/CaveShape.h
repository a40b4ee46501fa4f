// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CaveShape.h
 * @brief Properties of a mask of caves: share of air, number of components, width.
 */
#ifndef relievoBenchCaveShape_h
#define relievoBenchCaveShape_h

#include <array>
#include <vector>

namespace relievoBench
{
struct CaveShape
{
  double Air = 0.;        // share of the samples
  long Components = 0;    // parts of the air that do not touch, not even at a corner
  long Euler = 0;         // of the air's closed cubes: components - tunnels + cavities
  double LevelWidth = 0.; // mean length of air along x and y, samples
  double UprightWidth = 0.;
  double Largest = 0.; // share of the air in the largest component
};

/** Measures a mask, x fastest, 1 where there is air. */
CaveShape MeasureCaves(const std::vector<unsigned char>& mask, const std::array<int, 3>& size);
}

#endif
