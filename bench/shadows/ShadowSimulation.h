// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowSimulation.h
 * @brief A sun's shadow map in double precision on the CPU, to separate kinds of bias.
 */
#ifndef relievoBenchShadowSimulation_h
#define relievoBenchShadowSimulation_h

#include "EmbreeScene.h"

#include <vector>

namespace relievoBench
{
/**
 * A map of depths along a sun's rays, cast by Embree through the texels' centres, fitted to a view.
 * Look-ups compare with the four texels around a position and weight their verdicts.
 */
class ShadowSimulation
{
public:
  /** `toSun`: a vector towards the sun, of any length. */
  ShadowSimulation(const relievoTest::EmbreeScene& scene, const relievoTest::TruthImage& view,
    const glm::dvec3& toSun, int mapSize);

  /**
   * Visibility of every pixel of a view, 0 to 1. `bias` in texel widths (the longer side) along the
   * ray. With `receiverPlane`, each of the four texels is compared with the depth of the surface's
   * plane there, otherwise all with the pixel's own depth.
   */
  std::vector<float> Visibility(
    const relievoTest::TruthImage& view, double bias, bool receiverPlane) const;

private:
  // Texel coordinates of a position, and its depth from the plane in which the rays start.
  glm::dvec3 ToMap(const glm::dvec3& world) const;
  double At(int x, int y) const;

  int Size;
  glm::dvec3 Axes[3]; // along the map's rows, its columns, and the rays
  glm::dvec3 Corner;  // the lower corner of the map, along the axes
  double Texel[2];
  std::vector<double> Depths;
};
}

#endif
