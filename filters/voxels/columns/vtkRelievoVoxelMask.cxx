// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelMask.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Calls work(j, k, the row's first mask value) in threads for each row of cells along x; returns
// the number of cells that are then 1.
template <typename Work>
std::int64_t ForEachRow(const vtkRelievoVoxelGrid& grid, unsigned char* mask, Work&& work)
{
  const int width = grid.Cells[0];
  const vtkIdType rows = static_cast<vtkIdType>(grid.Cells[1]) * grid.Cells[2];
  std::atomic<std::int64_t> inside{ 0 };
  vtkSMPTools::For(
    0, rows, std::max<vtkIdType>(1, 65536 / width), [&](vtkIdType begin, vtkIdType end) {
      std::int64_t found = 0;
      for (vtkIdType row = begin; row < end; ++row)
      {
        unsigned char* cells = mask + row * width;
        work(static_cast<int>(row % grid.Cells[1]), static_cast<int>(row / grid.Cells[1]), cells);
        found += std::count(cells, cells + width, static_cast<unsigned char>(1));
      }
      inside += found;
    });
  return inside;
}

// The cells between the crossings of a column: first to last.
struct Between
{
  std::vector<int> First;
  std::vector<int> Last;

  Between(const vtkRelievoVoxelViews& views, int cells)
  {
    this->First.resize(views.Front.size());
    this->Last.resize(views.Front.size());
    for (std::size_t i = 0; i < views.Front.size(); ++i)
    {
      this->First[i] =
        static_cast<int>(std::clamp(std::ceil(views.Front[i]), 0., static_cast<double>(cells)));
      this->Last[i] =
        static_cast<int>(std::clamp(std::floor(views.Back[i]), -1., static_cast<double>(cells)));
    }
  }
};
}

//------------------------------------------------------------------------------
std::int64_t vtkRelievoVoxelMask::FromViews(const std::vector<vtkRelievoVoxelViews>& views,
  const vtkRelievoVoxelGrid& grid, unsigned char* mask)
{
  std::vector<Between> between;
  for (const vtkRelievoVoxelViews& view : views)
  {
    between.emplace_back(view, grid.Cells[view.Axis]);
  }
  return ForEachRow(grid, mask, [&](int j, int k, unsigned char* cells) {
    std::fill(cells, cells + grid.Cells[0], static_cast<unsigned char>(1));
    for (std::size_t v = 0; v < views.size(); ++v)
    {
      const int axis = views[v].Axis;
      const std::size_t column = grid.ColumnOf(axis, 0, j, k);
      const int* first = &between[v].First[column];
      const int* last = &between[v].Last[column];
      if (axis == 0)
      {
        for (int i = 0; i < grid.Cells[0]; ++i)
        {
          cells[i] &= static_cast<unsigned char>(i >= *first && i <= *last);
        }
        continue;
      }
      const int along = axis == 1 ? j : k;
      for (int i = 0; i < grid.Cells[0]; ++i)
      {
        cells[i] &= static_cast<unsigned char>(along >= first[i] && along <= last[i]);
      }
    }
  });
}

//------------------------------------------------------------------------------
std::int64_t vtkRelievoVoxelMask::FromParity(const vtkRelievoVoxelParity& parity, int axis,
  const vtkRelievoVoxelGrid& grid, unsigned char* mask)
{
  return ForEachRow(grid, mask, [&](int j, int k, unsigned char* cells) {
    const std::size_t column = grid.ColumnOf(axis, 0, j, k);
    if (axis == 0)
    {
      for (int i = 0; i < grid.Cells[0]; i += 64)
      {
        std::uint64_t bits = parity.GetWord(column, i / 64);
        for (int b = i; b < std::min(i + 64, grid.Cells[0]); ++b, bits >>= 1)
        {
          cells[b] = static_cast<unsigned char>(bits & 1U);
        }
      }
      return;
    }
    const int along = axis == 1 ? j : k;
    for (int i = 0; i < grid.Cells[0]; ++i)
    {
      cells[i] = parity.IsInside(column + static_cast<std::size_t>(i), along);
    }
  });
}

//------------------------------------------------------------------------------
std::int64_t vtkRelievoVoxelMask::FromVote(const std::vector<vtkRelievoVoxelParity>& axes,
  const vtkRelievoVoxelGrid& grid, unsigned char* mask)
{
  return ForEachRow(grid, mask, [&](int j, int k, unsigned char* cells) {
    for (int i = 0; i < grid.Cells[0]; ++i)
    {
      const int cell[3] = { i, j, k };
      int votes = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const vtkRelievoVoxelParity& parity = axes[static_cast<std::size_t>(axis)];
        const std::size_t column = grid.ColumnOf(axis, i, j, k);
        votes += parity.IsOpen(column) ? 0 : parity.IsInside(column, cell[axis]) ? 1 : -1;
      }
      cells[i] = votes > 0;
    }
  });
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelMask::Distances(const std::vector<vtkRelievoVoxelViews>& views,
  const vtkRelievoVoxelGrid& grid, float* front, float* back)
{
  const vtkIdType rows = static_cast<vtkIdType>(grid.Cells[1]) * grid.Cells[2];
  const std::size_t count = views.size();
  constexpr float None = std::numeric_limits<float>::quiet_NaN();
  vtkSMPTools::For(0, rows, 64, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType row = begin; row < end; ++row)
    {
      const int j = static_cast<int>(row % grid.Cells[1]);
      const int k = static_cast<int>(row / grid.Cells[1]);
      for (int i = 0; i < grid.Cells[0]; ++i)
      {
        const int cell[3] = { i, j, k };
        const std::size_t at =
          (static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.Cells[0]) +
            static_cast<std::size_t>(i)) *
          count;
        for (std::size_t v = 0; v < count; ++v)
        {
          const int axis = views[v].Axis;
          const std::size_t column = grid.ColumnOf(axis, i, j, k);
          const double first = views[v].Front[column];
          const double last = views[v].Back[column];
          const bool crossed = first <= last;
          front[at + v] =
            crossed ? static_cast<float>((cell[axis] - first) * grid.Spacing[axis]) : None;
          back[at + v] =
            crossed ? static_cast<float>((last - cell[axis]) * grid.Spacing[axis]) : None;
        }
      }
    }
  });
}

//------------------------------------------------------------------------------
double vtkRelievoVoxelMask::EstimateBytes(
  const std::array<double, 3>& cells, bool parity, int axis, bool distances)
{
  const double all = cells[0] * cells[1] * cells[2];
  double bytes = all * (1. + (distances ? 8. * (axis < 0 ? 3. : 1.) : 0.));
  for (int a = 0; a < 3; ++a)
  {
    const double along = cells[static_cast<std::size_t>(a)];
    const double columns = all / along;
    bytes += parity ? columns * 8. * (std::floor(along / 64.) + 1.) : 0.;
    // Two doubles used while computing, two kept, two indices.
    bytes += (!parity || distances) && (axis < 0 || axis == a) ? columns * 40. : 0.;
  }
  return bytes;
}
