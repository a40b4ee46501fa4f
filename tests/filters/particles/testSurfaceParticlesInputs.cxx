// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fields and inputs: arrays whose speed jumps, arrays in blocks and by several threads, an end
// before the end.
#include "Check.h"
#include "Particles.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "vtkRelievoSurfaceParticles.h"

#include <vtkAppendPolyData.h>
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace testSurfaceParticlesInputs
{
namespace
{
using relievoTest::Moved;
using relievoTest::Places;
using relievoTest::PlacesAt;
using Particles = vtkRelievoSurfaceParticles;

void SetUp(Particles* filter, vtkDataObject* surface, int place, int count = 400)
{
  filter->SetInputDataObject(surface);
  filter->SetPlace(place);
  filter->SetNumberOfParticles(count);
  filter->SetResolution(80);
}

// Two boxes, 0.2 apart. Before the gap, from one cell of the field to the next, particles are 200
// times as fast: none may get to the other box.
void TestSpeedJumps()
{
  const relievoTest::Solid box = relievoTest::MakeBox();
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(Moved(box.Mesh, { -1., 0., 0. }));
  both->AddInputData(Moved(box.Mesh, { 1., 0., 0. }));
  both->Update();
  constexpr double Texel = 3.8 / 80.;
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(81, 2, 2);
  grid->SetSpacing(Texel, 4., 4.);
  grid->SetOrigin(-1.9, -2., -2.);
  vtkNew<vtkDoubleArray> field;
  field->SetName("field");
  field->SetNumberOfComponents(3);
  for (int cell = 0; cell < 80; ++cell)
  {
    const double end = -1.9 + (cell + 1) * Texel;
    field->InsertNextTuple3((end > -0.15 && end < 0.15 ? 100. : 0.5) * Texel, 0., 0.);
  }
  grid->GetCellData()->AddArray(field);
  for (const int place : { Particles::ON_SURFACE, Particles::INSIDE })
  {
    vtkNew<Particles> filter;
    SetUp(filter, both->GetOutput(), place);
    filter->SetInputDataObject(3, grid);
    filter->SetFieldArray("field");
    filter->SetNumberOfSteps(40);
    const Places start = PlacesAt(filter, 0.);
    const Places end = PlacesAt(filter, 40.);
    double gone = 0.;
    double moved = 0.;
    for (std::size_t i = 0; i < start.size(); ++i)
    {
      gone += start[i].x < 0. && end[i].x > 0. ? 1. : 0.;
      moved += end[i].x > start[i].x + Texel ? 1. : 0.;
    }
    RELIEVO_CHECK(start.size() == 400 && moved > 200.);
    RELIEVO_CHECK_AT_MOST(gone, 0., "particles that jump, place " + std::to_string(place));
  }
}

// A field at the points of an image is interpolated: a uniform one moves all by equal steps.
void TestFieldAtPoints()
{
  const relievoTest::Solid box = relievoTest::MakeBox();
  vtkNew<vtkImageData> grid;
  grid->SetDimensions(9, 9, 9);
  grid->SetOrigin(-4., -4., -4.);
  vtkNew<vtkDoubleArray> field;
  field->SetName("field");
  field->SetNumberOfComponents(3);
  for (int i = 0; i < 9 * 9 * 9; ++i)
  {
    field->InsertNextTuple3(0.02, 0., 0.);
  }
  grid->GetPointData()->AddArray(field);
  vtkNew<Particles> filter;
  SetUp(filter, box.Mesh, Particles::INSIDE);
  filter->SetInputDataObject(3, grid);
  filter->SetFieldArray("field");
  const Places start = PlacesAt(filter, 0.);
  const Places end = PlacesAt(filter, 5.);
  int inner = 0;
  double error = 0.;
  for (std::size_t i = 0; i < start.size(); ++i)
  {
    if (start[i].x < 0.5) // others may reach the wall
    {
      ++inner;
      error = std::max(error, glm::distance(end[i], start[i] + glm::dvec3(0.1, 0., 0.)));
    }
  }
  RELIEVO_CHECK(inner > 100);
  RELIEVO_CHECK_AT_MOST(error, 1e-5, "error of places in a uniform field");
}

// Whirls that no coordinate can tell apart are none; the rest of the field still counts.
void TestNarrowestNoise()
{
  const relievoTest::Solid box = relievoTest::MakeBox();
  for (const int place : { Particles::ON_SURFACE, Particles::INSIDE })
  {
    Places ends[2];
    for (const double speed : { 0., 0.3 })
    {
      vtkNew<Particles> filter;
      SetUp(filter, box.Mesh, place);
      filter->SetVelocity(0.02, 0., 0.);
      filter->SetNoiseSpeed(speed);
      filter->SetNoiseScale(1e-320);
      ends[speed > 0. ? 1 : 0] = PlacesAt(filter, 5.);
    }
    RELIEVO_CHECK(ends[0] == ends[1]);
  }
}

// A field in blocks, of which some have nothing: as in one piece, and by any number of threads.
void TestBlocksAndThreads()
{
  const relievoTest::Solid ball = relievoTest::MakeBall();
  const auto around = [](const glm::dvec3& place) {
    return 0.05 * glm::cross(glm::dvec3(0.3, -0.5, 0.8), place);
  };
  const auto left = relievoTest::WithField(Moved(ball.Mesh, { -1.5, 0., 0. }), around);
  const auto right = relievoTest::WithField(Moved(ball.Mesh, { 1.5, 0., 0. }), around);
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(left);
  append->AddInputData(right);
  append->Update();
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, right);
  inner->SetBlock(1, vtkSmartPointer<vtkPolyData>::New());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, left);
  blocks->SetBlock(2, inner);
  {
    // Inside, the nearest place of the array jumps halfway between walls.
    const int place = Particles::ON_SURFACE;
    vtkNew<Particles> whole;
    SetUp(whole, append->GetOutput(), place);
    whole->SetFieldArray("field");
    const Places places = PlacesAt(whole, 20.);
    RELIEVO_CHECK(places != PlacesAt(whole, 0.) && places.size() == 400);
    for (const int threads : { 1, 2, 7 })
    {
      vtkSMPTools::Initialize(threads);
      vtkNew<Particles> filter;
      SetUp(filter, blocks, place);
      filter->SetFieldArray("field");
      const Places ends = PlacesAt(filter, 20.);
      double apart = ends.size() == places.size() ? 0. : 1.;
      for (std::size_t i = 0; i < std::min(ends.size(), places.size()); ++i)
      {
        apart = std::max(apart, glm::distance(ends[i], places[i]));
      }
      // VTK's locators of other boxes may find other cells of those that are nearly as near.
      RELIEVO_CHECK_AT_MOST(apart / filter->GetUsedTexelSize(), 0.01,
        "blocks, " + std::to_string(threads) + " threads, texels");
    }
    vtkSMPTools::Initialize(0);
  }
}

