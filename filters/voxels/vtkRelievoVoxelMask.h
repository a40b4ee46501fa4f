// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From what columns cross to one byte per cell, and to distances along the axes.
#ifndef vtkRelievoVoxelMask_h
#define vtkRelievoVoxelMask_h

#include "vtkRelievoVoxelColumns.h"

#include <array>
#include <vector>

namespace vtkRelievoVoxelMask
{
// 1 for cells whose centre lies between the first and the last crossing of its column along every
// viewed axis, else 0. Returns how many are 1.
std::int64_t FromViews(const std::vector<vtkRelievoVoxelViews>& views,
  const vtkRelievoVoxelGrid& grid, unsigned char* mask);

// 1 behind an odd number of crossings along one axis.
std::int64_t FromParity(const vtkRelievoVoxelParity& parity, int axis,
  const vtkRelievoVoxelGrid& grid, unsigned char* mask);

// 1 where more of the three axes say inside than outside; open columns do not vote.
std::int64_t FromVote(const std::vector<vtkRelievoVoxelParity>& axes,
  const vtkRelievoVoxelGrid& grid, unsigned char* mask);

// World units from the first crossing of the cell's column to the cell's centre, and from there to
// the last crossing, one component per viewed axis: both are positive in between, and NaN in
// columns without a crossing.
void Distances(const std::vector<vtkRelievoVoxelViews>& views, const vtkRelievoVoxelGrid& grid,
  float* front, float* back);

// What a grid takes, output included: for parity along all axes, or for views along one axis, or
// along three (-1).
double EstimateBytes(const std::array<double, 3>& cells, bool parity, int axis, bool distances);
}

#endif
