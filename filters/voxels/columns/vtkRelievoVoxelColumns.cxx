// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelColumns.h"

#include "vtkRelievoVoxelScan.h"
#include "vtkRelievoVoxelSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Lowers or raises a value that other threads also change.
template <typename Better>
void Improve(std::atomic<double>& current, double value, Better&& better)
{
  double old = current.load(std::memory_order_relaxed);
  while (
    better(value, old) && !current.compare_exchange_weak(old, value, std::memory_order_relaxed))
  {
  }
}

std::size_t CountWords(int cells)
{
  return static_cast<std::size_t>(cells) / 64 + 1;
}
}

//------------------------------------------------------------------------------
vtkRelievoVoxelViews vtkRelievoVoxelViews::Of(
  const vtkRelievoVoxelSurface& surface, const vtkRelievoVoxelGrid& grid, int axis)
{
  const auto columns = static_cast<std::size_t>(grid.GetNumberOfColumns(axis));
  const auto width = static_cast<std::size_t>(grid.Cells[vtkRelievoVoxelGrid::GetColumn(axis)]);
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  struct Ends
  {
    std::atomic<double> Front{ Infinity };
    std::atomic<double> Back{ -Infinity };
  };
  std::unique_ptr<Ends[]> ends(new Ends[columns]);
  surface.ForEach([&](const std::array<const double*, 3>& corners) {
    vtkRelievoScanTriangle(corners, axis, grid.Cells, [&](int column, int row, double depth) {
      Ends& both = ends[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)];
      Improve(both.Front, depth, [](double a, double b) { return a < b; });
      Improve(both.Back, depth, [](double a, double b) { return a > b; });
    });
  });
  vtkRelievoVoxelViews views;
  views.Axis = axis;
  views.Front.resize(columns);
  views.Back.resize(columns);
  for (std::size_t i = 0; i < columns; ++i)
  {
    views.Front[i] = ends[i].Front;
    views.Back[i] = ends[i].Back;
  }
  return views;
}

//------------------------------------------------------------------------------
vtkRelievoVoxelParity::vtkRelievoVoxelParity(
  const vtkRelievoVoxelSurface& surface, const vtkRelievoVoxelGrid& grid, int axis)
  : Cells(grid.Cells[axis])
  , WordsPerColumn(CountWords(grid.Cells[axis]))
{
  const std::int64_t columns = grid.GetNumberOfColumns(axis);
  this->Words.reset(
    new std::atomic<std::uint64_t>[static_cast<std::size_t>(columns) * this->WordsPerColumn]());
  const auto width = static_cast<std::size_t>(grid.Cells[vtkRelievoVoxelGrid::GetColumn(axis)]);
  surface.ForEach([&](const std::array<const double*, 3>& corners) {
    vtkRelievoScanTriangle(corners, axis, grid.Cells, [&](int column, int row, double depth) {
      // The first cell whose centre is at or behind the crossing.
      const auto cell = static_cast<std::size_t>(
        std::clamp(std::ceil(depth), 0., static_cast<double>(this->Cells)));
      const std::size_t at =
        static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
      this->Words[at * this->WordsPerColumn + cell / 64].fetch_xor(
        std::uint64_t{ 1 } << cell % 64, std::memory_order_relaxed);
    });
  });
  this->Spread(columns);
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelParity::Spread(std::int64_t columns)
{
  std::atomic<std::int64_t> open{ 0 };
  vtkSMPTools::For(0, columns, 1024, [&](vtkIdType begin, vtkIdType end) {
    std::int64_t found = 0;
    for (vtkIdType column = begin; column < end; ++column)
    {
      std::uint64_t before = 0; // all ones behind an odd number of crossings
      std::uint64_t bits = 0;
      for (std::size_t w = 0; w < this->WordsPerColumn; ++w)
      {
        std::atomic<std::uint64_t>& word =
          this->Words[static_cast<std::size_t>(column) * this->WordsPerColumn + w];
        bits = word.load(std::memory_order_relaxed);
        for (int shift = 1; shift < 64; shift *= 2)
        {
          bits ^= bits << shift;
        }
        bits ^= before;
        before = bits >> 63 ? ~std::uint64_t{ 0 } : 0;
        word.store(bits, std::memory_order_relaxed);
      }
      found += static_cast<std::int64_t>(bits >> this->Cells % 64 & 1U);
    }
    open += found;
  });
  this->Open = open;
}

//------------------------------------------------------------------------------
std::int64_t vtkRelievoVoxelParity::GetBytes(const vtkRelievoVoxelGrid& grid, int axis)
{
  return 8 * grid.GetNumberOfColumns(axis) *
    static_cast<std::int64_t>(CountWords(grid.Cells[axis]));
}
