// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inputs that change in time: their first time counts, for any requested time and whatever else
// moves them; unchanged inputs cost no new step.
#include "Check.h"
#include "Particles.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "vtkRelievoSurfaceParticles.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <functional>
#include <string>

namespace testSurfaceParticlesMoving
{
namespace
{
using relievoTest::Moved;
using relievoTest::Places;
using relievoTest::PlacesAt;
using Particles = vtkRelievoSurfaceParticles;
using SDDP = vtkStreamingDemandDrivenPipeline;

void SetUp(Particles* filter, vtkDataObject* surface, int place, int count = 400)
{
  filter->SetInputDataObject(surface);
  filter->SetPlace(place);
  filter->SetNumberOfParticles(count);
  filter->SetResolution(80);
}

// A ball at x = time, at times from 3 to 5.
class MovingBall : public vtkPolyDataAlgorithm
{
public:
  static MovingBall* New();
  vtkTypeMacro(MovingBall, vtkPolyDataAlgorithm);
  int Executions = 0;
  std::function<glm::dvec3(const glm::dvec3&)> Field; // at its points, the other way at later times

protected:
  MovingBall() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    const double times[3] = { 3., 4., 5. };
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(SDDP::TIME_STEPS(), times, 3);
    const double range[2] = { 3., 5. };
    info->Set(SDDP::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    const double time =
      info->Has(SDDP::UPDATE_TIME_STEP()) ? info->Get(SDDP::UPDATE_TIME_STEP()) : 5.;
    vtkPolyData* output = vtkPolyData::GetData(info);
    auto ball = Moved(relievoTest::MakeBall().Mesh, { time, 0., 0. });
    if (this->Field)
    {
      ball = relievoTest::WithField(
        ball, [&](const glm::dvec3& place) { return (time > 3. ? -1. : 1.) * this->Field(place); });
    }
    output->ShallowCopy(ball);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    ++this->Executions;
    return 1;
  }
};
vtkStandardNewMacro(MovingBall);

void TestMovingInput()
{
  vtkNew<MovingBall> source;
  vtkNew<Particles> still;
  SetUp(still, Moved(relievoTest::MakeBall().Mesh, { 3., 0., 0. }), Particles::ON_SURFACE);
  vtkNew<Particles> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetNumberOfParticles(400);
  filter->SetResolution(80);
  for (Particles* each : { still.Get(), filter.Get() })
  {
    each->SetNoiseSpeed(0.02);
  }
  for (const double time : { 0., 4., 5., 30., 2. })
  {
    RELIEVO_CHECK_THAT(
      PlacesAt(filter, time) == PlacesAt(still, time), "time " + std::to_string(time));
  }
  RELIEVO_CHECK(source->Executions == 1);
}

// The first time counts for each input, so also for the points and the field.
void TestMovingPointsAndField()
{
  const auto field = [](const glm::dvec3& place) {
    return 0.02 * glm::dvec3(place.y, 3. - place.x, 0.5);
  };
  const auto ball = Moved(relievoTest::MakeBall().Mesh, { 3., 0., 0. });
  vtkNew<MovingBall> points;
  vtkNew<MovingBall> arrows;
  arrows->Field = field;
  vtkNew<Particles> still;
  SetUp(still, ball, Particles::ON_SURFACE);
  still->SetInputDataObject(2, ball);
  still->SetInputDataObject(3, relievoTest::WithField(ball, field));
  vtkNew<Particles> filter;
  SetUp(filter, ball, Particles::ON_SURFACE);
  filter->SetInputConnection(2, points->GetOutputPort());
  filter->SetInputConnection(3, arrows->GetOutputPort());
  for (Particles* each : { still.Get(), filter.Get() })
  {
    each->SetFieldArray("field");
  }
  const Places start = PlacesAt(filter, 0.);
  for (const double time : { 4., 5., 30., 3. })
  {
    // Another consumer moves the inputs on.
    points->UpdateTimeStep(5.);
    arrows->UpdateTimeStep(4.);
    const Places places = PlacesAt(filter, time);
    RELIEVO_CHECK_THAT(places == PlacesAt(still, time), "time " + std::to_string(time));
    RELIEVO_CHECK(places != start && !places.empty());
  }
}

// An input that another consumer moves through time, or that executes again, costs no step anew;
// one that differs does, also where not its array but the mesh says that it was modified.
void TestSameInputAgain()
{
  vtkNew<MovingBall> source;
  vtkNew<Particles> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetNumberOfParticles(50);
  filter->SetResolution(40);
  filter->SetNoiseSpeed(0.02);
  int steps = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&steps);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* sum, void*) { ++*static_cast<int*>(sum); });
  PlacesAt(filter, 40.);
  filter->AddObserver(vtkCommand::ProgressEvent, count);
  const auto costs = [&](double time) {
    steps = 0;
    PlacesAt(filter, time);
    return steps;
  };
  // One step, and the pipeline's own cost.
  RELIEVO_CHECK(costs(41.) <= 3);
  source->UpdateTimeStep(5.);
  RELIEVO_CHECK(costs(42.) <= 3);
  source->Modified();
  RELIEVO_CHECK(costs(43.) <= 3);
  filter->OrientationsOn();
  RELIEVO_CHECK(costs(44.) <= 3);
  RELIEVO_CHECK(source->Executions == 4);
  filter->SetVelocity(0.01, 0., 0.);
  RELIEVO_CHECK(costs(45.) >= 45);

  const auto mesh = relievoTest::WithField(Moved(relievoTest::MakeBall().Mesh, { 0., 0., 0. }),
    [](const glm::dvec3& place) { return 0.02 * glm::dvec3(place.y, -place.x, 0.); });
  filter->SetInputData(mesh);
  filter->SetFieldArray("field");
  const Places before = PlacesAt(filter, 20.);
  mesh->Modified();
  RELIEVO_CHECK(costs(21.) <= 3);
  auto* field = vtkDoubleArray::SafeDownCast(mesh->GetPointData()->GetArray("field"));
  for (vtkIdType i = 0; i < field->GetNumberOfValues(); ++i)
  {
    field->SetValue(i, -field->GetValue(i));
  }
  mesh->Modified();
  const Places turned = PlacesAt(filter, 20.);
  RELIEVO_CHECK(turned != before);
  auto* points = vtkDoubleArray::SafeDownCast(mesh->GetPoints()->GetData());
  for (vtkIdType i = 0; i < points->GetNumberOfValues(); ++i)
  {
    points->SetValue(i, 2. * points->GetValue(i));
  }
  mesh->GetPoints()->Modified();
  vtkNew<Particles> fresh;
  fresh->SetInputData(mesh);
  fresh->SetNumberOfParticles(50);
  fresh->SetResolution(40);
  fresh->SetNoiseSpeed(0.02);
  fresh->SetVelocity(0.01, 0., 0.);
  fresh->SetFieldArray("field");
  RELIEVO_CHECK(PlacesAt(filter, 20.) == PlacesAt(fresh, 20.));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSurfaceParticlesMoving)
{
  relievoTest::Session session;
  TestMovingInput();
  TestMovingPointsAndField();
  TestSameInputAgain();
  return session.Result();
}
}
