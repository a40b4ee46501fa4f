// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Directions and places of environments: the axes lie where the orientation says, places come back
// from their directions, densities are those of the mappings and sum to the whole sphere; spherical
// harmonics and GGX weights against their textbook forms.
#include "Check.h"
#include "Samples.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace testFormulasEnvironment
{
namespace
{
using namespace relievoTest;
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;

constexpr double Pi = 3.14159265358979323846;

double Apart(const glm::dvec2& a, const glm::dvec2& b)
{
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

void TestAxes()
{
  struct Axis
  {
    glm::dvec3 Direction;
    glm::dvec2 Equirectangular;
    glm::dvec2 SphereMap;
    int Face;
  };
  const double near = 0.5 - std::sqrt(0.125);
  const double far = 0.5 + std::sqrt(0.125);
  const Axis axes[] = {
    { { 1., 0., 0. }, { 0.5, 0.5 }, { far, 0.5 }, 0 },
    { { -1., 0., -1e-12 }, { 0., 0.5 }, { near, 0.5 }, 1 },
    { { -1., 0., 0. }, { 1., 0.5 }, { near, 0.5 }, 1 },
    { { 0., 1., 0. }, { 0.5, 1. }, { 0.5, far }, 2 },
    { { 0., -1., 0. }, { 0.5, 0. }, { 0.5, near }, 3 },
    { { 0., 0., 1. }, { 0.75, 0.5 }, { 0.5, 0.5 }, 4 },
    { { 0., 0., -1. }, { 0.25, 0.5 }, { 0.5, 0. }, 5 },
  };
  for (const Axis& axis : axes)
  {
    for (const double size : { 1., 1e-3, 1e6 })
    {
      const glm::dvec3 d = axis.Direction * size;
      RELIEVO_CHECK(
        Apart(f64::relievoEquirectangularFromDirection(d), axis.Equirectangular) < 1e-11);
      RELIEVO_CHECK(Apart(f64::relievoSphereMapFromDirection(d), axis.SphereMap) < 1e-11);
      RELIEVO_CHECK(f64::relievoCubeFace(d) == axis.Face);
      RELIEVO_CHECK(Apart(f64::relievoCubeFromDirection(d, axis.Face), glm::dvec2(0.5)) < 1e-11);
    }
  }
}

// The table of OpenGL's specification: sc, tc by face; each s = (sc / |major| + 1) / 2.
void TestCubeTable()
{
  for (const glm::dvec3& d : Directions(20000))
  {
    const glm::dvec2 expected[6] = { { -d.z, -d.y }, { d.z, -d.y }, { d.x, d.z }, { d.x, -d.z },
      { d.x, -d.y }, { -d.x, -d.y } };
    const double sizes[3] = { std::abs(d.x), std::abs(d.y), std::abs(d.z) };
    const int face = f64::relievoCubeFace(d);
    const int major = face / 2;
    RELIEVO_CHECK(sizes[major] >= sizes[0] && sizes[major] >= sizes[1] && sizes[major] >= sizes[2]);
    RELIEVO_CHECK((d[major] < 0.) == (face % 2 == 1));
    const glm::dvec2 place = f64::relievoCubeFromDirection(d, face);
    RELIEVO_CHECK(Apart(place, (expected[face] / sizes[major] + 1.) / 2.) < 1e-15);
    RELIEVO_CHECK(place.x >= 0. && place.x <= 1. && place.y >= 0. && place.y <= 1.);
  }
}

// The GL_SPHERE_MAP texture generation of OpenGL 1's specification.
void TestSphereMapFormula()
{
  double worst = 0.;
  for (const glm::dvec3& r : Directions(20000))
  {
    const double m = 2. * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1.) * (r.z + 1.));
    if (m > 1e-3)
    {
      const glm::dvec2 place(r.x / m + 0.5, r.y / m + 0.5);
      worst = std::max(worst, Apart(f64::relievoSphereMapFromDirection(r), place));
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 1e-12, "sphere map against the specification");
}

// A direction comes back from its place: degrees between the two.
template <typename Vec3, typename Work>
double WorstReturn(Work work)
{
  double worst = 0.;
  for (const glm::dvec3& d : Directions(200000))
  {
    worst = std::max(worst, Degrees(d, glm::dvec3(work(Vec3(d)))));
  }
  return worst;
}

void TestReturns()
{
  RELIEVO_CHECK_AT_MOST(WorstReturn<glm::dvec3>([](const glm::dvec3& d) {
    return f64::relievoDirectionFromEquirectangular(f64::relievoEquirectangularFromDirection(d));
  }),
    1e-13, "equirectangular and back, double, degrees");
  RELIEVO_CHECK_AT_MOST(WorstReturn<glm::vec3>([](const glm::vec3& d) {
    return f32::relievoDirectionFromEquirectangular(f32::relievoEquirectangularFromDirection(d));
  }),
    5e-5, "equirectangular and back, float, degrees");
  RELIEVO_CHECK_AT_MOST(WorstReturn<glm::dvec3>([](const glm::dvec3& d) {
    const int face = f64::relievoCubeFace(d);
    return f64::relievoDirectionFromCube(f64::relievoCubeFromDirection(d, face), face);
  }),
    2e-14, "cube and back, double, degrees");
  RELIEVO_CHECK_AT_MOST(WorstReturn<glm::vec3>([](const glm::vec3& d) {
    const int face = f32::relievoCubeFace(d);
    return f32::relievoDirectionFromCube(f32::relievoCubeFromDirection(d, face), face);
  }),
    1e-5, "cube and back, float, degrees");
  // Near -z the whole circle is one direction: a place's last bit weighs as its root.
  RELIEVO_CHECK_AT_MOST(WorstReturn<glm::dvec3>([](const glm::dvec3& d) {
    return f64::relievoDirectionFromSphereMap(f64::relievoSphereMapFromDirection(d));
  }),
    4e-6, "sphere map and back, double, degrees");
  RELIEVO_CHECK_AT_MOST(WorstReturn<glm::vec3>([](const glm::vec3& d) {
    return f32::relievoDirectionFromSphereMap(f32::relievoSphereMapFromDirection(d));
  }),
    0.1, "sphere map and back, float, degrees");
}

using Mapping = std::function<glm::dvec3(const glm::dvec2&)>;
using Density = std::function<double(const glm::dvec2&)>;

// Densities against the area of the mapped parallelogram, and their sum over the image.
double TestDensity(const std::string& name, const Mapping& map, const Density& density)
{
  constexpr int Steps = 400;
  double worst = 0.;
  double sum = 0.;
  for (int j = 0; j < Steps; ++j)
  {
    for (int i = 0; i < Steps; ++i)
    {
      const glm::dvec2 st((i + 0.5) / Steps, (j + 0.5) / Steps);
      const double value = density(st);
      sum += value / (Steps * Steps);
      if (value > 0.)
      {
        const double h = 1e-6;
        const glm::dvec3 a = map(st + glm::dvec2(h, 0.)) - map(st - glm::dvec2(h, 0.));
        const glm::dvec3 b = map(st + glm::dvec2(0., h)) - map(st - glm::dvec2(0., h));
        const double area = glm::length(glm::cross(a, b)) / (4. * h * h);
        worst = std::max(worst, std::abs(area - value) / value);
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 1e-5, name + ": density against differences, relative");
  return sum;
}

void TestDensities()
{
  const double whole = 4. * Pi;
  const double equirectangular = TestDensity("equirectangular",
    f64::relievoDirectionFromEquirectangular, f64::relievoEquirectangularDensity);
  RELIEVO_CHECK_NEAR(equirectangular, whole, 1e-4, "equirectangular: the whole sphere");
  for (int face = 0; face < 6; ++face)
  {
    const double part = TestDensity(
      "cube face " + std::to_string(face),
      [face](
        const glm::dvec2& st) { return glm::normalize(f64::relievoDirectionFromCube(st, face)); },
      f64::relievoCubeDensity);
    RELIEVO_CHECK_NEAR(part, whole / 6., 1e-5, "cube: a sixth of the sphere");
  }
  const double ball =
    TestDensity("sphere map", f64::relievoDirectionFromSphereMap, [](const glm::dvec2& st) {
      // Differences do not work across the circle.
      return glm::length(st - 0.5) > 0.499 && glm::length(st - 0.5) < 0.501
        ? 0.
        : f64::relievoSphereMapDensity(st);
    });
  const double inner = 4. * 0.499 * 0.499;
  RELIEVO_CHECK_NEAR(ball, whole * inner, 2e-3, "sphere map: the sphere but its rim");
}

// Integrals over the sphere: in height by Gauss's two points a step, exact for cubic polynomials;
// around by even steps.
template <typename Work>
double OverSphere(Work work)
{
  constexpr int Rows = 100;
  double sum = 0.;
  for (int j = 0; j < 2 * Rows; ++j)
  {
    const int step = j / 2;
    const double z = -1. + (2. * step + 1. + (j % 2 ? 1. : -1.) / std::sqrt(3.)) / Rows;
    const double r = std::sqrt(1. - z * z);
    for (int i = 0; i < 4 * Rows; ++i)
    {
      const double angle = 2. * Pi * (i + 0.5) / (4. * Rows);
      sum += work(glm::dvec3(r * std::cos(angle), r * std::sin(angle), z));
    }
  }
  return sum * 4. * Pi / (8. * Rows * Rows);
}

void TestHarmonics()
{
  double worst = 0.;
  for (int a = 0; a < 9; ++a)
  {
    for (int b = 0; b <= a; ++b)
    {
      const double product = OverSphere([a, b](const glm::dvec3& d) {
        return f64::relievoShBasis(a, d) * f64::relievoShBasis(b, d);
      });
      worst = std::max(worst, std::abs(product - (a == b ? 1. : 0.)));
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 1e-7, "harmonics: orthonormal");
  // The cosine lobe's factors, from the lobe itself: about z only harmonics with m = 0 count.
  for (const int index : { 0, 2, 6 })
  {
    const double lobe = OverSphere(
      [index](const glm::dvec3& d) { return std::max(d.z, 0.) * f64::relievoShBasis(index, d); });
    const double factor =
      f64::relievoShCosineLobe(index) * f64::relievoShBasis(index, glm::dvec3(0., 0., 1.));
    RELIEVO_CHECK_NEAR(factor, lobe, 1e-5, "cosine lobe, harmonic " + std::to_string(index));
  }
  // Radiance 2 + a . d + a quadratic: its irradiance in closed form, and by the coefficients.
  const glm::dvec3 slope(0.3, -0.5, 0.7);
  const auto radiance = [&slope](const glm::dvec3& d) {
    return 2. + glm::dot(slope, d) + 0.4 * d.x * d.y - 0.2 * d.y * d.z + 0.1 * d.x * d.x;
  };
  glm::dvec3 coefficients[9];
  glm::vec3 rounded[9];
  for (int i = 0; i < 9; ++i)
  {
    coefficients[i] = glm::dvec3(OverSphere(
      [&radiance, i](const glm::dvec3& d) { return radiance(d) * f64::relievoShBasis(i, d); }));
    rounded[i] = glm::vec3(coefficients[i]);
  }
  double off = 0.;
  double offFloat = 0.;
  for (const glm::dvec3& n : Directions(20))
  {
    const double brute =
      OverSphere([&](const glm::dvec3& d) { return radiance(d) * std::max(glm::dot(d, n), 0.); });
    off = std::max(off, std::abs(f64::relievoShIrradiance(n, coefficients).x - brute) / brute);
    offFloat = std::max(
      offFloat, std::abs(f32::relievoShIrradiance(glm::vec3(n), rounded).y - brute) / brute);
  }
  RELIEVO_CHECK_AT_MOST(off, 1e-4, "irradiance of a quadratic environment, relative");
  RELIEVO_CHECK_AT_MOST(offFloat, 1e-4, "the same in float");
}

// GGX as the paper writes it, by the half vector, times the cosine.
double TextbookWeight(double x, double roughness)
{
  const double alpha = roughness * roughness;
  const double cosine = std::sqrt((1. + x) / 2.);
  const double below = cosine * cosine * (alpha * alpha - 1.) + 1.;
  return x > 0. ? alpha * alpha / (Pi * below * below) * x : 0.;
}

void TestPrefilter()
{
  double worst = 0.;
  double worstFloat = 0.;
  for (const double roughness : { 0.05, 0.2, 0.5, 0.8, 1. })
  {
    const double alpha = roughness * roughness;
    const double factor = alpha * alpha / Pi;
    for (int i = -1000; i <= 1000; ++i)
    {
      const double x = std::cos(Pi * i / 1000.);
      const double expected = TextbookWeight(x, roughness);
      const double got = factor * f64::relievoPrefilterWeight(x, roughness);
      const double gotFloat = factor * f32::relievoPrefilterWeight(float(x), float(roughness));
      const double scale = std::max(expected, 1e-12);
      worst = std::max(worst, std::abs(got - expected) / scale);
      // For narrow lobes, the rounding of x to float determines the error.
      const double exact = TextbookWeight(float(x), float(roughness));
      worstFloat = std::max(worstFloat, std::abs(gotFloat - exact) / std::max(exact, 1e-12));
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 1e-9, "GGX weight, double, relative");
  RELIEVO_CHECK_AT_MOST(worstFloat, 2e-6, "GGX weight, float, relative");
  for (const int levels : { 1, 2, 6, 9 })
  {
    for (int level = 0; level < levels; ++level)
    {
      const double roughness = f64::relievoPrefilterRoughness(level, levels);
      RELIEVO_CHECK_NEAR(f64::relievoPrefilterLevel(roughness, levels), level, 1e-14,
        "level of a level's roughness");
    }
    RELIEVO_CHECK(f64::relievoPrefilterLevel(7., levels) == levels - 1.);
    RELIEVO_CHECK(f64::relievoPrefilterLevel(-1., levels) == 0.);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasEnvironment)
{
  Session session;
  TestAxes();
  TestCubeTable();
  TestSphereMapFormula();
  TestReturns();
  TestDensities();
  TestHarmonics();
  TestPrefilter();
  return session.Result();
}
}
