// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Samples.h
 * @brief Inputs of the formula tests: many ordinary values, and those where encodings fail.
 */
#ifndef relievoTestSamples_h
#define relievoTestSamples_h

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace relievoTest
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/** Angle between two vectors, degrees; exact for small angles, which acos is not. */
inline double Degrees(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.295779513082320877;
}

/** Unit vectors where encodings have corners: axes, poles and octant seams, and beside them. */
inline std::vector<glm::dvec3> SpecialDirections()
{
  std::vector<glm::dvec3> directions;
  const double steps[] = { 0., -0., 1e-9, -1e-9, 1e-4, -1e-4, 0.5, -0.5, 1., -1. };
  for (double x : steps)
  {
    for (double y : steps)
    {
      for (double z : steps)
      {
        const glm::dvec3 v(x, y, z);
        if (glm::dot(v, v) > 0.)
        {
          directions.push_back(glm::normalize(v));
        }
      }
    }
  }
  return directions;
}

/** `count` unit vectors, uniform on the sphere, after the special ones. */
inline std::vector<glm::dvec3> Directions(int count)
{
  std::vector<glm::dvec3> directions = SpecialDirections();
  std::mt19937_64 random(20140401);
  std::normal_distribution<double> normal;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 v(normal(random), normal(random), normal(random));
    directions.push_back(glm::normalize(v));
  }
  return directions;
}

/** `count` depths from zNear to zFar, both included, evenly in the logarithm. */
inline std::vector<double> Depths(int count, double zNear, double zFar)
{
  std::vector<double> depths;
  for (int i = 0; i < count; ++i)
  {
    depths.push_back(zNear * std::pow(zFar / zNear, double(i) / (count - 1)));
  }
  depths.front() = zNear;
  depths.back() = zFar;
  return depths;
}
}

#endif
