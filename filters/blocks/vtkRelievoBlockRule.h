// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockRule.h
 * @brief Where the vertex between 2 x 2 x 2 blocks moves: one rule for one axis, used for all
 * three.
 *
 * Along an axis the eight blocks are four pairs. Pairs of two blocks of the label push the vertex
 * away from it, pairs without it towards it; in which direction that is, the side with more blocks
 * of the label says. Where both kinds of pairs are there, or none, or both sides are equal, the
 * vertex stays. One, two and three such pairs move it by 1.75, 2 and 3 times the strength, up to
 * 7/32, strength + 1/8 (once that is less than 2 times the strength), and 3/8 of a block.
 *
 * At strength 1/8 the two vertices of a step move by 1/4 each: a slope of 45 degrees. Beyond it
 * only edges become rounder: more would fold the faces around corners. All 2^16 neighbourhoods of a
 * face keep its triangles on their side, whichever diagonal cuts it (testSmoothBlocksRule).
 */
#ifndef vtkRelievoBlockRule_h
#define vtkRelievoBlockRule_h

#include "vtkType.h"

#include <array>

namespace relievo
{
class BlockRule
{
public:
  using Offset = std::array<double, 3>;

  /** Strength in blocks, in [0, 1/4]. */
  explicit BlockRule(double strength);

  /**
   * The movement, in blocks, of the vertex among eight blocks. Bit x + 2 y + 4 z of `solid` marks a
   * solid block, with 1 for the upper side of an axis. Complementary bits give the same movement.
   */
  const Offset& Of(unsigned int solid) const { return this->Table[solid]; }

  /**
   * The movement for blocks of many labels, in that order. With two labels, both give the same
   * movement; with more, it is two thirds of the mean over the labels.
   */
  Offset Of(const std::array<vtkTypeInt64, 8>& labels) const;

private:
  using Steps = std::array<signed char, 3>; // per axis: -3 to 3 pairs
  static Steps StepsOf(unsigned int solid);

  std::array<double, 4> Lengths = {};
  std::array<Steps, 256> Pairs = {};
  std::array<Offset, 256> Table = {};
};
}

#endif
