// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cells of an image, and its columns of cells along an axis. Grid coordinates: the centre of
// cell i along an axis is at i.
#ifndef vtkRelievoVoxelGrid_h
#define vtkRelievoVoxelGrid_h

#include <array>
#include <cstddef>
#include <cstdint>

struct vtkRelievoVoxelGrid
{
  std::array<double, 3> Origin{ { 0., 0., 0. } }; // the lower corner of cell 0 0 0
  std::array<double, 3> Spacing{ { 1., 1., 1. } };
  std::array<int, 3> Cells{ { 0, 0, 0 } };

  double ToGrid(double place, int axis) const
  {
    return (place - this->Origin[axis]) / this->Spacing[axis] - 0.5;
  }
  double ToWorld(double index, int axis) const
  {
    return this->Origin[axis] + (index + 0.5) * this->Spacing[axis];
  }
  std::int64_t GetNumberOfCells() const
  {
    return static_cast<std::int64_t>(this->Cells[0]) * this->Cells[1] * this->Cells[2];
  }

  // The axes across the columns, in memory order.
  static int GetColumn(int axis) { return axis == 0 ? 1 : 0; }
  static int GetRow(int axis) { return axis == 2 ? 1 : 2; }
  std::int64_t GetNumberOfColumns(int axis) const
  {
    return static_cast<std::int64_t>(this->Cells[GetColumn(axis)]) * this->Cells[GetRow(axis)];
  }
  // The column along the axis that contains a cell.
  std::size_t ColumnOf(int axis, int i, int j, int k) const
  {
    const std::array<int, 3> cell{ { i, j, k } };
    return static_cast<std::size_t>(cell[GetRow(axis)]) *
      static_cast<std::size_t>(this->Cells[GetColumn(axis)]) +
      static_cast<std::size_t>(cell[GetColumn(axis)]);
  }
};

#endif
