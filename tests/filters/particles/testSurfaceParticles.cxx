// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Particles on bodies after many steps: how far from the surface, whether along the field, none
// lost; inside them; and the speed of noise.
#include "Check.h"
#include "Particles.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "vtkRelievoSurfaceParticles.h"

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace testSurfaceParticles
{
namespace
{
using relievoTest::Places;
using relievoTest::PlacesAt;
using relievoTest::Solid;
using Particles = vtkRelievoSurfaceParticles;

void SetUp(Particles* filter, vtkPolyData* mesh, int count, int steps)
{
  filter->SetInputData(mesh);
  filter->SetNumberOfParticles(count);
  filter->SetResolution(100);
  filter->SetNumberOfSteps(steps);
}

// By noise: on the surface within a texel after 1000 steps, and moved on the way. Noise has no
// sinks, so particles are still everywhere.
void TestHeld(const std::string& name, vtkPolyData* mesh)
{
  constexpr int Steps = 1000;
  vtkNew<Particles> filter;
  SetUp(filter, mesh, 700, Steps);
  filter->Update();
  const double texel = filter->GetUsedTexelSize();
  filter->SetNoiseSpeed(0.4 * texel);
  const Places start = PlacesAt(filter, 0.);
  RELIEVO_CHECK_AT_MOST(relievoTest::LargestDistance(start, mesh) / texel, 1., name + ", at first");
  const Places places = PlacesAt(filter, Steps);
  RELIEVO_CHECK(places.size() == 700 && start.size() == 700);
  RELIEVO_CHECK_AT_MOST(relievoTest::LargestDistance(places, mesh) / texel, 1., name + ", texels");
  double moved = 0.;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    moved += glm::distance(places[i], start[i]) > 5. * texel ? 1. : 0.;
  }
  RELIEVO_CHECK_THAT(moved > 0.5 * 700, name + ", moved: " + std::to_string(moved));
}

// Once around a ball, by an array: back where they were. Without holding, this way is a circle.
void TestOnceAround()
{
  const Solid ball = relievoTest::MakeBall(1e-4);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
  constexpr int Steps = 400;
  constexpr double Pi = 3.141592653589793;
  const auto mesh = relievoTest::WithField(
    ball.Mesh, [&axis](const glm::dvec3& place) { return 2. * Pi * glm::cross(axis, place); });
  vtkNew<Particles> filter;
  SetUp(filter, mesh, 2000, Steps);
  filter->SetFieldArray("field");
  filter->SetTimeStep(1. / Steps);
  const Places start = PlacesAt(filter, 0.);
  const Places quarter = PlacesAt(filter, 0.25);
  const Places end = PlacesAt(filter, 1.);
  const double texel = filter->GetUsedTexelSize();
  double sum = 0.;
  double largest = 0.;
  double quarterLargest = 0.;
  for (std::size_t i = 0; i < start.size(); ++i)
  {
    const double distance = glm::distance(start[i], end[i]) / texel;
    sum += distance * distance;
    largest = std::max(largest, distance);
    const glm::dvec3 along = glm::dot(axis, start[i]) * axis;
    const glm::dvec3 truth = along + glm::cross(axis, start[i]);
    quarterLargest = std::max(quarterLargest, glm::distance(truth, quarter[i]) / texel);
  }
  // A way of 314 texels at the equator.
  RELIEVO_CHECK_AT_MOST(std::sqrt(sum / 2000.), 1., "once around, rms, texels");
  RELIEVO_CHECK_AT_MOST(largest, 3., "once around, largest, texels");
  RELIEVO_CHECK_AT_MOST(quarterLargest, 2., "a quarter around, largest, texels");
}

// Downwards on a ball: all end at its lowest point, where the tangential velocity is 0.
void TestDownwards()
{
  const Solid ball = relievoTest::MakeBall(1e-4);
  vtkNew<Particles> filter;
  SetUp(filter, ball.Mesh, 1000, 400);
  filter->SetVelocity(0., 0., -0.05);
  const Places places = PlacesAt(filter, 400.);
  double highest = -1.;
  for (const glm::dvec3& place : places)
  {
    highest = std::max(highest, place.z);
  }
  RELIEVO_CHECK(places.size() == 1000);
  RELIEVO_CHECK_AT_MOST(highest, -0.99, "height");
}

// Normals and quaternions against the ball's own; speed by noise.
void TestArrays()
{
  const Solid ball = relievoTest::MakeBall(1e-4);
  vtkNew<Particles> filter;
  SetUp(filter, ball.Mesh, 20000, 1);
  filter->SetResolution(200);
  filter->SetNoiseSpeed(3.);
  filter->SetNoiseScale(0.3);
  filter->OrientationsOn();
  const Places places = PlacesAt(filter, 0.);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  auto* normals = vtkFloatArray::SafeDownCast(data->GetArray("normal"));
  auto* velocities = vtkFloatArray::SafeDownCast(data->GetArray("velocity"));
  auto* turns = vtkFloatArray::SafeDownCast(data->GetArray("orientation"));
  RELIEVO_CHECK(normals && velocities && turns && data->GetNormals() == normals);
  double worst = 0.;
  double squares = 0.;
  double turned = 0.;
  double octants[8] = {};
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const auto at = static_cast<vtkIdType>(i);
    double n[3];
    double v[3];
    double q[4];
    normals->GetTuple(at, n);
    velocities->GetTuple(at, v);
    turns->GetTuple(at, q);
    const glm::dvec3 normal(n[0], n[1], n[2]);
    const glm::dvec3 velocity(v[0], v[1], v[2]);
    worst = std::max(worst, glm::distance(normal, glm::normalize(places[i])));
    squares += glm::dot(velocity, velocity);
    // The images of x and of y under the quaternion.
    const glm::dvec3 x(1. - 2. * (q[2] * q[2] + q[3] * q[3]), 2. * (q[1] * q[2] + q[0] * q[3]),
      2. * (q[1] * q[3] - q[0] * q[2]));
    const glm::dvec3 y(2. * (q[1] * q[2] - q[0] * q[3]), 1. - 2. * (q[1] * q[1] + q[3] * q[3]),
      2. * (q[2] * q[3] + q[0] * q[1]));
    turned = std::max({ turned, glm::distance(x, normal),
      glm::length(velocity) > 0.01 ? glm::distance(y, glm::normalize(velocity)) : 0. });
    octants[(places[i].x > 0.) + 2 * (places[i].y > 0.) + 4 * (places[i].z > 0.)] += 8. / 20000.;
  }
  RELIEVO_CHECK_AT_MOST(worst, 0.05, "normals");
  RELIEVO_CHECK_AT_MOST(turned, 1e-3, "orientations");
  RELIEVO_CHECK_NEAR(std::sqrt(squares / 20000.), 3., 0.15, "speed by noise on a surface");
  for (const double octant : octants)
  {
    RELIEVO_CHECK_NEAR(octant, 1., 0.03, "share of an octant");
  }
  filter->SetPlace(Particles::INSIDE);
  PlacesAt(filter, 0.);
  velocities =
    vtkFloatArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray("velocity"));
  squares = 0.;
  for (vtkIdType i = 0; i < velocities->GetNumberOfValues(); ++i)
  {
    squares += std::pow(static_cast<double>(velocities->GetValue(i)), 2);
  }
  RELIEVO_CHECK_NEAR(std::sqrt(squares / 20000.), 3., 0.2, "speed by noise inside");
}

