// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Difficult cases of particles: ends of the visible surface, steps of depth, sheets, non-finite
// fields, empty surfaces, depth images, given points, far from the origin, too much memory.
#include "Check.h"
#include "Particles.h"
#include "Refusal.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "vtkRelievoSurfaceParticles.h"

#include <vtkAppendPolyData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace testSurfaceParticlesLimits
{
namespace
{
using relievoTest::LargestDistance;
using relievoTest::Places;
using relievoTest::PlacesAt;
using Particles = vtkRelievoSurfaceParticles;
constexpr double Infinity = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, const glm::dvec3& by, double scale = 1.)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 place;
    mesh->GetPoint(i, &place.x);
    place = scale * place + by;
    points->InsertNextPoint(&place.x);
  }
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(mesh);
  moved->SetPoints(points);
  return moved;
}

void SetUp(Particles* filter, vtkPolyData* mesh, int count = 400)
{
  filter->SetInputData(mesh);
  filter->SetNumberOfParticles(count);
  filter->SetResolution(80);
}

// No step is longer than the way and a texel and a half: a small box hovers over a large one, so
// that a view sees a step of depth, and particles move across it.
void TestSteps()
{
  const relievoTest::Solid box = relievoTest::MakeBox();
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(box.Mesh);
  both->AddInputData(Moved(box.Mesh, { 0.1, 0., 0.9 }, 0.5));
  both->Update();
  for (const glm::dvec3& velocity :
    { glm::dvec3(1., 0.2, 0.), glm::dvec3(0.1, 0.9, 0.3), glm::dvec3(0., 0.3, -1.) })
  {
    vtkNew<Particles> filter;
    SetUp(filter, both->GetOutput());
    filter->Update();
    const double texel = filter->GetUsedTexelSize();
    filter->SetVelocity(
      0.8 * texel * velocity.x, 0.8 * texel * velocity.y, 0.8 * texel * velocity.z);
    Places before = PlacesAt(filter, 0.);
    double longest = 0.;
    double away = 0.;
    for (int step = 1; step <= 100; ++step)
    {
      const Places places = PlacesAt(filter, step);
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        longest = std::max(longest, glm::distance(before[i], places[i]) / texel);
      }
      before = places;
      away = std::max(away, LargestDistance(places, both->GetOutput()) / texel);
    }
    RELIEVO_CHECK(before.size() == 400);
    // Two parts of a step, each of half a texel and 1.5 texels to go over.
    RELIEVO_CHECK_AT_MOST(longest, 4., "longest step, texels");
    RELIEVO_CHECK_AT_MOST(away, 1., "from the surface, texels");
  }
}

// On a sheet a particle stays on its side, and at its edge where it is.
void TestSheet()
{
  const auto sheet = relievoTest::Sheet();
  vtkNew<Particles> filter;
  SetUp(filter, sheet);
  filter->SetVelocity(0.05, 0.01, 0.);
  const auto sides = [&](double time) {
    const Places places = PlacesAt(filter, time);
    RELIEVO_CHECK(places.size() == 400);
    RELIEVO_CHECK_AT_MOST(LargestDistance(places, sheet), 1e-9, "from the sheet");
    auto* normals =
      vtkFloatArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetArray("normal"));
    std::vector<float> z;
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
    {
      z.push_back(normals->GetTypedComponent(i, 2));
    }
    return z;
  };
  RELIEVO_CHECK(sides(0.) == sides(100.));
  double least = 1.;
  for (const glm::dvec3& place : PlacesAt(filter, 100.))
  {
    least = std::min(least, place.x);
  }
  RELIEVO_CHECK_THAT(least > 0.97, "at the edge: " + std::to_string(least));
}

