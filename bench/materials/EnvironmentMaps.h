// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EnvironmentMaps.h
 * @brief Maps from directions to texels: cube, tan-warped cube, octahedral, sphere map, latitudes
 * and longitudes.
 */
#ifndef relievoBenchEnvironmentMaps_h
#define relievoBenchEnvironmentMaps_h

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <vector>

namespace relievoBench
{
/** Light as a function of the unit direction. */
using Radiance = std::function<glm::dvec3(const glm::dvec3&)>;

enum class EnvironmentMap
{
  Cube,
  WarpedCube, // a position s in [-1, 1] on a face is at tan(pi / 4 s) on the cube
  Octahedral,
  SphereMap,
  Latitudes
};

/** An environment in texels: each is the mean of its light; read bilinearly across all seams. */
class EnvironmentTexels
{
public:
  /** The side of a map whose total of texels is closest to this number. */
  static int SizeFor(EnvironmentMap map, int texels);

  /** Samples the light `samples` x `samples` times per texel. */
  EnvironmentTexels(EnvironmentMap map, int size, const Radiance& light, int samples);

  int GetNumberOfTexels() const { return static_cast<int>(this->Texels.size()); }
  glm::dvec3 Read(const glm::dvec3& direction) const;

private:
  // The direction of a position, 0 to 1 along both sides of a face.
  glm::dvec3 DirectionOf(int face, const glm::dvec2& place) const;
  int PlaceOf(const glm::dvec3& direction, glm::dvec2& place) const;
  double DensityOf(int face, const glm::dvec2& place) const;
  const glm::dvec3& Fetch(int face, int x, int y) const;
  const glm::dvec3& At(int face, int x, int y) const
  {
    return this->Texels[(static_cast<std::size_t>(face) * this->Height + y) * this->Width + x];
  }

  EnvironmentMap Map;
  int Faces;
  int Width;
  int Height;
  std::vector<glm::dvec3> Texels;
};
}

#endif
