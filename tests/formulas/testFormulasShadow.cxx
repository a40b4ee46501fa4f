// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Receiver planes in a shadow map against points of the plane that are carried there one by one, in
// double, for parallel, sheared and perspective lights; float against double; which side faces the
// light; the filter's weights.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace testFormulasShadow
{
namespace
{
namespace f32 = relievo::f32;
namespace f64 = relievo::f64;

struct Light
{
  std::string Name;
  glm::dmat4 ViewToMap{ 1. };
  bool Parallel = true;
  glm::dvec3 Direction{ 0. }; // the way it shines, eye space, of parallel light
  glm::dvec3 Position{ 0. };
};

// Looks along -z of its own space: texels of a map of 2048 over 6 units, depth over 12.
glm::dmat4 MapOf(bool parallel)
{
  const double n = 2.;
  const double f = 14.;
  glm::dmat4 p(0.);
  if (parallel)
  {
    p[0][0] = p[1][1] = 2048. / 6.;
    p[2][2] = -1. / (f - n);
    p[3] = glm::dvec4(1023.5, 1023.5, -n / (f - n), 1.);
    return p;
  }
  p[0][0] = p[1][1] = 1024.;
  p[2] = glm::dvec4(-1023.5, -1023.5, -f / (f - n), -1.);
  p[3][2] = -f * n / (f - n);
  return p;
}

// From eye space to that of a light at a place, turned about x and y.
glm::dmat4 Place(const glm::dvec3& at, double a, double b)
{
  glm::dmat4 m(1.);
  m[0] = glm::dvec4(std::cos(b), std::sin(a) * std::sin(b), -std::cos(a) * std::sin(b), 0.);
  m[1] = glm::dvec4(0., std::cos(a), std::sin(a), 0.);
  m[2] = glm::dvec4(std::sin(b), -std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), 0.);
  m[3] = glm::dvec4(-glm::dvec3(m * glm::dvec4(at, 0.)), 1.);
  return m;
}

std::vector<Light> MakeLights()
{
  std::vector<Light> lights;
  for (const bool parallel : { true, false })
  {
    Light light;
    light.Name = parallel ? "parallel" : "perspective";
    light.Parallel = parallel;
    light.Position = glm::dvec3(1., 6., -3.);
    const glm::dmat4 toLight = Place(light.Position, 1.1, 0.4);
    light.ViewToMap = MapOf(parallel) * toLight;
    light.Direction = glm::dvec3(glm::inverse(toLight) * glm::dvec4(0., 0., -1., 0.));
    lights.push_back(light);
    if (parallel)
    {
      light.Name = "sheared";
      glm::dmat4 shear(1.);
      shear[2].x = 0.7;
      shear[2].y = -0.4;
      light.ViewToMap = MapOf(true) * shear * toLight;
      light.Direction = glm::dvec3(glm::inverse(shear * toLight) * glm::dvec4(0., 0., -1., 0.));
      lights.push_back(light);
    }
  }
  return lights;
}

glm::dvec3 ToMap(const glm::dmat4& viewToMap, const glm::dvec3& point)
{
  const glm::dvec4 map = viewToMap * glm::dvec4(point, 1.);
  return glm::dvec3(map) / map.w;
}

void TestPlanes(const Light& light)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  double slopeError = 0.;
  double floatError = 0.;
  int wrongSides = 0;
  int planes = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 point(1.2 * uniform(random), 1.2 * uniform(random), -7. + uniform(random));
    glm::dvec3 normal(uniform(random), uniform(random), uniform(random));
    normal = glm::normalize(normal);
    const glm::dvec3 toLight =
      glm::normalize(light.Parallel ? -light.Direction : light.Position - point);
    normal *= glm::dot(normal, point) > 0. ? -1. : 1.; // towards the eye at the origin
    const double cosine = glm::dot(normal, toLight);
    if (std::abs(cosine) < 0.05)
    {
      continue; // no slope to speak of
    }
    ++planes;
    const glm::dvec4 map = light.ViewToMap * glm::dvec4(point, 1.);
    const glm::dvec3 place = glm::dvec3(map) / map.w;
    const glm::dvec3 plane = f64::relievoMapPlane(light.ViewToMap, map, normal);
    const glm::dvec2 slope = f64::relievoReceiverSlope(plane, 1e9);
    // Other points of the plane must lie on it in the map.
    const glm::dvec3 tangent = f64::relievoTangent(normal);
    for (const glm::dvec3& way : { tangent, glm::cross(normal, tangent), -tangent })
    {
      const glm::dvec3 other = ToMap(light.ViewToMap, point + 0.3 * way);
      const glm::dvec2 moved = glm::dvec2(other) - glm::dvec2(place);
      slopeError = std::max(slopeError, std::abs(place.z + glm::dot(slope, moved) - other.z));
    }
    const glm::dvec4 eye = light.ViewToMap * glm::dvec4(0., 0., 0., 1.);
    wrongSides += (f64::relievoMapFacing(plane, place, eye) < 0.) != (cosine > 0.) ? 1 : 0;

    const glm::mat4 matrix(light.ViewToMap);
    const glm::vec4 mapFloat = matrix * glm::vec4(glm::vec3(point), 1.f);
    const glm::vec2 slopeFloat =
      f32::relievoReceiverSlope(f32::relievoMapPlane(matrix, mapFloat, glm::vec3(normal)), 1e9f);
    // Over a texel, in texels' widths of depth: the unit of the bias.
    const double texel = 6. / 2048. / 12.;
    floatError = std::max(floatError, glm::length(glm::dvec2(slopeFloat) - slope) / texel);
  }
  RELIEVO_CHECK(planes > 10000);
  RELIEVO_CHECK_AT_MOST(slopeError, 1e-12, light.Name + ": depth off the plane, in double");
  RELIEVO_CHECK_AT_MOST(wrongSides, 0, light.Name + ": planes on the wrong side");
  RELIEVO_CHECK_AT_MOST(floatError, 0.05, light.Name + ": slope in float, in texels' widths");
}

void TestWeights()
{
  for (int radius = 1; radius <= 16; ++radius)
  {
    for (const double part : { 0., 0.25, 0.5, 0.999 })
    {
      double sum = 0.;
      double centre = 0.;
      for (int i = 1 - radius; i <= radius; ++i)
      {
        const double weight = f64::relievoFilterWeight(i, radius, part);
        sum += weight;
        centre += weight * i;
      }
      const std::string what = "radius " + std::to_string(radius);
      RELIEVO_CHECK_NEAR(sum, 2. * radius - 1., 1e-12, what + ": sum of the weights");
      RELIEVO_CHECK_NEAR(centre / sum, part, 1e-12, what + ": centre of the weights");
    }
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFormulasShadow)
{
  relievoTest::Session session;
  for (const Light& light : MakeLights())
  {
    TestPlanes(light);
  }
  TestWeights();
  return session.Result();
}
}
