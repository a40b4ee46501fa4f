// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Particles are a function of the time, bit for bit, independent of earlier requests and of the
// number of checkpoints, threads and pieces; changed inputs and settings restart them.
#include "Check.h"
#include "Particles.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "vtkRelievoSurfaceParticles.h"

#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace testSurfaceParticlesTime
{
namespace
{
using relievoTest::Places;
using relievoTest::PlacesAt;
using Particles = vtkRelievoSurfaceParticles;
using SDDP = vtkStreamingDemandDrivenPipeline;

void SetUp(Particles* filter, vtkPolyData* mesh, int place)
{
  filter->SetInputData(mesh);
  filter->SetPlace(place);
  filter->SetNumberOfParticles(500);
  filter->SetResolution(64);
  filter->SetNoiseSpeed(0.1);
  filter->SetVelocity(0.02, 0., -0.01);
  filter->SetStartTime(-2.);
  filter->SetTimeStep(0.25);
  filter->SetNumberOfSteps(60);
}

void TestTimes(vtkPolyData* mesh, int place)
{
  const std::vector<double> times = { -2., 10., -1.5, 3., 2.9, 12., 2.9, 13., 99., -50. };
  std::vector<Places> fresh;
  for (const double time : times)
  {
    vtkNew<Particles> filter;
    SetUp(filter, mesh, place);
    filter->SetCheckpoints(0);
    fresh.push_back(PlacesAt(filter, time));
  }
  for (const int checkpoints : { 0, 1, 7, 100 })
  {
    vtkNew<Particles> filter;
    SetUp(filter, mesh, place);
    filter->SetCheckpoints(checkpoints);
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      RELIEVO_CHECK_THAT(PlacesAt(filter, times[i]) == fresh[i],
        "time " + std::to_string(times[i]) + ", " + std::to_string(checkpoints) + " checkpoints");
    }
  }
  RELIEVO_CHECK(fresh[3] != fresh[4] && fresh[0] != fresh[1]);
  RELIEVO_CHECK(fresh[7] == fresh[8] && fresh[0] == fresh[9]); // beyond the last and the first
  // Between two steps.
  vtkNew<Particles> filter;
  SetUp(filter, mesh, place);
  const Places before = PlacesAt(filter, 2.75);
  // Nearly: some go over to another map, and inside a third is at walls (0.63 to 0.73 of them are
  // even, by the seed).
  double even = 0.;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    const double step = glm::distance(before[i], fresh[3][i]);
    even += std::abs(glm::distance(before[i], fresh[4][i]) - 0.6 * step) < 0.1 * step ? 1. : 0.;
  }
  RELIEVO_CHECK_THAT(even > 0.6 * 500, "a part of a step: " + std::to_string(even));
}

void TestTimeSteps(vtkPolyData* mesh)
{
  vtkNew<Particles> filter;
  SetUp(filter, mesh, Particles::ON_SURFACE);
  filter->UpdateInformation();
  vtkInformation* info = filter->GetOutputInformation(0);
  RELIEVO_CHECK(info->Length(SDDP::TIME_STEPS()) == 61);
  RELIEVO_CHECK(info->Get(SDDP::TIME_STEPS())[60] == 13.);
  RELIEVO_CHECK(info->Get(SDDP::TIME_RANGE())[0] == -2. && info->Get(SDDP::TIME_RANGE())[1] == 13.);
  const Places start = PlacesAt(filter, -2.);
  filter->Update();
  filter->UpdateTimeStep(4.);
  RELIEVO_CHECK(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()) == 4.);
}

void TestThreadsAndPieces(vtkPolyData* mesh, int place)
{
  vtkNew<Particles> filter;
  SetUp(filter, mesh, place);
  const Places whole = PlacesAt(filter, 8.);
  for (const int threads : { 1, 2, 7 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<Particles> other;
    SetUp(other, mesh, place);
    RELIEVO_CHECK_THAT(PlacesAt(other, 8.) == whole, std::to_string(threads) + " threads");
  }
  vtkSMPTools::Initialize(0);
  for (const int pieces : { 2, 7 })
  {
    Places together;
    vtkNew<Particles> other;
    SetUp(other, mesh, place);
    other->UpdateInformation();
    for (int piece = 0; piece < pieces; ++piece)
    {
      vtkInformation* info = other->GetOutputInformation(0);
      info->Set(SDDP::UPDATE_PIECE_NUMBER(), piece);
      info->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), pieces);
      info->Set(SDDP::UPDATE_TIME_STEP(), 8.);
      other->Update();
      vtkPolyData* output = other->GetOutput();
      auto* numbers = vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetArray("particle"));
      RELIEVO_CHECK(numbers->GetValue(0) == static_cast<vtkIdType>(together.size()));
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        output->GetPoint(i, &together.emplace_back().x);
      }
    }
    RELIEVO_CHECK_THAT(together == whole, std::to_string(pieces) + " pieces");
  }
}

void TestChanges(vtkPolyData* mesh)
{
  vtkNew<Particles> filter;
  SetUp(filter, mesh, Particles::ON_SURFACE);
  const Places first = PlacesAt(filter, 5.);
  filter->SetSeed(3);
  RELIEVO_CHECK(PlacesAt(filter, 5.) != first);
  filter->SetSeed(0);
  RELIEVO_CHECK(PlacesAt(filter, 5.) == first);
  const relievoTest::Solid box = relievoTest::MakeBox();
  filter->SetInputData(box.Mesh);
  const Places on = PlacesAt(filter, 5.);
  RELIEVO_CHECK_AT_MOST(
    relievoTest::LargestDistance(on, box.Mesh) / filter->GetUsedTexelSize(), 1., "another body");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSurfaceParticlesTime)
{
  relievoTest::Session session;
  {
    const relievoTest::Solid torus =
      relievoTest::MakeTorus(2e-3, relievoTest::Turn({ 1., 0.3, 0.2 }, 37.));
    for (const int place : { Particles::ON_SURFACE, Particles::INSIDE })
    {
      TestTimes(torus.Mesh, place);
      TestThreadsAndPieces(torus.Mesh, place);
    }
    TestTimeSteps(torus.Mesh);
    TestChanges(torus.Mesh);
  }
  return session.Result();
}
}
