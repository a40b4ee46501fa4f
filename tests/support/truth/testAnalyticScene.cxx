// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ray casting in closed form compared with marching along the ray through each shape's own
// inequality.
#include "AnalyticScene.h"
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <string>

namespace testAnalyticScene
{
namespace
{
using relievoTest::AnalyticScene;
using relievoTest::Ray;
using relievoTest::SurfacePoint;

using Inequality = std::function<double(const glm::dvec3&)>;

// Negative inside.
double Sphere(const glm::dvec3& p)
{
  return glm::length(p) - 1.2;
}

double Box(const glm::dvec3& p)
{
  const glm::dvec3 q = glm::abs(p) - glm::dvec3(0.5, 1., 0.7);
  return std::max({ q.x, q.y, q.z });
}

double Torus(const glm::dvec3& p)
{
  return std::hypot(std::hypot(p.x, p.y) - 1., p.z) - 0.3;
}

const int MarchSteps = 4000;

// The first change of sign in [tMin, tMax], by steps and bisection; infinity for none.
double March(const Inequality& inside, const Ray& ray, double tMin, double tMax)
{
  double before = tMin;
  const bool first = inside(ray.At(before)) < 0.;
  for (int i = 1; i <= MarchSteps; ++i)
  {
    double after = tMin + (tMax - tMin) * i / MarchSteps;
    if ((inside(ray.At(after)) < 0.) != first)
    {
      for (int halving = 0; halving < 80; ++halving)
      {
        const double middle = 0.5 * (before + after);
        ((inside(ray.At(middle)) < 0.) == first ? before : after) = middle;
      }
      return 0.5 * (before + after);
    }
    before = after;
  }
  return std::numeric_limits<double>::infinity();
}

// The outward normal, by differences.
glm::dvec3 Gradient(const Inequality& f, const glm::dvec3& p)
{
  const double h = 1e-6;
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 step(0.);
    step[axis] = h;
    gradient[axis] = f(p + step) - f(p - step);
  }
  return glm::normalize(gradient);
}

void TestShape(const std::string& name, const AnalyticScene& scene, const Inequality& inequality,
  const glm::dmat4& place)
{
  const glm::dmat4 toLocal = glm::inverse(place);
  const Inequality inside = [&](const glm::dvec3& p) {
    return inequality(glm::dvec3(toLocal * glm::dvec4(p, 1.)));
  };
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  const auto point = [&](double spread) {
    const glm::dvec3 p(normal(random), normal(random), normal(random));
    return glm::dvec3(place * glm::dvec4(spread * p, 1.));
  };
  int hits = 0;
  int missed = 0;
  int thin = 0;
  double worst = 0.;
  double worstAngle = 0.;
  for (int i = 0; i < 3000; ++i)
  {
    // Starts outside and inside; every third ray aims at an edge-on position.
    const glm::dvec3 from = point(i % 2 ? 3. : 0.5);
    const Ray ray{ from, point(i % 3 ? 0.6 : 1.2) - from };
    const SurfacePoint found = scene.Cast(ray, 0., 3.);
    const double expected = March(inside, ray, 0., 3.);
    // Marching may step over parts thinner than a step: a grazed rim, a cut corner.
    const SurfacePoint exit = scene.Cast(ray, std::nextafter(found.Depth + 1e-12, 9.), 9.);
    if (found.Hit && exit.Depth - found.Depth < 1.01 * 3. / MarchSteps)
    {
      ++thin;
      continue;
    }
    if (found.Hit != std::isfinite(expected))
    {
      ++missed;
      continue;
    }
    if (!found.Hit)
    {
      continue;
    }
    ++hits;
    worst = std::max(worst, std::abs(found.Depth - expected));
    // The first change of sign goes inwards exactly where the ray comes from outside.
    RELIEVO_CHECK(found.FrontFacing == (inside(from) >= 0.));
    const glm::dvec3 outward = found.FrontFacing ? found.Normal : -found.Normal;
    worstAngle =
      std::max(worstAngle, relievoTest::AngleDegrees(outward, Gradient(inside, found.Position)));
    RELIEVO_CHECK(glm::dot(found.Normal, ray.Direction) <= 0.);
    RELIEVO_CHECK(std::abs(glm::length(found.Normal) - 1.) < 1e-12);
  }
  std::cout << name << ": " << hits << " hits, " << thin << " too thin to march\n";
  RELIEVO_CHECK(hits > 500 && thin < 20);
  RELIEVO_CHECK(missed == 0);
  RELIEVO_CHECK_AT_MOST(worst, 1e-12, name + ": depth off marching");
  if (name.find("box") == std::string::npos)
  {
    RELIEVO_CHECK_AT_MOST(worstAngle, 1e-6, name + ": normal off differences, degrees");
  }
}

glm::dmat4 Placed()
{
  glm::dmat4 place = glm::translate(glm::dmat4(1.), glm::dvec3(3., -2., 5.));
  place = glm::rotate(place, 0.7, glm::normalize(glm::dvec3(1., 2., -0.5)));
  return glm::scale(place, glm::dvec3(1.5, -0.6, 1.)); // mirrored, not uniform
}

void TestShapes()
{
  for (const glm::dmat4& place : { glm::dmat4(1.), Placed() })
  {
    AnalyticScene sphere;
    sphere.AddSphere(1.2, place);
    TestShape("sphere", sphere, Sphere, place);
    AnalyticScene box;
    box.AddBox(glm::dvec3(0.5, 1., 0.7), place);
    TestShape("box", box, Box, place);
    AnalyticScene torus;
    torus.AddTorus(1., 0.3, place);
    TestShape("torus", torus, Torus, place);
  }
}

// Depths known in advance.
void TestKnown()
{
  AnalyticScene scene;
  const int plane = scene.AddPlane(4., 2.);
  const int torus =
    scene.AddTorus(1., 0.25, glm::translate(glm::dmat4(1.), glm::dvec3(0., 0., 3.)));
  const Ray down{ glm::dvec3(1., 0., 10.), glm::dvec3(0., 0., -2.) };
  SurfacePoint point = scene.Cast(down, 0., 100.);
  RELIEVO_CHECK(point.Hit && point.Actor == torus && point.FrontFacing);
  RELIEVO_CHECK_NEAR(point.Depth, (10. - 3.25) / 2., 1e-14, "top of the torus");
  RELIEVO_CHECK(relievoTest::AngleDegrees(point.Normal, glm::dvec3(0., 0., 1.)) < 1e-6);
  point = scene.Cast(down, 3.5, 100.);
  RELIEVO_CHECK(point.Hit && !point.FrontFacing);
  RELIEVO_CHECK_NEAR(point.Depth, (10. - 2.75) / 2., 1e-14, "bottom of the torus, from inside");
  point = scene.Cast(down, 3.7, 100.);
  RELIEVO_CHECK(point.Hit && point.Actor == plane && point.Depth == 5.);
  RELIEVO_CHECK(!scene.Cast(down, 3.7, 4.9).Hit);
  RELIEVO_CHECK(!scene.Cast(down, 5.1, 100.).Hit);

  // Through the hole, past the rectangle, from below, along the plane.
  const Ray hole{ glm::dvec3(0., 0., 10.), glm::dvec3(0., 0., -1.) };
  RELIEVO_CHECK(scene.Cast(hole, 0., 100.).Actor == plane);
  const Ray past{ glm::dvec3(0., 2.1, 10.), glm::dvec3(0., 0., -1.) };
  RELIEVO_CHECK(!scene.Cast(past, 0., 100.).Hit);
  const Ray up{ glm::dvec3(3., 0., -1.), glm::dvec3(0., 0., 1.) };
  point = scene.Cast(up, 0., 100.);
  RELIEVO_CHECK(point.Hit && !point.FrontFacing && point.Normal.z == -1.);
  const Ray along{ glm::dvec3(-9., 0., 0.), glm::dvec3(1., 0., 0.) };
  RELIEVO_CHECK(!scene.Cast(along, 0., 1.).Hit);
  RELIEVO_CHECK(scene.Occluded(up, 0., 1.5) && !scene.Occluded(up, 0., 0.5));
}

// From 1e6 ring radii away, hits with the torus are as exact as double coordinates allow.
void TestFarAway()
{
  AnalyticScene scene;
  scene.AddTorus(1., 0.3);
  scene.AddSphere(0.5);
  double worst = 0.;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.25, 1.25);
  int hits = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 from(4e5, 3e5, 8e5);
    const Ray ray{ from, glm::normalize(glm::dvec3(share(random), share(random), 0.) - from) };
    const SurfacePoint point = scene.Cast(ray, 0., 1e9);
    if (point.Hit)
    {
      ++hits;
      worst = std::max(worst,
        std::abs(point.Actor == 0 ? Torus(point.Position) : glm::length(point.Position) - 0.5));
    }
  }
  RELIEVO_CHECK(hits > 1000);
  RELIEVO_CHECK_AT_MOST(worst, 1e-8, "distance from the surface, seen from 1e6 away");
}

