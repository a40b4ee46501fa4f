// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowSimulation.h
 * @brief A sun's shadow map in double precision on the CPU, to tell one kind of bias from another.
 */
#ifndef relievoBenchShadowSimulation_h
#define relievoBenchShadowSimulation_h

#include "EmbreeScene.h"

#include <vector>

namespace relievoBench
{
/**
 * A map of depths along a sun's rays, cast by Embree through the centres of texels, fitted to what
 * a view shows. Look-ups compare with the four texels about a place and weigh their verdicts.
 */
class ShadowSimulation
{
public:
  /** `toSun`: a vector towards the sun, of any length. */
  ShadowSimulation(const relievoTest::EmbreeScene& scene, const relievoTest::TruthImage& view,
    const glm::dvec3& toSun, int mapSize);

  /**
   * Visibility of every pixel of a view, 0 to 1. `bias` in texels' widths (the longer side) along
   * the ray; without `receiverPlane` the pixel's own depth is compared with all four texels, with
   * it the depth that its surface's plane has at each.
   */
  std::vector<float> Visibility(
    const relievoTest::TruthImage& view, double bias, bool receiverPlane) const;

private:
  // Texel coordinates of a place, and its depth from the plane that the rays start in.
  glm::dvec3 ToMap(const glm::dvec3& world) const;
  double At(int x, int y) const;

  int Size;
  glm::dvec3 Axes[3]; // along the map's rows, its columns, and the rays
  glm::dvec3 Corner;  // the least of what the map holds, along the axes
  double Texel[2];
  std::vector<double> Depths;
};
}

#endif
