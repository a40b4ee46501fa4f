// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoCubePyramid.h
 * @brief Means of a cube map's light over larger and larger squares, and over lobes about a way.
 */
#ifndef vtkRelievoCubePyramid_h
#define vtkRelievoCubePyramid_h

#include "vtkRelievoFormulas.h"

#include <cstddef>
#include <vector>

namespace relievo
{
/**
 * The texels of a cube of 2^k texels a face, and their means over solid angle by fours, up to whole
 * faces.
 *
 * A lobe's mean is a sum over squares of different sizes: a square stays whole where the lobe's
 * weight bends little across it, and where its light is even or the weight changes little; else its
 * four parts are looked at. So a single strong texel is always met by itself where it matters, and
 * the sum has no noise: no texel of the result can stand out that does not in truth.
 */
class CubePyramid
{
public:
  /** `texels`: red, green, blue of 6 faces of size x size; size is a power of two. */
  CubePyramid(const float* texels, int size);

  /**
   * Mean light about unit direction `axis`, weighted by relievoPrefilterWeight(cosine, roughness),
   * roughness > 0. `tolerance`: how much of the result one square may err by.
   */
  f64::vec3 LobeMean(const f64::vec3& axis, double roughness, double tolerance) const;

private:
  struct Square
  {
    f32::vec3 Direction; // the mean of its directions, shorter than 1
    float SolidAngle;
    f32::vec3 Light;
    float Unevenness; // at least the sum of |light - mean| times solid angle over its texels
  };

  struct Level
  {
    int Size;
    std::vector<Square> Squares;
  };

  struct Lobe;

  void Visit(Lobe& lobe, int level, std::size_t index) const;
  void VisitParts(
    Lobe& lobe, const f32::vec3& light, int face, int size, int column, int row, int depth) const;

  std::vector<Level> Levels; // the first is the finest
  double MeanBrightness = 0.;
};
}

#endif
