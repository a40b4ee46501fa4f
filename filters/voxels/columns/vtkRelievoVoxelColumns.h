// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Crossings of a grid's columns along one axis: the first and the last position (as two
// orthographic depth maps see them), or, as bits, the cells behind an odd number of crossings.
#ifndef vtkRelievoVoxelColumns_h
#define vtkRelievoVoxelColumns_h

#include "vtkRelievoVoxelGrid.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

class vtkRelievoVoxelSurface;

// Two depth maps: the first and the last crossing of each column, in grid coordinates along the
// axis; +infinity and -infinity if there is none.
struct vtkRelievoVoxelViews
{
  int Axis = 0;
  std::vector<double> Front;
  std::vector<double> Back;

  static vtkRelievoVoxelViews Of(
    const vtkRelievoVoxelSurface& surface, const vtkRelievoVoxelGrid& grid, int axis);
};

// Bit k of a column: whether cell k is behind an odd number of crossings. Single-pass solid
// voxelisation (Eisemann and Decoret 2008), in double: a crossing flips one bit by exclusive or,
// and a scan along the words then propagates it. The bit after the last cell is set in open
// columns.
class vtkRelievoVoxelParity
{
public:
  vtkRelievoVoxelParity(
    const vtkRelievoVoxelSurface& surface, const vtkRelievoVoxelGrid& grid, int axis);

  std::int64_t GetNumberOfOpenColumns() const { return this->Open; }

  bool IsInside(std::size_t column, int cell) const
  {
    return this->GetWord(column, cell / 64) >> (cell % 64) & 1U;
  }
  bool IsOpen(std::size_t column) const { return this->IsInside(column, this->Cells); }
  std::uint64_t GetWord(std::size_t column, int word) const
  {
    return this->Words[column * this->WordsPerColumn + static_cast<std::size_t>(word)].load(
      std::memory_order_relaxed);
  }

  static std::int64_t GetBytes(const vtkRelievoVoxelGrid& grid, int axis);

private:
  void Spread(std::int64_t columns);

  int Cells = 0; // per column
  std::size_t WordsPerColumn = 0;
  std::unique_ptr<std::atomic<std::uint64_t>[]> Words;
  std::int64_t Open = 0;
};

#endif
