// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Particles start evenly: faces of a cube and parts of a sphere and a torus have shares that chance
// allows (chi square), at a resolution at which a texel is a sixtieth of the body.
#include "Check.h"
#include "Particles.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "vtkRelievoSurfaceParticles.h"

#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace testSurfaceParticlesEven
{
namespace
{
using Part = std::function<std::size_t(const glm::dvec3&)>;

const glm::dmat3 Turns[] = { glm::dmat3(1.), relievoTest::Turn({ 1., 2., 3. }, 30.),
  relievoTest::Turn({ 0., 1., 0. }, 45.) };

vtkSmartPointer<vtkPolyData> Cube(const glm::dmat3& turn)
{
  vtkNew<vtkCubeSource> source;
  source->Update();
  vtkPolyData* cube = source->GetOutput();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 point;
    cube->GetPoint(i, &point.x);
    point = turn * point;
    points->InsertNextPoint(&point.x);
  }
  cube->SetPoints(points);
  return cube;
}

std::size_t FaceOf(const glm::dvec3& p)
{
  const glm::dvec3 a = glm::abs(p);
  const int axis = a.x > a.y && a.x > a.z ? 0 : a.y > a.z ? 1 : 2;
  return static_cast<std::size_t>(2 * axis + (p[axis] > 0. ? 1 : 0));
}

// Which of `count` equal parts of a circle an angle is in.
std::size_t Sector(double angle, int count)
{
  const double share = angle / glm::two_pi<double>() + 0.5;
  return static_cast<std::size_t>(std::clamp(static_cast<int>(share * count), 0, count - 1));
}

// The squares of the counts' deviations, in variances, over their number less one: 1 as a rule.
void Check(const std::string& what, vtkPolyData* mesh, const glm::dmat3& turn,
  const std::vector<double>& areas, const Part& part)
{
  const int count = 60000;
  double whole = 0.;
  for (const double area : areas)
  {
    whole += area;
  }
  for (const int seed : { 0, 1 })
  {
    vtkNew<vtkRelievoSurfaceParticles> filter;
    filter->SetInputData(mesh);
    filter->SetNumberOfParticles(count);
    filter->SetResolution(64);
    filter->SetSeed(seed);
    const relievoTest::Places places = relievoTest::PlacesAt(filter, 0.);
    RELIEVO_CHECK(places.size() == static_cast<std::size_t>(count));
    std::vector<double> found(areas.size(), 0.);
    for (const glm::dvec3& place : places)
    {
      found[part(glm::transpose(turn) * place)] += 1.;
    }
    double square = 0.;
    for (std::size_t i = 0; i < areas.size(); ++i)
    {
      const double expected = count * areas[i] / whole;
      square += (found[i] - expected) * (found[i] - expected) / expected;
    }
    const double freedom = static_cast<double>(areas.size()) - 1.;
    std::cout << what << ": chi square " << square << " of " << freedom << "\n";
    // Once in ten thousand by chance (Wilson and Hilferty).
    const double limit =
      freedom * std::pow(1. - 2. / (9. * freedom) + 3.719 * std::sqrt(2. / (9. * freedom)), 3.);
    RELIEVO_CHECK_AT_MOST(square, limit, what + ", chi square");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSurfaceParticlesEven)
{
  relievoTest::Session session;
  for (const glm::dmat3& turn : Turns)
  {
    Check("cube", Cube(turn), turn, std::vector<double>(6, 1.), FaceOf);
    std::vector<glm::dvec2> arc;
    for (int i = 0; i <= 90; ++i)
    {
      const double angle = glm::pi<double>() * i / 90.;
      arc.emplace_back(std::sin(angle), -std::cos(angle));
    }
    const auto sphere = relievoTest::Lathe(arc, false, 180, turn);
    // Zones of equal heights have equal areas.
    Check("sphere", sphere, turn, std::vector<double>(32, 1.), [](const glm::dvec3& p) {
      const double height = std::clamp(p.z / glm::length(p), -0.9999, 0.9999);
      return 8 * static_cast<std::size_t>((height + 1.) * 2.) + Sector(std::atan2(p.y, p.x), 8);
    });
  }
  // Turned so that the six views see all of its hole.
  std::vector<glm::dvec2> circle;
  for (int i = 0; i < 90; ++i)
  {
    const double angle = glm::two_pi<double>() * i / 90.;
    circle.emplace_back(1. + 0.4 * std::cos(angle), 0.4 * std::sin(angle));
  }
  std::vector<double> areas;
  for (int i = 0; i < 64; ++i)
  {
    const double from = glm::two_pi<double>() * (i % 8) / 8. - glm::pi<double>();
    const double to = from + glm::two_pi<double>() / 8.;
    areas.push_back(to - from + 0.4 * (std::sin(to) - std::sin(from)));
  }
  const glm::dmat3& turn = Turns[2];
  Check("torus", relievoTest::Lathe(circle, true, 180, turn), turn, areas, [](const glm::dvec3& p) {
    return 8 * Sector(std::atan2(p.y, p.x), 8) +
      Sector(std::atan2(p.z, std::hypot(p.x, p.y) - 1.), 8);
  });
  return session.Result();
}
}
