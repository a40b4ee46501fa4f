// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Starting positions: evenly in thin bodies, equal in all pieces and threads; data of given points;
// and memory already held.
#include "Check.h"
#include "Particles.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "vtkRelievoSurfaceParticles.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace testSurfaceParticlesStart
{
namespace
{
using relievoTest::Places;
using relievoTest::PlacesAt;
using Particles = vtkRelievoSurfaceParticles;

const glm::dmat3 Tilt = relievoTest::Turn({ 1., 0.4, 0. }, 45.);

// A tilted ring of radius 1 that is 0.1 thick: about a hundredth of its box.
vtkSmartPointer<vtkPolyData> Ring()
{
  std::vector<glm::dvec2> profile;
  for (int i = 0; i < 24; ++i)
  {
    const double angle = i * glm::two_pi<double>() / 24.;
    profile.emplace_back(1. + 0.05 * std::cos(angle), 0.05 * std::sin(angle));
  }
  return relievoTest::Lathe(profile, true, 200, Tilt);
}

void TestThin()
{
  const auto ring = Ring();
  vtkNew<Particles> filter;
  filter->SetInputData(ring);
  filter->SetPlace(Particles::INSIDE);
  filter->SetNumberOfParticles(4000);
  filter->SetResolution(500);
  const Places places = PlacesAt(filter, 0.);
  RELIEVO_CHECK(places.size() == 4000);
  vtkCellArray* vertices = filter->GetOutput()->GetVerts();
  RELIEVO_CHECK(vertices->GetNumberOfCells() == 4000); // one for each particle
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < vertices->GetNumberOfCells(); ++i)
  {
    vertices->GetCellAtId(i, points);
    RELIEVO_CHECK(points->GetNumberOfIds() == 1 && points->GetId(0) == i);
  }
  double squares = 0.;
  double farthest = 0.;
  int counts[8] = {};
  for (const glm::dvec3& place : places)
  {
    const glm::dvec3 own = glm::transpose(Tilt) * place;
    const double radius = std::hypot(std::hypot(own.x, own.y) - 1., own.z) / 0.05;
    squares += radius * radius / 4000.;
    farthest = std::max(farthest, radius);
    const double turn = std::atan2(own.y, own.x) / glm::two_pi<double>() + 0.5;
    ++counts[std::clamp(static_cast<int>(8. * turn), 0, 7)];
  }
  // Even over a disc, the mean of squared radii is a half; texels are a twelfth of the ring's.
  RELIEVO_CHECK_NEAR(squares, 0.5, 0.04, "mean of squared radii in a ring");
  RELIEVO_CHECK_AT_MOST(farthest, 1.1, "largest radius in a ring");
  for (const int count : counts)
  {
    RELIEVO_CHECK_NEAR(count, 500., 90., "particles in an eighth of a ring");
  }
  // Particles start in the same places by any number of threads, in one piece or three.
  vtkSMPTools::Initialize(1);
  vtkNew<Particles> alone;
  alone->SetInputData(ring);
  alone->SetPlace(Particles::INSIDE);
  alone->SetNumberOfParticles(4000);
  alone->SetResolution(500);
  std::size_t at = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    alone->UpdatePiece(piece, 3, 0);
    for (vtkIdType i = 0; i < alone->GetOutput()->GetNumberOfPoints(); ++i, ++at)
    {
      glm::dvec3 place;
      alone->GetOutput()->GetPoint(i, &place.x);
      RELIEVO_CHECK(at < 4000 && place == places[at]);
    }
  }
  RELIEVO_CHECK(at == 4000);
  vtkSMPTools::Initialize(0);
}

// Arrays of the starting points whose names are the particles' own are left out, in so many words.
void TestNames()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0., 0., 1.);
  points->InsertNextPoint(0., 1., 0.);
  vtkNew<vtkPolyData> given;
  given->SetPoints(points);
  for (const char* name : { "mine", "particle", "velocity", "normal", "orientation" })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfValues(2);
    array->FillValue(7.);
    given->GetPointData()->AddArray(array);
  }
  vtkNew<Particles> filter;
  filter->SetInputData(relievoTest::MakeBall().Mesh);
  filter->SetInputData(2, given);
  filter->SetResolution(50);
  {
    relievoTest::ExpectMessage expect(
      "point data 'particle', 'velocity', 'normal' of the starting points are left out");
    PlacesAt(filter, 0.);
    PlacesAt(filter, 1.);
    RELIEVO_CHECK(expect.Count() == 1); // not at each time
  }
  vtkPointData* data = filter->GetOutput()->GetPointData();
  RELIEVO_CHECK(data->GetArray("mine")->GetTuple1(1) == 7.);
  RELIEVO_CHECK(data->GetArray("orientation")->GetTuple1(1) == 7.);
  RELIEVO_CHECK(data->GetArray("particle")->GetTuple1(1) == 1.);
  RELIEVO_CHECK(data->GetArray("velocity")->GetNumberOfComponents() == 3);
  filter->OrientationsOn();
  filter->SetPlace(Particles::INSIDE);
  {
    relievoTest::ExpectMessage expect("point data 'particle', 'velocity' of the starting points");
    PlacesAt(filter, 0.);
    RELIEVO_CHECK(expect.Count() == 1);
  }
  RELIEVO_CHECK(filter->GetOutput()->GetPointData()->GetArray("normal")->GetTuple1(0) == 7.);
}

#ifdef __linux__
// A memory figure of this process, in bytes: VmRSS or VmData.
double BytesOf(const std::string& what)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    double kib = 0.;
    if (word == what + ":" && status >> kib)
    {
      return 1024. * kib;
    }
  }
  return 0.;
}

// Memory that the filter already holds is not required again: with less free memory than a start
// would need, it still continues.
void TestHeldMemory()
{
  constexpr double Count = 1e6;
  constexpr double Needed = Count * (4. * 25. + 90.);
  vtkNew<Particles> filter;
  filter->SetInputData(relievoTest::Sheet());
  filter->SetNumberOfParticles(static_cast<vtkIdType>(Count));
  filter->SetResolution(64);
  filter->SetCheckpoints(0);
  filter->SetVelocity(0.01, 0., 0.);
  RELIEVO_CHECK(PlacesAt(filter, 1.).size() == 1000000);
  rlimit before;
  getrlimit(RLIMIT_DATA, &before);
  // The last output is given back first: 72 bytes a particle.
  const double left = 0.8 * Needed - 72. * Count;
  if (BytesOf("VmData") - BytesOf("VmRSS") > 0.5 * left)
  {
    std::printf("not tried: this process has much memory that it does not use\n");
    return;
  }
  rlimit less = before;
  less.rlim_cur = static_cast<rlim_t>(BytesOf("VmRSS") + left);
  setrlimit(RLIMIT_DATA, &less);
  filter->UpdateTimeStep(2.);
  const vtkIdType kept = filter->GetOutput()->GetNumberOfPoints();
  // More of them are still too many.
  filter->SetNumberOfParticles(static_cast<vtkIdType>(4. * Count));
  {
    relievoTest::ExpectMessage expect("for 4000000 of them it would take");
    filter->UpdateTimeStep(2.);
    RELIEVO_CHECK(expect.Count() == 1);
  }
  setrlimit(RLIMIT_DATA, &before);
  RELIEVO_CHECK(kept == 1000000);
}
#endif
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE_APART(testSurfaceParticlesStart)
{
  relievoTest::Session session;
  TestThin();
  TestNames();
#ifdef __linux__
  TestHeldMemory();
#endif
  return session.Result();
}
}