void TestRoots()
{
  // (t - 1) (t - 2) (t - 3) (t + 4) = t^4 - 2 t^3 - 13 t^2 + 38 t - 24
  const double c[5] = { -24., 38., -13., -2., 1. };
  double roots[4];
  RELIEVO_CHECK(relievoTest::QuarticRoots(c, -10., 10., roots) == 4);
  const double expected[4] = { -4., 1., 2., 3. };
  for (int i = 0; i < 4; ++i)
  {
    RELIEVO_CHECK_NEAR(roots[i], expected[i], 1e-12, "root of a quartic");
  }
  RELIEVO_CHECK(relievoTest::QuarticRoots(c, 1.5, 10., roots) == 2);
  RELIEVO_CHECK_NEAR(roots[0], 2., 1e-12, "first root of the range");
  const double none[5] = { 1., 0., 1., 0., 1. };
  RELIEVO_CHECK(relievoTest::QuarticRoots(none, -10., 10., roots) == 0);
  const double line[5] = { -3., 1.5, 0., 0., 0. };
  RELIEVO_CHECK(relievoTest::QuarticRoots(line, -10., 10., roots) == 1 && roots[0] == 2.);
}

void TestMatrix()
{
  const double rows[16] = { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 1 };
  const glm::dvec4 p = AnalyticScene::ToMatrix(rows) * glm::dvec4(1., 1., 1., 1.);
  RELIEVO_CHECK(p.x == 10. && p.y == 26. && p.z == 42. && p.w == 1.);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testAnalyticScene)
{
  relievoTest::Session session;
  TestShapes();
  TestKnown();
  TestFarAway();
  TestRoots();
  TestMatrix();
  return session.Result();
}
}
