// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How much of the sky a scene hides from the ground below it.
 */
#ifndef GroundSky_h
#define GroundSky_h

#include "LookNames.h"

#include <array>
#include <vector>

class vtkRenderer;

namespace look
{
/// The scene as columns between the lowest and the highest point in each cell of a grid on the
/// ground. In each of some directions, bands of elevation are hidden or not (O. Therrien,
/// Y. Levesque, G. Gilet, Screen Space Indirect Lighting with Visibility Bitmask, 2023).
class GroundSky
{
public:
  /// For the renderer's opaque actors within these bounds. `upAxis`: 0, 1, 2 for x, y, z; `height`:
  /// the ground's coordinate on it.
  GroundSky(vtkRenderer* renderer, const double bounds[6], int upAxis, double height);

  /// The share of a uniform sky's light that does not reach this point of the ground, 0 to 1.
  /// `quarter`: by how many quarters of the angle between two directions all are turned, 0 to 3.
  double GetHidden(const std::array<double, 3>& point, std::size_t quarter) const;

private:
  void Add(const std::array<double, 3>& point);
  void AddTriangle(const std::array<std::array<double, 3>, 3>& corners);

  struct Column
  {
    float Low, High; // above the ground; empty if Low is above High
  };
  std::array<std::size_t, 3> Axes; // along the grid's rows and columns, and up
  double Height;
  std::array<double, 2> Origin{}; // of the grid
  double Cell = 0.0;              // side
  std::array<int, 2> Size{};
  std::vector<Column> Columns;
  std::vector<std::array<double, 2>> Along; // directions, four for each that a point looks in
};
}

#endif
