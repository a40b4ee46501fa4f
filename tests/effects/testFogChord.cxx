// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The chord of a pixel's ray in a sphere, as the shader computes it in float, against long double:
// to 1e-5 radii up to a distance of 1e4 radii, wherever eye and surface are, in every projection.
#include "Check.h"
#include "FogChord.h"
#include "FogTruth.h"
#include "Session.h"
#include "TestCase.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace testFogChord
{
namespace
{
using namespace relievoTest;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr int Width = 641;
constexpr int Height = 481;

struct Case
{
  std::string Name;
  vtkRelievoFrameCamera View;
  glm::dvec3 Center;
  double Radius;
};

// A view in which a sphere of this angle (perspective) or size (parallel) fills most of the height.
vtkRelievoFrameCamera MakeView(bool parallel, double half, const glm::dvec2& center, double shear)
{
  vtkRelievoFrameCamera view;
  view.Viewport[2] = Width;
  view.Viewport[3] = Height;
  view.Parallel = parallel;
  view.Near = 0.01;
  view.Far = 1e6;
  const double across = half * Width / Height;
  const double left = (center.x - 1.) * across;
  const double right = (center.x + 1.) * across;
  const double bottom = (center.y - 1.) * half;
  const double top = (center.y + 1.) * half;
  view.ViewToNDC = parallel ? glm::ortho(left, right, bottom, top, view.Near, view.Far)
                            : glm::frustum(left * view.Near, right * view.Near, bottom * view.Near,
                                top * view.Near, view.Near, view.Far);
  if (shear != 0.)
  {
    // A shear like that of vtkCamera::SetViewShear: x and y move with the distance from a plane.
    glm::dmat4 sheared(1.);
    sheared[2][0] = shear;
    sheared[2][1] = -0.5 * shear;
    sheared[3][0] = shear * 2.;
    view.ViewToNDC = view.ViewToNDC * sheared;
  }
  return view;
}

// The greatest error in radii over pixels and ends.
double LargestError(const Case& one, std::mt19937& random, int& compared)
{
  const vtkRelievoSphereRays rays(one.View);
  vtkRelievoSphereRays::Sphere sphere;
  double largest = 0.;
  if (!rays.Find(one.Center, one.Radius, sphere))
  {
    return largest;
  }
  const double depth = -one.Center.z;
  std::uniform_int_distribution<int> column(sphere.Rectangle[0], sphere.Rectangle[2] - 1);
  std::uniform_int_distribution<int> row(sphere.Rectangle[1], sphere.Rectangle[3] - 1);
  std::uniform_real_distribution<double> inside(-1.1, 1.1);
  for (int i = 0; i < 4000; ++i)
  {
    const double x = column(random) + 0.5;
    const double y = row(random) + 0.5;
    const double ends[] = { Infinity, depth, depth + inside(random) * one.Radius,
      depth + 3. * one.Radius, 0.5 * (depth - one.Radius), depth - 1.0001 * one.Radius };
    for (const double end : ends)
    {
      // The layer is float, and no surface is before the near plane.
      const float seen = static_cast<float>(std::max(end, one.View.Near));
      const double truth =
        static_cast<double>(ChordTruth(one.View, x, y, one.Center, one.Radius, seen));
      const float chord = FogChord(rays, sphere, one.Radius, x, y, seen);
      const double error = std::abs(chord - truth / one.Radius);
      largest = error > largest || std::isnan(error) ? error : largest;
      ++compared;
    }
  }
  return largest;
}

std::vector<Case> MakeCases(double distance, double radius)
{
  std::vector<Case> cases;
  const double away = distance * radius;
  for (const bool parallel : { false, true })
  {
    // Half of the view: at depth 1 in perspective.
    const double half = parallel ? 1.3 * radius : 1.3 / std::max(1., distance);
    for (const double shear : { 0., 0.2 })
    {
      for (const glm::dvec2& center : { glm::dvec2(0.), glm::dvec2(0.7, -0.4) })
      {
        Case one;
        one.Name = std::string(parallel ? "parallel" : "perspective") +
          (shear != 0. ? ", sheared" : "") + (center.x != 0. ? ", off-centre" : "") +
          ", distance " + std::to_string(distance) + " radius " + std::to_string(radius);
        one.View = MakeView(parallel, half, center, shear);
        one.Radius = radius;
        // A place that is seen a little beside the middle.
        one.Center = glm::dvec3(PointAt(one.View, 0.48 * Width, 0.55 * Height, away));
        cases.push_back(one);
      }
    }
  }
  return cases;
}

void TestErrors()
{
  std::mt19937 random(7);
  for (const double radius : { 1e-3, 1., 250. })
  {
    for (const double distance : { 0., 0.3, 0.999, 1., 1.001, 1.5, 10., 100., 1e3, 1e4 })
    {
      double largest = 0.;
      int compared = 0;
      for (const Case& one : MakeCases(distance, radius))
      {
        const double error = LargestError(one, random, compared);
        RELIEVO_CHECK_THAT(error <= 1e-5, one.Name + ": error " + std::to_string(error));
        largest = std::max(largest, error);
      }
      RELIEVO_CHECK(compared > 100000);
      RELIEVO_CHECK_AT_MOST(largest, 1e-5,
        "error in radii, distance " + std::to_string(distance) + " radii of " +
          std::to_string(radius));
    }
  }
}

// Rays that graze: by these shares of the radius less than it from the centre.
double LargestOutlineError(double distance, bool pairs)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> column(0, Width - 1);
  std::uniform_int_distribution<int> row(0, Height - 1);
  std::uniform_real_distribution<double> turn(0., 6.28);
  double largest = 0.;
  int found = 0;
  for (Case one : MakeCases(distance, 1.))
  {
    const vtkRelievoSphereRays rays(one.View);
    const double depth = -one.Center.z;
    for (int i = 0; i < 3000; ++i)
    {
      const double x = column(random) + 0.5;
      const double y = row(random) + 0.5;
      const double share = std::pow(10., -3. - i % 9);
      const glm::dvec3 at(PointAt(one.View, x, y, depth));
      const glm::dvec3 ray = glm::normalize(glm::dvec3(PointAt(one.View, x, y, depth + 1.L)) - at);
      const glm::dvec3 side = glm::normalize(glm::cross(ray, glm::dvec3(0., 1., 0.)));
      const double angle = turn(random);
      const glm::dvec3 center =
        at + (1. - share) * (std::cos(angle) * side + std::sin(angle) * glm::cross(side, ray));
      vtkRelievoSphereRays::Sphere sphere;
      if (!rays.Find(center, 1., sphere))
      {
        continue;
      }
      ++found;
      const double truth = static_cast<double>(ChordTruth(one.View, x, y, center, 1., Infinity));
      const float chord = FogChord(rays, sphere, 1., x, y, static_cast<float>(Infinity), pairs);
      largest = std::max(largest, std::abs(chord - truth));
    }
  }
  RELIEVO_CHECK(found > 20000);
  return largest;
}

void TestOutlines()
{
  for (const double distance : { 2., 10., 100., 1e3, 1e4 })
  {
    RELIEVO_CHECK_AT_MOST(LargestOutlineError(distance, true), 1e-5,
      "error in radii of rays that graze, distance " + std::to_string(distance));
  }
  // With one float for each coefficient it is not reached: the pairs are needed.
  RELIEVO_CHECK(LargestOutlineError(1e3, false) > 1e-4);
}

// The truth's closed form against steps along the ray.
void TestQuadrature()
{
  constexpr int Steps = 400000;
  std::mt19937 random(11);
  for (const double distance : { 0., 0.7, 1., 3., 1e3 })
  {
    for (const Case& one : MakeCases(distance, 2.))
    {
      std::uniform_real_distribution<double> x(0.2 * Width, 0.8 * Width);
      std::uniform_real_distribution<double> y(0.2 * Height, 0.8 * Height);
      for (const double end : { Infinity, -one.Center.z + 0.5 })
      {
        const double at[2] = { x(random), y(random) };
        const long double closed = ChordTruth(one.View, at[0], at[1], one.Center, one.Radius, end);
        const long double added =
          ChordByQuadrature(one.View, at[0], at[1], one.Center, one.Radius, end, Steps);
        RELIEVO_CHECK_THAT(std::abs(closed - added) < 3e-5L * one.Radius,
          one.Name + ": closed " + std::to_string(closed) + ", added " + std::to_string(added));
      }
    }
  }
}

// By hand: a sphere of radius 1 on the axis, the middle pixel.
void TestClosedForms()
{
  const auto chord = [](double depth, double radius, double end) {
    const vtkRelievoFrameCamera view = MakeView(false, 0.5, glm::dvec2(0.), 0.);
    const vtkRelievoSphereRays rays(view);
    vtkRelievoSphereRays::Sphere sphere;
    return rays.Find(glm::dvec3(0., 0., -depth), radius, sphere)
      ? radius * FogChord(rays, sphere, radius, 320.5, 240.5, static_cast<float>(end))
      : 0.f;
  };
  const double close = 1e-5;
  RELIEVO_CHECK_NEAR(chord(5., 1., Infinity), 2., close, "before the sky");
  RELIEVO_CHECK_NEAR(chord(5., 1., 4.5), 0.5, close, "surface inside");
  RELIEVO_CHECK_NEAR(chord(5., 1., 3.), 0., 0., "surface before");
  RELIEVO_CHECK_NEAR(chord(5., 1., 9.), 2., close, "surface behind");
  RELIEVO_CHECK_NEAR(chord(0., 1., Infinity), 1., close, "eye at the centre");
  RELIEVO_CHECK_NEAR(chord(0., 1., 0.25), 0.25, close, "eye and surface inside");
  RELIEVO_CHECK_NEAR(chord(-0.5, 1., Infinity), 0.5, close, "centre behind the eye");
  RELIEVO_CHECK_NEAR(chord(-1., 1., Infinity), 0., close, "eye on the sphere, looking away");
  RELIEVO_CHECK_NEAR(chord(1., 1., Infinity), 2., close, "eye on the sphere, looking in");
  RELIEVO_CHECK_NEAR(chord(-3., 1., Infinity), 0., 0., "sphere behind the eye");
  RELIEVO_CHECK_NEAR(chord(0.005, 0.004, Infinity), 0.008, 1e-7, "between eye and near plane");
  // Inside one that is as large as a planet: the way to the surface, whatever the radius.
  RELIEVO_CHECK_NEAR(chord(0.3e9, 1e9, 5.), 5., 1e-5, "in a sphere of radius 1e9");
  RELIEVO_CHECK_NEAR(chord(3., 1e-6, Infinity), 2e-6, 1e-11, "through one of radius 1e-6");
}

void TestOpticalDepths()
{
  namespace f32 = relievo::f32;
  RELIEVO_CHECK_NEAR(f32::relievoFogBeer(1.5f, 0.4f), 0.6, 1e-7, "Beer and Lambert");
  RELIEVO_CHECK(f32::relievoFogBeer(2.f, 1e30f) == 1e6f);
  for (const double held : { 1e-6, 0.1, 0.5, 0.99 })
  {
    RELIEVO_CHECK_NEAR(std::exp(-f32::relievoFogLinear(2.f, static_cast<float>(held))), 1. - held,
      2e-7, "what passes of the classic");
  }
  RELIEVO_CHECK(std::exp(-f32::relievoFogLinear(2.f, 3.f)) < 2e-7);
  for (const double depth : { 1e-9, 1e-4, 0.00999, 0.01001, 0.3, 5., 1e6 })
  {
    RELIEVO_CHECK_NEAR(
      f32::relievoFogShare(static_cast<float>(depth)) * depth / -std::expm1(-depth), 1., 2e-5,
      "share at " + std::to_string(depth));
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFogChord)
{
  relievoTest::Session session;
  TestClosedForms();
  TestQuadrature();
  TestErrors();
  TestOutlines();
  TestOpticalDepths();
  return session.Result();
}
}
