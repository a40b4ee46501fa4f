// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hits of the lines through columns' centres with a triangle, in double. Decisions at a shared edge
// depend only on the edge's two ends, and each column is on one side of it. On a surface that uses
// each edge an even number of times, each column therefore has an even number of crossings, however
// degenerate the triangles are and however numbers are rounded.
#ifndef vtkRelievoVoxelScan_h
#define vtkRelievoVoxelScan_h

#include "vtkRelievoVoxelGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

// Calls visit(column, row, depth) for each column that the triangle crosses. Corners are in grid
// coordinates, finite, x y z.
template <typename Visit>
void vtkRelievoScanTriangle(const std::array<const double*, 3>& corners, int axis,
  const std::array<int, 3>& cells, Visit&& visit)
{
  const int across = vtkRelievoVoxelGrid::GetColumn(axis);
  const int up = vtkRelievoVoxelGrid::GetRow(axis);
  const auto range = [&](int along, int& first, int& end) {
    const auto [low, high] =
      std::minmax({ corners[0][along], corners[1][along], corners[2][along] });
    const double size = cells[along];
    first = static_cast<int>(std::clamp(std::ceil(low), 0., size));
    end = static_cast<int>(std::clamp(std::ceil(high), 0., size));
    return first < end;
  };
  int firstRow = 0;
  int endRow = 0;
  int firstColumn = 0;
  int endColumn = 0;
  if (!range(up, firstRow, endRow) || !range(across, firstColumn, endColumn))
  {
    return;
  }
  struct Crossing
  {
    double Across = 0.;
    double Along = 0.;
  };
  for (int row = firstRow; row < endRow; ++row)
  {
    Crossing found[2];
    int count = 0;
    for (int c = 0; c < 3; ++c)
    {
      const double* low = corners[c];
      const double* high = corners[c == 2 ? 0 : c + 1];
      if (low[up] > high[up])
      {
        std::swap(low, high);
      }
      if (low[up] <= row && row < high[up])
      {
        const double t = (row - low[up]) / (high[up] - low[up]);
        const auto [least, most] = std::minmax(low[across], high[across]);
        // Exactly two of the three edges cross a row.
        found[count & 1].Across =
          std::clamp(low[across] + t * (high[across] - low[across]), least, most);
        found[count & 1].Along = low[axis] + t * (high[axis] - low[axis]);
        ++count;
      }
    }
    if (count != 2)
    {
      continue;
    }
    if (found[0].Across > found[1].Across)
    {
      std::swap(found[0], found[1]);
    }
    const double width = cells[across];
    const int first = static_cast<int>(std::clamp(std::ceil(found[0].Across), 0., width));
    const int end = static_cast<int>(std::clamp(std::ceil(found[1].Across), 0., width));
    for (int column = first; column < end; ++column)
    {
      const double t = (column - found[0].Across) / (found[1].Across - found[0].Across);
      visit(column, row, found[0].Along + t * (found[1].Along - found[0].Along));
    }
  }
}

#endif
