// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlockRule.h"

#include <algorithm>
#include <cstdlib>

namespace relievo
{
//------------------------------------------------------------------------------
BlockRule::BlockRule(double strength)
{
  const double edge = strength < 0.125 ? 2. * strength : strength + 0.125;
  this->Lengths = { 0., std::min(1.75 * strength, 7. / 32.), edge, std::min(3. * strength, 0.375) };
  for (unsigned int solid = 0; solid < 256; ++solid)
  {
    this->Pairs[solid] = StepsOf(solid);
    for (int axis = 0; axis < 3; ++axis)
    {
      const int pairs = this->Pairs[solid][axis];
      const double length = this->Lengths[std::abs(pairs)];
      this->Table[solid][axis] = pairs < 0 ? -length : length;
    }
  }
}

//------------------------------------------------------------------------------
BlockRule::Steps BlockRule::StepsOf(unsigned int solid)
{
  Steps steps = {};
  for (int axis = 0; axis < 3; ++axis)
  {
    const unsigned int upper = 1u << axis;
    int counts[2] = { 0, 0 }; // solid blocks on the lower and the upper side
    int full = 0;
    int empty = 0;
    for (unsigned int block = 0; block < 8; ++block)
    {
      if (block & upper)
      {
        continue;
      }
      const unsigned int low = solid >> block & 1u;
      const unsigned int high = solid >> (block | upper) & 1u;
      counts[0] += static_cast<int>(low);
      counts[1] += static_cast<int>(high);
      full += low && high;
      empty += !low && !high;
    }
    const int toSolid = (counts[1] > counts[0]) - (counts[1] < counts[0]);
    const int pairs = full && empty ? 0 : empty - full;
    steps[axis] = static_cast<signed char>(pairs * toSolid);
  }
  return steps;
}

//------------------------------------------------------------------------------
BlockRule::Offset BlockRule::Of(const std::array<vtkTypeInt64, 8>& labels) const
{
  unsigned int masks[8];
  int count = 0;
  for (unsigned int left = 0xff; left;)
  {
    unsigned int first = 0;
    while (!(left >> first & 1u))
    {
      ++first;
    }
    unsigned int mask = 0;
    for (unsigned int block = first; block < 8; ++block)
    {
      mask |= static_cast<unsigned int>(labels[block] == labels[first]) << block;
    }
    left &= ~mask;
    masks[count++] = mask;
  }
  if (count <= 2)
  {
    return this->Table[masks[0]];
  }
  // Counts first, so that the sum does not depend on the order of the labels.
  Offset offset;
  for (int axis = 0; axis < 3; ++axis)
  {
    int counts[4] = { 0, 0, 0, 0 };
    for (int i = 0; i < count; ++i)
    {
      const int pairs = this->Pairs[masks[i]][axis];
      counts[std::abs(pairs)] += (pairs > 0) - (pairs < 0);
    }
    offset[axis] =
      (counts[1] * this->Lengths[1] + counts[2] * this->Lengths[2] + counts[3] * this->Lengths[3]) *
      (2. / 3.) / count;
  }
  return offset;
}
}
