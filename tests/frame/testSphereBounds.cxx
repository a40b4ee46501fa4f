// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rectangles of spheres against many points of each: none outside, and none much larger.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkRelievoSphereBounds.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace testSphereBounds
{
namespace
{
// Extremes of the sphere's points between two depths, sampled.
struct Sampled
{
  double Least[2] = { 1e300, 1e300 };
  double Most[2] = { -1e300, -1e300 };
  bool Any = false;
};

Sampled Sample(const glm::dmat4& projection, const vtkRelievoSphereBounds::Sphere& sphere,
  double from, double to)
{
  Sampled sampled;
  constexpr int Turns = 600;
  const double top = std::max(-1.0, std::min(1.0, (from + sphere.Center.z) / sphere.Radius));
  const double bottom = std::max(-1.0, std::min(1.0, (to + sphere.Center.z) / sphere.Radius));
  for (int i = 0; i <= Turns && top < bottom; ++i)
  {
    // Rings at depths between the two, ends included.
    const double height = top + (bottom - top) * i / Turns;
    const double ring = std::sqrt(std::max(0.0, 1.0 - height * height));
    for (int k = 0; k < Turns; ++k)
    {
      const double angle = 2.0 * 3.14159265358979323846 * k / Turns;
      const glm::dvec3 point = sphere.Center +
        sphere.Radius * glm::dvec3(ring * std::cos(angle), ring * std::sin(angle), -height);
      const glm::dvec4 clip = projection * glm::dvec4(point, 1.0);
      if (clip.w > 0.0)
      {
        sampled.Any = true;
        for (int axis = 0; axis < 2; ++axis)
        {
          sampled.Least[axis] = std::min(sampled.Least[axis], clip[axis] / clip.w);
          sampled.Most[axis] = std::max(sampled.Most[axis], clip[axis] / clip.w);
        }
      }
    }
  }
  return sampled;
}

void TestProjection(const glm::dmat4& projection, const std::string& what)
{
  const vtkRelievoSphereBounds bounds(projection);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-4.0, 4.0);
  std::uniform_real_distribution<double> depth(-2.0, 9.0);
  std::uniform_real_distribution<double> size(0.05, 3.0);
  double looseness = 0.0;
  double outside = 0.0;
  int found = 0;
  for (int i = 0; i < 120; ++i)
  {
    const vtkRelievoSphereBounds::Sphere sphere{ { place(random), place(random), -depth(random) },
      size(random) };
    const double from = i % 3 == 0 ? 2.0 : 0.5;
    const double to = i % 3 == 0 ? 3.0 : 8.0;
    const Sampled sampled = Sample(projection, sphere, from, to);
    for (int axis = 0; axis < 2; ++axis)
    {
      double least = 0.0;
      double most = 0.0;
      const bool any = bounds.FindExtent(sphere, axis, from, to, least, most);
      RELIEVO_CHECK(any || !sampled.Any);
      if (any && sampled.Any)
      {
        ++found;
        const double scale = 1.0 + std::abs(least) + std::abs(most);
        outside = std::max(
          { outside, (least - sampled.Least[axis]) / scale, (sampled.Most[axis] - most) / scale });
        looseness = std::max({ looseness, (sampled.Least[axis] - least) / scale,
          (most - sampled.Most[axis]) / scale });
      }
    }
  }
  RELIEVO_CHECK(found > 100);
  RELIEVO_CHECK_AT_MOST(outside, 1e-12, what + ": points outside, of the extent");
  // 600 samples of a turn miss 1.4e-5 of the radius; near the eye that grows.
  RELIEVO_CHECK_AT_MOST(looseness, 2e-3, what + ": larger than needed, of the extent");
}
}

RELIEVO_TEST_CASE(testSphereBounds)
{
  relievoTest::Session session;
  const glm::dmat4 perspective = glm::frustum(-0.3, 0.3, -0.2, 0.2, 0.5, 9.0);
  TestProjection(perspective, "perspective");
  TestProjection(glm::frustum(-0.1, 0.5, -0.4, 0.1, 0.5, 9.0), "off-centre");
  TestProjection(glm::ortho(-3.0, 3.0, -2.0, 2.0, 0.5, 9.0), "parallel");
  glm::dmat4 shear(1.0);
  shear[2][0] = 0.4;
  shear[2][1] = -0.3;
  shear[3][0] = 0.8;
  TestProjection(perspective * shear, "sheared perspective");
  TestProjection(glm::ortho(-3.0, 3.0, -2.0, 2.0, 0.5, 9.0) * shear, "sheared parallel");

  // A sphere around the eye covers the view; one behind it, nothing; one at its side, half.
  const vtkRelievoSphereBounds bounds(perspective);
  double rectangle[4];
  RELIEVO_CHECK(bounds.FindRectangle({ { 0.0, 0.0, 0.0 }, 2.0 }, 0.5, 9.0, rectangle));
  RELIEVO_CHECK(
    rectangle[0] == -1.0 && rectangle[1] == -1.0 && rectangle[2] == 1.0 && rectangle[3] == 1.0);
  RELIEVO_CHECK(!bounds.FindRectangle({ { 0.0, 0.0, 3.0 }, 2.0 }, 0.5, 9.0, rectangle));
  RELIEVO_CHECK(!bounds.FindRectangle({ { 0.0, 0.0, -20.0 }, 2.0 }, 0.5, 9.0, rectangle));
  RELIEVO_CHECK(!bounds.FindRectangle({ { 90.0, 0.0, -5.0 }, 2.0 }, 0.5, 9.0, rectangle));
  return session.Result();
}
}
