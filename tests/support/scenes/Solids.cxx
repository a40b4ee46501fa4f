// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids.h"

#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{
using relievoTest::Lathe;
using Profile = std::vector<glm::dvec2>;

const double Pi = vtkMath::Pi();

// Steps of a full turn whose radius error is at most half the chord.
int StepsOf(double radius, double chord)
{
  return std::max(8, static_cast<int>(std::ceil(Pi / std::acos(1. - chord / 2. / radius))));
}

// Includes both ends; angles from +r towards +z.
void AddArc(Profile& profile, const glm::dvec2& middle, double radius, double from, double to,
  double chord, bool first = true)
{
  const int steps = std::max(
    2, static_cast<int>(std::ceil(StepsOf(radius, chord) * std::abs(to - from) / 2. / Pi)));
  for (int i = first ? 0 : 1; i <= steps; ++i)
  {
    const double angle = from + (to - from) * i / steps;
    profile.push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
}

// Moves ends on the axis exactly onto it.
void SnapEnds(Profile& profile)
{
  profile.front().x = 0.;
  profile.back().x = 0.;
}

vtkSmartPointer<vtkPolyData> Append(vtkPolyData* a, vtkPolyData* b)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (vtkPolyData* mesh : { a, b })
  {
    const vtkIdType offset = points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(mesh->GetPoint(i));
    }
    cells->Append(mesh->GetPolys(), offset);
  }
  auto both = vtkSmartPointer<vtkPolyData>::New();
  both->SetPoints(points);
  both->SetPolys(cells);
  return both;
}
}

//------------------------------------------------------------------------------
glm::dmat3 relievoTest::Turn(const glm::dvec3& axis, double degrees)
{
  return glm::dmat3(glm::rotate(glm::dmat4(1.), degrees * Pi / 180., glm::normalize(axis)));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> relievoTest::Lathe(
  const std::vector<glm::dvec2>& profile, bool closed, int steps, const glm::dmat3& rotation)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<vtkIdType> first;
  for (const glm::dvec2& place : profile)
  {
    first.push_back(points->GetNumberOfPoints());
    for (int s = 0; s < (place.x == 0. ? 1 : steps); ++s)
    {
      const double angle = 2. * Pi * s / steps;
      const glm::dvec3 at =
        rotation * glm::dvec3(place.x * std::cos(angle), place.x * std::sin(angle), place.y);
      points->InsertNextPoint(at.x, at.y, at.z);
    }
  }
  vtkNew<vtkCellArray> cells;
  const std::size_t count = profile.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i)
  {
    const std::size_t next = (i + 1) % count;
    const auto at = [&](std::size_t ring, int s) {
      return first[ring] + (profile[ring].x == 0. ? 0 : s % steps);
    };
    for (int s = 0; s < steps; ++s)
    {
      if (profile[i].x != 0.)
      {
        cells->InsertNextCell({ at(i, s), at(i, s + 1), at(next, s) });
      }
      if (profile[next].x != 0.)
      {
        cells->InsertNextCell({ at(i, s + 1), at(next, s + 1), at(next, s) });
      }
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

//------------------------------------------------------------------------------
relievoTest::Solid relievoTest::MakeBall(double chord, const glm::dmat3& rotation)
{
  Profile profile;
  AddArc(profile, { 0., 0. }, 1., -Pi / 2., Pi / 2., chord);
  SnapEnds(profile);
  return { "ball", Lathe(profile, false, StepsOf(1., chord), rotation),
    [](const glm::dvec3& p) { return glm::length(p) - 1.; }, 4. / 3. * Pi, chord };
}

//------------------------------------------------------------------------------
relievoTest::Solid relievoTest::MakeTorus(double chord, const glm::dmat3& rotation)
{
  Profile profile;
  AddArc(profile, { 1., 0. }, 0.4, -Pi, Pi, chord);
  profile.pop_back();
  const glm::dmat3 back = glm::transpose(rotation);
  return { "torus", Lathe(profile, true, StepsOf(1.4, chord), rotation),
    [back](const glm::dvec3& world) {
      const glm::dvec3 p = back * world;
      return std::hypot(std::hypot(p.x, p.y) - 1., p.z) - 0.4;
    },
    2. * Pi * Pi * 0.16, chord };
}

//------------------------------------------------------------------------------
relievoTest::Solid relievoTest::MakeHollowBall(double chord, const glm::dmat3& rotation)
{
  Profile outside;
  Profile inside;
  AddArc(outside, { 0., 0. }, 1., -Pi / 2., Pi / 2., chord);
  AddArc(inside, { 0., 0. }, 0.5, Pi / 2., -Pi / 2., chord);
  SnapEnds(outside);
  SnapEnds(inside);
  const int steps = StepsOf(1., chord);
  return { "hollow ball",
    Append(Lathe(outside, false, steps, rotation), Lathe(inside, false, steps, rotation)),
    [](const glm::dvec3& p) {
      const double r = glm::length(p);
      return std::max(r - 1., 0.5 - r);
    },
    4. / 3. * Pi * 0.875, chord };
}

//------------------------------------------------------------------------------
relievoTest::Solid relievoTest::MakeBowl(double chord, const glm::dmat3& rotation)
{
  Profile profile;
  AddArc(profile, { 0., 0. }, 1., -Pi / 2., 0., chord);
  AddArc(profile, { 0., 0. }, 0.8, 0., -Pi / 2., chord);
  SnapEnds(profile);
  const glm::dmat3 back = glm::transpose(rotation);
  return { "bowl", Lathe(profile, false, StepsOf(1., chord), rotation),
    [back](const glm::dvec3& world) {
      const glm::dvec3 p = back * world;
      const double r = glm::length(p);
      return std::max({ r - 1., 0.8 - r, p.z });
    },
    2. / 3. * Pi * (1. - 0.512), chord };
}

//------------------------------------------------------------------------------
relievoTest::Solid relievoTest::MakeBox(const glm::dmat3& rotation)
{
  const glm::dvec3 half(0.9, 0.6, 0.4);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 at =
      rotation * (half * glm::dvec3(i & 1 ? 1. : -1., i & 2 ? 1. : -1., i & 4 ? 1. : -1.));
    points->InsertNextPoint(at.x, at.y, at.z);
  }
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 2, 3, 1 });
  cells->InsertNextCell({ 4, 5, 7, 6 });
  cells->InsertNextCell({ 0, 1, 5, 4 });
  cells->InsertNextCell({ 2, 6, 7, 3 });
  cells->InsertNextCell({ 0, 4, 6, 2 });
  cells->InsertNextCell({ 1, 3, 7, 5 });
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  const glm::dmat3 back = glm::transpose(rotation);
  return { "box", mesh,
    [back, half](const glm::dvec3& world) {
      const glm::dvec3 beyond = glm::abs(back * world) - half;
      return std::max({ beyond.x, beyond.y, beyond.z });
    },
    8. * 0.9 * 0.6 * 0.4, 0. };
}
