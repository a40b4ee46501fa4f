// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The positions at which rays evaluate a mesh, in front of it by 1e-7 of its size, and their
// normals.
#ifndef vtkRelievoSurfacePlaces_h
#define vtkRelievoSurfacePlaces_h

#include "vtkType.h" // for ids

#include <array>
#include <cstddef>
#include <vector>

class vtkPolyData;

class vtkRelievoSurfacePlaces
{
public:
  using Vector = std::array<double, 3>;
  std::vector<Vector> At;
  std::vector<Vector> Normals; // 0 where there is no surface
  std::vector<double> Areas;   // of cells; twice
  double Before = 0.0;         // distance of the places from the surface

  // Polygons and strips: the area-weighted middle of their triangles, moved along the normal onto
  // the triangle behind it. If there is none (in a U, between the legs): the middle of the largest
  // triangle.
  void TakeCells(vtkPolyData* mesh);

  // A point has its own normal, or the mean of the surrounding triangles' normals weighted by their
  // angles at the point (G. Thürmer, C. A. Wüthrich 1998), which does not depend on how faces are
  // cut.
  void TakePoints(vtkPolyData* mesh);

  // No place outside of the range faces the light.
  void Keep(const std::array<std::size_t, 2>& range);

private:
  struct Triangle;
  static double GetAngle(vtkPolyData* mesh, vtkIdType at, vtkIdType a, vtkIdType b);
  void Add(Vector place);
};

#endif