void TestFieldsNotFinite()
{
  const relievoTest::Solid ball = relievoTest::MakeBall();
  const auto mesh = relievoTest::WithField(ball.Mesh, [](const glm::dvec3& place) {
    return place.x > 0. ? glm::dvec3(NAN, 0., 0.)
      : place.y > 0.    ? glm::dvec3(0., Infinity, 0.)
                        : glm::dvec3(1e300, 1e300, 0.);
  });
  for (const int place : { Particles::ON_SURFACE, Particles::INSIDE })
  {
    vtkNew<Particles> filter;
    SetUp(filter, mesh, 40);
    filter->SetPlace(place);
    filter->SetFieldArray("field");
    filter->SetNumberOfSteps(1);
    const Places start = PlacesAt(filter, 0.);
    const Places end = PlacesAt(filter, 1.);
    RELIEVO_CHECK(end.size() == 40);
    double outside = 0.;
    for (std::size_t i = 0; i < end.size(); ++i)
    {
      const double radius = glm::length(end[i]);
      outside = std::max(outside, place == Particles::INSIDE ? radius - 1. : std::abs(radius - 1.));
      RELIEVO_CHECK_THAT(start[i].x < 0.1 || start[i] == end[i], "moved by NaN");
    }
    RELIEVO_CHECK_AT_MOST(outside / filter->GetUsedTexelSize(), 1., "fast and NaN, texels");
  }
}

void TestNothing()
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkPolyData> point;
  vtkNew<vtkPoints> one;
  one->InsertNextPoint(1., 2., 3.);
  point->SetPoints(one);
  auto line = relievoTest::Sheet(1); // triangles without area
  line->GetPoints()->SetPoint(2, 0., 1., 0.);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    line->GetPoints()->SetPoint(i, static_cast<double>(i), 0., 0.);
  }
  auto lost = relievoTest::Sheet(1);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    lost->GetPoints()->SetPoint(i, NAN, 0., 0.);
  }
  for (vtkPolyData* mesh : { empty.Get(), point.Get(), line.Get(), lost.Get() })
  {
    for (const int place : { Particles::ON_SURFACE, Particles::INSIDE })
    {
      vtkNew<Particles> filter;
      SetUp(filter, mesh);
      filter->SetPlace(place);
      filter->SetVelocity(1., 0., 0.);
      RELIEVO_CHECK(PlacesAt(filter, 5.).empty());
    }
  }
  vtkNew<Particles> none;
  SetUp(none, relievoTest::Sheet(), 0);
  RELIEVO_CHECK(PlacesAt(none, 5.).empty());
}

void TestRefused()
{
  vtkNew<Particles> filter;
  relievoTest::CheckRefused(filter.Get(), "No particles: there is no input; give a surface");
  SetUp(filter, relievoTest::Sheet());
  filter->SetFieldArray("no such");
  relievoTest::CheckRefused(
    filter.Get(), "No particles: the field has no array 'no such' of vectors");
  filter->SetFieldArray("");
  filter->SetMemoryLimit(1000.);
  relievoTest::CheckRefused(filter.Get(), "No particles: for 400 of them it would take");
  filter->SetMemoryLimit(0.);
  filter->SetTexelSize(1e-12);
  relievoTest::CheckRefused(filter.Get(), "No particles: 2e+12 x 2e+12 x ");
  filter->SetTexelSize(0.);
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  filter->SetInputDataObject(1, image);
  relievoTest::CheckRefused(filter.Get(), "No particles: depth image 0: it has no layer 'depth'");
  filter->SetInputConnection(1, nullptr);
  RELIEVO_CHECK(PlacesAt(filter, 0.).size() == 400);
}

// Given points come to the nearest place, with their data.
void TestPoints()
{
  const relievoTest::Solid ball = relievoTest::MakeBall(1e-4);
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> data;
  data->SetName("mine");
  Places wanted;
  for (int i = 0; i < 100; ++i)
  {
    const glm::dvec3 direction =
      glm::normalize(glm::dvec3(std::cos(i * 2.4), std::sin(i * 2.4), (i - 49.5) / 30.));
    const glm::dvec3 place = direction * (0.6 + 0.01 * i);
    points->InsertNextPoint(&place.x);
    data->InsertNextValue(i);
    wanted.push_back(direction);
  }
  points->InsertNextPoint(NAN, 0., 0.);
  data->InsertNextValue(100.);
  vtkNew<vtkPolyData> given;
  given->SetPoints(points);
  given->GetPointData()->AddArray(data);
  vtkNew<Particles> filter;
  SetUp(filter, ball.Mesh);
  filter->SetInputData(2, given);
  const Places places = PlacesAt(filter, 0.);
  RELIEVO_CHECK(places.size() == 101);
  double farthest = 0.;
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    farthest = std::max(farthest, glm::distance(places[i], wanted[i]));
  }
  RELIEVO_CHECK_AT_MOST(farthest / filter->GetUsedTexelSize(), 1.5, "given points, texels");
  vtkDataArray* along = filter->GetOutput()->GetPointData()->GetArray("mine");
  RELIEVO_CHECK(along && along->GetNumberOfTuples() == 101 && along->GetTuple1(42) == 42.);
}

