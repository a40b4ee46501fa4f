// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays at boxes against points along them, lines at triangles against areas in double, and edges
// that two triangles share: in float no line slips through.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <cmath>
#include <random>
#include <string>

namespace testFormulasRay
{
namespace
{
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;

std::mt19937 Random(7);

glm::dvec2 Place(double size)
{
  std::uniform_real_distribution<double> along(-size, size);
  const double x = along(Random);
  return glm::dvec2(x, along(Random));
}

double Area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  return 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

void TestTriangles(bool closed)
{
  long long met = 0;
  long long mismatches = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec2 a = Place(1.);
    const glm::dvec2 b = Place(1.);
    const glm::dvec2 c = Place(1.);
    const glm::dvec2 o(0.);
    const double more = Area(a, b, o) + Area(b, c, o) + Area(c, a, o) - Area(a, b, c);
    if (Area(a, b, c) < 1e-3 || std::abs(more) < 1e-12)
    {
      met += more < 1e-12 ? 1 : 0;
      mismatches +=
        f64::relievoLineHitsTriangle(a, b, c, closed) != (more < 1e-12) && Area(a, b, c) > 1e-3 ? 1
                                                                                                : 0;
      continue;
    }
    mismatches += f64::relievoLineHitsTriangle(a, b, c, closed) ? 1 : 0;
  }
  RELIEVO_CHECK(met > 1000);
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "lines at triangles");
  const glm::dvec2 p(0.3, 0.4);
  RELIEVO_CHECK(!f64::relievoLineHitsTriangle(p, p, p, closed));
  RELIEVO_CHECK(!f64::relievoLineHitsTriangle(-p, p, 2. * p, closed)); // edge-on
}

// Four triangles, turned either way, around a corner that is on the line, or all but on it, or with
// an edge on it: of triangles that are not closed, it passes one.
void TestSharedEdges()
{
  long long missed = 0;
  long long counted = 0;
  for (int i = 0; i < 40000; ++i)
  {
    glm::vec2 middle(Place(i % 3 ? 1e-8 : 0.));
    glm::vec2 corners[4] = { glm::vec2(1.f, 0.1f) + glm::vec2(Place(0.3)),
      glm::vec2(0.f, 1.f) + glm::vec2(Place(0.3)), glm::vec2(-1.f, 0.f) + glm::vec2(Place(0.3)),
      glm::vec2(0.1f, -1.f) + glm::vec2(Place(0.3)) };
    if (i % 2)
    {
      const int k = i / 4 % 4;
      corners[k] *= i % 4 == 1 ? glm::vec2(1.f) : glm::vec2(k % 2 ? 0.f : 1.f, k % 2 ? 1.f : 0.f);
      middle = -0.125f * corners[k];
    }
    int closed = 0;
    int open = 0;
    for (int k = 0; k < 4; ++k)
    {
      const glm::vec2& p = corners[k];
      const glm::vec2& q = corners[(k + 1) % 4];
      closed += f32::relievoLineHitsTriangle(middle, p, q, true) ? 1 : 0;
      open += (k + i / 16) % 2 ? f32::relievoLineHitsTriangle(p, middle, q, false)
                               : f32::relievoLineHitsTriangle(q, p, middle, false);
    }
    missed += closed == 0 ? 1 : 0;
    counted += open == 1 ? 0 : 1;
  }
  RELIEVO_CHECK_AT_MOST(missed, 0, "lines that slip through a shared corner");
  RELIEVO_CHECK_AT_MOST(counted, 0, "lines that a shared edge counts twice, or not at all");
}

// A box that a point of the ray is in must be met; one that none of many points is near, need not.
void TestBoxes()
{
  long long inside = 0;
  long long missed = 0;
  long long passed = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const glm::vec3 from(glm::vec2(Place(3.)), Place(3.).x);
    glm::vec3 ray(glm::vec2(Place(1.)), Place(1.).x);
    ray.x = i % 5 ? ray.x : 0.f;
    const glm::vec3 half(std::abs(Place(1.).x), std::abs(Place(1.).x), i % 7 ? 0.5f : 0.f);
    const glm::vec3 inverse = f32::relievoRayInverse(ray);
    const bool meets = f32::relievoRayHitsBox(from, inverse, 4.f, -half, half);
    bool in = false;
    for (int k = 0; k <= 400 && !in; ++k)
    {
      const glm::dvec3 p = glm::dvec3(from) + (4. * k / 400.) * glm::dvec3(ray);
      in = glm::all(glm::lessThanEqual(glm::abs(p), glm::dvec3(half)));
    }
    inside += in ? 1 : 0;
    missed += in && !meets ? 1 : 0;
    passed += meets ? 0 : 1;
  }
  RELIEVO_CHECK_THAT(inside > 300 && passed > 5000,
    "boxes: " + std::to_string(inside) + " met, " + std::to_string(passed) + " passed by");
  RELIEVO_CHECK_AT_MOST(missed, 0, "boxes that rays go through and do not meet");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasRay)
{
  relievoTest::Session session;
  TestTriangles(true);
  TestTriangles(false);
  TestSharedEdges();
  TestBoxes();
  return session.Result();
}
}
