// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BruteScene.h
 * @brief Truth for triangles without a library: tests all of them, in double precision.
 */
#ifndef relievoTestBruteScene_h
#define relievoTestBruteScene_h

#include "View.h"

#include <array>
#include <limits>
#include <vector>

class vtkPolyData;

namespace relievoTest
{
/**
 * The polygons of meshes, as fans from their first point. Hits are found by testing every triangle,
 * except groups whose box the ray clearly misses. An edge belongs to both triangles that share it:
 * no ray slips through.
 */
class BruteScene
{
public:
  /** Adds a mesh in world coordinates, copied. */
  void Add(vtkPolyData* mesh);

  std::size_t GetNumberOfTriangles() const { return this->Triangles.size(); }

  struct Hit
  {
    double T = std::numeric_limits<double>::infinity(); // none
    std::size_t Triangle = 0;
    glm::dvec3 Normal{ 0. }; // unit, on the side that the ray comes from
    bool IsThere() const { return this->T < std::numeric_limits<double>::infinity(); }
  };

  /** The first hit with t from tMin to tMax. */
  Hit Cast(const Ray& ray, double tMin, double tMax) const;

  /**
   * The first hit, and all others up to (1 + share) times its t: where triangles touch, rounding
   * decides which of them is visible.
   */
  std::vector<Hit> CastNear(const Ray& ray, double tMin, double tMax, double share) const;

  /** Whether anything except the position's own triangle lies between it and t = tMax. */
  bool Occluded(const Ray& ray, double tMax, std::size_t own) const;

private:
  static constexpr std::size_t GroupSize = 32;
  struct Box
  {
    glm::dvec3 Low;
    glm::dvec3 High;
  };
  Hit MakeHit(const Ray& ray, std::size_t triangle, double t) const;
  static bool Hits(const Box& box, const Ray& ray, double tMax);

  // Calls each(index, t) for triangles that the ray hits, until it returns true.
  template <typename Each>
  void ForEach(const Ray& ray, double tMax, const Each& each) const;

  std::vector<std::array<glm::dvec3, 3>> Triangles;
  std::vector<Box> Groups;
};
}

#endif
