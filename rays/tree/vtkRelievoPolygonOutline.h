// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles that cover a polygon once, convex or not: the fan about its first corner, the fan about
// another corner, or ears (G. H. Meisters, Polygons Have Ears, 1975).
#ifndef vtkRelievoPolygonOutline_h
#define vtkRelievoPolygonOutline_h

#include "vtkRelievoEarCutter.h"
#include "vtkRelievoRaysModule.h" // for the export macro
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkPoints;

// Examines polygons one by one.
class VTKRELIEVORAYS_EXPORT vtkRelievoPolygonOutline
{
public:
  // Ways to cover a polygon without folds.
  enum class Way
  {
    AsItIs, // the fan about its first corner; also if no way is found
    Turned, // the fan about another corner
    Cut     // triangles
  };

  explicit vtkRelievoPolygonOutline(vtkPoints* points);

  // For a polygon's points; AsItIs if a point does not exist.
  Way Look(vtkIdType count, const vtkIdType* ids);

  // For the last polygon, as indices in it: the corner of its fan, and its triangles.
  std::size_t GetFirst() const { return this->First; }
  const std::vector<vtkRelievoEarCutter::Triangle>& GetTriangles() const { return this->Triangles; }

private:
  using Vector = std::array<double, 3>;

  Vector Cross(std::size_t a, std::size_t b, std::size_t c) const;
  bool Folds(std::size_t first) const;
  bool LooksBackwards() const;
  bool Cut();

  vtkPoints* const Points;
  const double Tolerance;
  double Least = 0.;
  std::size_t First = 0;
  Vector Normal = {};
  std::vector<Vector> Corners;
  std::vector<vtkRelievoEarCutter::Point> Flat;
  std::vector<vtkRelievoEarCutter::Triangle> Triangles;
  vtkRelievoEarCutter Cutter;
};

#endif
