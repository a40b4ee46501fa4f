// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The distance of each cell from the nearest cell that is 1.
#ifndef vtkRelievoVoxelDistance_h
#define vtkRelievoVoxelDistance_h

#include <array>
#include <vector>

namespace vtkRelievoVoxelDistance
{
// Squared distances between centres, exact except for rounding; infinity if no cell is 1. By
// parabolas, one axis at a time (Felzenszwalb and Huttenlocher 2012).
std::vector<float> Squared(
  const unsigned char* mask, const std::array<int, 3>& cells, const std::array<double, 3>& spacing);
}

#endif