// A depth image of a slope that looks along (-1, 0, -1): particles are within its rectangle.
void TestImage()
{
  constexpr int Size = 32;
  constexpr double Texel = 2. / Size;
  const double s = std::sqrt(0.5);
  const double camera[16] = { 0., 1., 0., 0., -s, 0., s, 0., s, 0., s, -3., 0., 0., 0., 1. };
  const double toNdc[16] = { 0., 1., 0., 0., -s, 0., s, 0., -s / 5., 0., -s / 5., 0., 0., 0., 0.,
    1. };
  vtkNew<vtkImageData> image;
  image->SetDimensions(Size, Size, 1);
  vtkNew<vtkFloatArray> depth;
  depth->SetName("depth");
  for (int j = 0; j < Size; ++j)
  {
    for (int i = 0; i < Size; ++i)
    {
      // The place of x and y of the camera's on a plane with a slope of a third; a hole.
      const double y = (j + 0.5) * Texel - 1.;
      depth->InsertNextValue(
        static_cast<float>(i > 10 && i < 16 && j > 10 && j < 16 ? Infinity : 3. + y / 3.));
    }
  }
  image->GetPointData()->AddArray(depth);
  for (const auto& [name, matrix] :
    { std::pair<const char*, const double*>("worldToCamera", camera),
      std::pair<const char*, const double*>("worldToNDC", toNdc) })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(16);
    array->InsertNextTuple(matrix);
    image->GetFieldData()->AddArray(array);
  }
  vtkNew<Particles> filter;
  filter->SetInputDataObject(1, image);
  filter->SetNumberOfParticles(500);
  filter->SetNoiseSpeed(0.05);
  filter->SetVelocity(0., 0.02, 0.);
  const Places places = PlacesAt(filter, 60.);
  RELIEVO_CHECK(places.size() == 500);
  RELIEVO_CHECK_NEAR(filter->GetUsedTexelSize(), Texel, 1e-12, "texel");
  double away = 0.;
  double inHole = 0.;
  for (const glm::dvec3& place : places)
  {
    const double x = place.y;
    const double y = s * (place.z - place.x);
    const double z = 3. - s * (place.x + place.z); // depth
    away =
      std::max({ away, std::abs(z - 3. - y / 3.) / Texel, std::abs(x) - 1., std::abs(y) - 1. });
    const double i = (x + 1.) / Texel;
    const double j = (y + 1.) / Texel;
    inHole += i > 11.01 && i < 15.99 && j > 11.01 && j < 15.99 ? 1. : 0.;
  }
  // At the ends of the visible surface, the depth half a texel inwards counts.
  RELIEVO_CHECK_AT_MOST(away, 0.5 / 3. + 1e-4, "from the slope, texels");
  RELIEVO_CHECK_AT_MOST(inHole, 0., "particles in the hole");
}

void TestFarAway()
{
  const relievoTest::Solid ball = relievoTest::MakeBall();
  const auto mesh = Moved(ball.Mesh, { 1e7, -1e7, 3e6 }, 0.1);
  vtkNew<Particles> filter;
  SetUp(filter, mesh);
  filter->SetNoiseSpeed(0.002);
  const Places places = PlacesAt(filter, 100.);
  RELIEVO_CHECK(places.size() == 400);
  RELIEVO_CHECK_AT_MOST(
    LargestDistance(places, mesh) / filter->GetUsedTexelSize(), 1., "far away, texels");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSurfaceParticlesLimits)
{
  relievoTest::Session session;
  TestSteps();
  TestSheet();
  TestFieldsNotFinite();
  TestNothing();
  TestRefused();
  TestPoints();
  TestImage();
  TestFarAway();
  return session.Result();
}
}
