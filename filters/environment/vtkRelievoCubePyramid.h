// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoCubePyramid.h
 * @brief Means of a cube map's light over squares of increasing size, and over lobes around a
 * direction.
 */
#ifndef vtkRelievoCubePyramid_h
#define vtkRelievoCubePyramid_h

#include "vtkRelievoFormulas.h"

#include <cstddef>
#include <vector>

namespace relievo
{
/**
 * The texels of a cube with 2^k texels across a face, and their means by solid angle over groups of
 * four, up to whole faces.
 *
 * A lobe's mean is a sum over squares of different sizes. A square stays whole if the lobe's weight
 * bends little across it, and if its light is even or the weight changes little; otherwise it is
 * divided into four. So a single strong texel is resolved where it matters, and the sum has no
 * noise: no texel of the result stands out unless it does so in the exact mean.
 */
class CubePyramid
{
public:
  /** `texels`: red, green, blue of 6 faces of size x size; size is a power of two. */
  CubePyramid(const float* texels, int size);

  /**
   * Mean light about unit direction `axis`, weighted by relievoPrefilterWeight(cosine, roughness),
   * roughness > 0. `tolerance`: error allowed per square, as a share of the result.
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
