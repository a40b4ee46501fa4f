// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BruteRays.h
 * @brief Hits of rays, triangle after triangle, in extended precision and by another formula than
 *   the library's: the plane first, and then on which side of the edges its point is.
 */
#ifndef relievoTestBruteRays_h
#define relievoTestBruteRays_h

#include <glm/vec3.hpp>

#include <vector>

class vtkMatrix4x4;
class vtkPolyData;

namespace relievoTest
{
struct BruteHit
{
  double Distance = 0.;
  int Prop = -1;
  long long Cell = -1;
};

struct BruteAnswer
{
  std::vector<BruteHit> Hits; // in order
  /** Whether it passes an edge within 1e-9 of the scene's size, or a triangle in its plane. */
  bool Unsure = false;
};

class BruteRays
{
public:
  /** Adds the triangles of a mesh, numbered as its cells, or all as `cell`. */
  void Add(vtkPolyData* mesh, int prop, vtkMatrix4x4* matrix = nullptr, long long cell = -1);

  /** All hits of a ray with a distance in [low, high]. */
  BruteAnswer Find(
    const glm::dvec3& origin, const glm::dvec3& direction, double low, double high) const;

  const glm::dvec3& GetLow() const { return this->Low; }
  const glm::dvec3& GetHigh() const { return this->High; }

private:
  struct Triangle
  {
    glm::dvec3 Corners[3];
    int Prop;
    long long Cell;
  };
  std::vector<Triangle> Triangles;
  glm::dvec3 Low{ 1e300 };
  glm::dvec3 High{ -1e300 };
};
}

#endif
