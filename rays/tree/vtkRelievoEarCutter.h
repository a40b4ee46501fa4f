// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangulates a plane polygon by cutting ears, after G. H. Meisters, Polygons Have Ears, 1975.
// Corners that are not convex are stored in a grid, so that each ear is tested only against nearby
// ones.
#ifndef vtkRelievoEarCutter_h
#define vtkRelievoEarCutter_h

#include <array>
#include <cstddef>
#include <vector>

class vtkRelievoEarCutter
{
public:
  using Point = std::array<double, 2>;
  using Triangle = std::array<int, 3>; // indices of corners, in the polygon's order

  // The corners run counter-clockwise; they may touch each other, lie on a line, or run to a hole
  // and back. False if the polygon intersects itself such that no ear is found; the triangles then
  // cover a part of it.
  bool Cut(const std::vector<Point>& corners, std::vector<Triangle>& triangles);

private:
  enum Strictness
  {
    Closed, // no other corner on the triangle's edges
    Open    // none inside
  };

  double Turn(int a, int b, int c) const;
  bool IsEar(int corner, Strictness strictness) const;
  bool Blocks(int other, int a, int b, int c, Strictness strictness) const;
  void Remove(int corner);
  void UpdateConvexity(int corner);
  void MakeGrid();
  std::size_t GetColumn(double value, int axis) const;

  const Point* Points = nullptr;
  int Count = 0;
  std::vector<int> Before;
  std::vector<int> Behind;
  std::vector<char> Blocking; // not convex, and not yet removed
  std::vector<char> InGrid;
  Point Lowest = {};
  Point Scale = {}; // columns of the grid per length
  std::size_t Columns = 1;
  std::vector<std::vector<int>> Grid;
};

#endif