// Inside, pressed against the walls by a velocity, and stirred by noise.
void TestInside(const Solid& solid)
{
  for (const bool noise : { false, true })
  {
    vtkNew<Particles> filter;
    SetUp(filter, solid.Mesh, 1000, 200);
    filter->SetPlace(Particles::INSIDE);
    filter->Update();
    const double texel = filter->GetUsedTexelSize();
    filter->SetVelocity(0.5 * texel, 0., noise ? 0. : -0.4 * texel);
    filter->SetNoiseSpeed(noise ? texel : 0.);
    const Places places = PlacesAt(filter, 200.);
    double outside = 0.;
    for (const glm::dvec3& place : places)
    {
      outside = std::max(outside, solid.DistanceAt(place) / texel);
    }
    RELIEVO_CHECK(places.size() == 1000);
    RELIEVO_CHECK_AT_MOST(outside, 1., solid.Name + ", outside, texels");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSurfaceParticles)
{
  relievoTest::Session session;
  const glm::dmat3 tilted = relievoTest::Turn({ 1., 0.3, 0.2 }, 37.);
  for (const Solid& solid : { relievoTest::MakeBall(), relievoTest::MakeTorus(1e-3, tilted),
         relievoTest::MakeBowl(1e-3, tilted), relievoTest::MakeBox(tilted) })
  {
    TestHeld(solid.Name, solid.Mesh);
  }
  TestOnceAround();
  TestDownwards();
  TestArrays();
  TestInside(relievoTest::MakeBall());
  TestInside(relievoTest::MakeTorus(1e-3, tilted));
  TestInside(relievoTest::MakeBox(tilted));
  return session.Result();
}
}
