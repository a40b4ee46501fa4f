// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rotations between keys and rigid motions compared with GLM's axis and angle, in double, and the
// known error of nlerp.
#include "Check.h"
#include "Samples.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace testFormulasSkin
{
namespace
{
using namespace relievoTest;
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;
constexpr double Degree = 3.14159265358979323846 / 180.;

glm::dvec4 About(const glm::dvec3& axis, double degrees)
{
  const glm::dquat q = glm::angleAxis(degrees * Degree, axis);
  return glm::dvec4(q.x, q.y, q.z, q.w);
}

double DegreesBetween(const glm::dvec4& a, const glm::dvec4& b)
{
  const glm::dvec4 c = glm::dot(a, b) < 0. ? -b : b;
  return 4. * std::atan2(glm::length(a - c), glm::length(a + c)) / Degree;
}

// Published bounds of nlerp against slerp, by the angle between the keys.
void TestBetweenKeys()
{
  const double known[][2] = { { 30., 0.04 }, { 60., 0.28 }, { 90., 0.93 }, { 120., 2.3 },
    { 179.999, 8.2 } };
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1., -2., 0.5));
  for (const auto& [angle, bound] : known)
  {
    double chord = 0.;
    double arc = 0.;
    double rounded = 0.;
    const glm::dvec4 from = About(axis, 17.);
    const glm::dvec4 to = About(axis, 17. + angle);
    for (int i = 0; i <= 200; ++i)
    {
      const double share = i / 200.;
      const glm::dvec4 truth = About(axis, 17. + share * angle);
      // Quaternions of either sign, of either end.
      for (const double sign : { 1., -1. })
      {
        arc =
          std::max(arc, DegreesBetween(f64::relievoQuaternionSlerp(from, to * sign, share), truth));
        chord = std::max(
          chord, DegreesBetween(f64::relievoQuaternionNlerp(from * sign, to, share), truth));
        rounded = std::max(rounded,
          DegreesBetween(glm::dvec4(f32::relievoQuaternionSlerp(
                           glm::vec4(from), glm::vec4(to * sign), static_cast<float>(share))),
            truth));
      }
    }
    RELIEVO_CHECK_AT_MOST(arc, 1e-9, "slerp, degrees");
    RELIEVO_CHECK_AT_MOST(rounded, 1e-3, "slerp in float, degrees");
    RELIEVO_CHECK_AT_MOST(chord, bound, "nlerp over " + std::to_string(angle) + " degrees");
    RELIEVO_CHECK(chord > 0.8 * bound);
  }
  // Equal keys, and keys closer than float tells apart.
  const glm::vec4 key(About(axis, 40.));
  RELIEVO_CHECK(glm::length(f32::relievoQuaternionSlerp(key, key, 0.4f) - key) < 1e-6f);
  RELIEVO_CHECK(glm::length(f32::relievoQuaternionSlerp(key, -key, 0.4f) - key) < 1e-6f);
}

void TestMotions()
{
  double turned = 0.;
  double taken = 0.;
  double moved = 0.;
  double rounded = 0.;
  int i = 0;
  for (const glm::dvec3& axis : Directions(3000))
  {
    const double angle = (37 * ++i) % 361 - 180.;
    const glm::dvec4 q = About(axis, angle);
    const glm::dmat3 m = glm::mat3_cast(glm::angleAxis(angle * Degree, axis));
    const glm::dvec3 v(axis.y, 2. - axis.x, 0.3);
    turned = std::max(turned, glm::length(f64::relievoQuaternionRotate(q, v) - m * v));
    taken = std::max(taken, DegreesBetween(f64::relievoQuaternionOf(m), q));
    // The motion, scaled by any number, moves by v.
    const glm::dvec4 dual = f64::relievoDualOf(q, v) * -0.3;
    moved = std::max(moved, glm::length(f64::relievoDualTranslation(q * -0.3, dual) - v));
    const glm::vec4 narrow = f32::relievoQuaternionOf(glm::mat3(m));
    rounded = std::max(rounded, DegreesBetween(glm::dvec4(narrow), q));
  }
  RELIEVO_CHECK_AT_MOST(turned, 1e-14, "rotation");
  RELIEVO_CHECK_AT_MOST(taken, 1e-6, "quaternion of a matrix, degrees");
  RELIEVO_CHECK_AT_MOST(moved, 1e-14, "move of a dual quaternion");
  RELIEVO_CHECK_AT_MOST(rounded, 1e-4, "quaternion of a matrix in float, degrees");
}

void TestNormals()
{
  for (const glm::dvec3& v : Directions(500))
  {
    const glm::dmat3 m(v, glm::dvec3(0.2, 1., v.x), glm::dvec3(v.z, 0.1, 2.));
    const double det = glm::determinant(m);
    if (std::abs(det) > 1e-3)
    {
      const glm::dmat3 expected = glm::inverse(glm::transpose(m)) * std::abs(det);
      const glm::dmat3 found = f64::relievoNormalMatrix(m);
      for (int i = 0; i < 3; ++i)
      {
        RELIEVO_CHECK(glm::length(found[i] - expected[i]) < 1e-12);
      }
    }
  }
  // Flattened along z: normals are along z.
  const glm::dmat3 flat(glm::dvec3(1., 0., 0.), glm::dvec3(0., 1., 0.), glm::dvec3(0.));
  RELIEVO_CHECK(
    f64::relievoNormalMatrix(flat) * glm::dvec3(0.6, 0., 0.8) == glm::dvec3(0., 0., 0.8));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasSkin)
{
  relievoTest::Session session;
  TestBetweenKeys();
  TestMotions();
  TestNormals();
  return session.Result();
}
}
