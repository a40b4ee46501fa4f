// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Surroundings.h
 * @brief Environments in closed form, and pictures to compare with them.
 */
#ifndef relievoTestSurroundings_h
#define relievoTestSurroundings_h

#include "Environments.h"

#include <vtkRenderer.h>

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace relievoTest
{
/** Another colour on each of the six sides of a cube. */
glm::dvec3 SixColors(const glm::dvec3& direction);

/** Smooth, from 0.1 to 0.9, of order 2: no two directions with the same colour. */
glm::dvec3 Smooth(const glm::dvec3& direction);

/** The integral of light times the cosine to `normal`, over pi, by sums. */
glm::dvec3 IrradianceOverPi(const Light& light, const glm::dvec3& normal);

/** Angle from a direction to the nearest edge of the cube's six sides, radian. */
double AngleToEdge(const glm::dvec3& direction);

/** Turned by degrees about an axis, counter-clockwise seen from its end. */
glm::dvec3 TurnedAbout(const glm::dvec3& axis, double degrees, const glm::dvec3& v);

/** A rendered picture, colours from 0 to 1, row 0 at the bottom. */
struct Photo
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Bytes;

  explicit Photo(vtkRenderWindow* window);
  glm::dvec3 At(int x, int y) const;
};

/**
 * The greatest difference, in 255ths, between a picture and `expected`, which gives the colour of a
 * pixel's unit ray (world), or a negative colour for pixels to leave out. NaN if fewer than
 * `least` pixels are.
 */
double WorstDifference(vtkRenderer* renderer,
  const std::function<glm::dvec3(const glm::dvec3&)>& expected, int least = 1000);

/** Looks from `eye` along `forward`. */
void LookAlong(
  vtkRenderer* renderer, const glm::dvec3& eye, const glm::dvec3& forward, double viewAngle);
}

#endif