// An aborted output belongs to no time: the next update computes it without a request.
void TestAbort()
{
  const relievoTest::Solid ball = relievoTest::MakeBall();
  vtkNew<Particles> whole;
  SetUp(whole, ball.Mesh, Particles::ON_SURFACE);
  whole->SetNoiseSpeed(0.02);
  const Places truth = PlacesAt(whole, 50.);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  });
  for (const bool timed : { true, false })
  {
    vtkNew<Particles> filter;
    SetUp(filter, ball.Mesh, Particles::ON_SURFACE);
    filter->SetNoiseSpeed(0.02);
    RELIEVO_CHECK(PlacesAt(filter, 10.).size() == 400);
    const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, abort);
    filter->UpdateTimeStep(50.);
    vtkPolyData* output = filter->GetOutput();
    RELIEVO_CHECK(output->GetNumberOfPoints() == 0);
    RELIEVO_CHECK(!output->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()));
    filter->RemoveObserver(tag);
    filter->SetAbortExecute(0);
    if (timed)
    {
      RELIEVO_CHECK(PlacesAt(filter, 50.) == truth);
    }
    else
    {
      filter->Update();
      RELIEVO_CHECK(output->GetNumberOfPoints() == 400);
    }
  }
}

// Steps that there are not take no memory.
void TestMemoryOfSteps()
{
  vtkNew<Particles> filter;
  SetUp(filter, relievoTest::MakeBall().Mesh, Particles::ON_SURFACE, 10000);
  filter->SetMemoryLimit(20e6);
  filter->SetCheckpoints(10000);
  filter->SetNumberOfSteps(3);
  RELIEVO_CHECK(PlacesAt(filter, 3.).size() == 10000);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSurfaceParticlesInputs)
{
  relievoTest::Session session;
  TestSpeedJumps();
  TestFieldAtPoints();
  TestNarrowestNoise();
  TestBlocksAndThreads();
  TestAbort();
  TestMemoryOfSteps();
  return session.Result();
}
}
