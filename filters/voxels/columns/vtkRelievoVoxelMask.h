// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Converts crossings of columns to one byte per cell, and to distances along the axes.
#ifndef vtkRelievoVoxelMask_h
#define vtkRelievoVoxelMask_h

#include "vtkRelievoVoxelColumns.h"

#include <array>
#include <vector>

namespace vtkRelievoVoxelMask
{
// Sets cells to 1 if their centre lies between the first and the last crossing of their column
// along every viewed axis, otherwise to 0. Returns the number of cells set to 1.
std::int64_t FromViews(const std::vector<vtkRelievoVoxelViews>& views,
  const vtkRelievoVoxelGrid& grid, unsigned char* mask);

// Sets cells to 1 behind an odd number of crossings along one axis.
std::int64_t FromParity(const vtkRelievoVoxelParity& parity, int axis,
  const vtkRelievoVoxelGrid& grid, unsigned char* mask);

// Sets cells to 1 if more of the three axes vote inside than outside; open columns do not vote.
std::int64_t FromVote(const std::vector<vtkRelievoVoxelParity>& axes,
  const vtkRelievoVoxelGrid& grid, unsigned char* mask);

// World units from the first crossing of a cell's column to its centre, and from there to the last
// crossing, one component per viewed axis: both positive in between, and NaN in columns without a
// crossing.
void Distances(const std::vector<vtkRelievoVoxelViews>& views, const vtkRelievoVoxelGrid& grid,
  float* front, float* back);

// Estimates the bytes of a grid, output included: for parity along all axes, or for views along one
// axis, or along three (-1).
double EstimateBytes(const std::array<double, 3>& cells, bool parity, int axis, bool distances);
}

#endif
