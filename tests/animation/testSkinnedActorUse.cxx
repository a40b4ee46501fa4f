// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoSkinnedActor in use: bounds hold the moved mesh, the hardware selector picks it, other
// pickers take the moved mesh, which is there without a frame; markers follow it.
#include "Check.h"
#include "Layers.h"
#include "Session.h"
#include "SkinnedScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkCellPicker.h>
#include <vtkDataObject.h>
#include <vtkHardwareSelector.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkRelievoMarkers.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>

namespace testSkinnedActorUse
{
namespace
{
using namespace relievoTest;
constexpr int Methods[] = { vtkRelievoSkin::LINEAR, vtkRelievoSkin::DUAL_QUATERNION,
  vtkRelievoSkin::KEY_MATRIX };

double SizeOf(const double* b)
{
  return std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}

// Nothing sticks out, whatever the pose; and where joints bend as limbs do, little is too much.
void TestBounds()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1., 1.);
  const auto tube = MakeThreeBoneTube(33, 16);
  double loosest = 0.;
  for (int i = 0; i < 60; ++i)
  {
    const bool wild = i % 2 == 1;
    const auto pose = wild
      ? MakeBentPose(3. * any(random), 0.1 + std::abs(any(random)), i % 4 == 1 ? any(random) : 1.)
      : MakeBentPose(0.6 * any(random), 1., 1.);
    for (const int method : Methods)
    {
      vtkNew<vtkRelievoSkinnedActor> actor;
      actor->SetInputData(tube);
      actor->SetSkeletonData(pose);
      actor->SetMethod(method);
      vtkNew<vtkTransform> place;
      place->RotateX(30. * i);
      place->Scale(1., 2., -0.5);
      actor->SetUserTransform(place);
      double moved[6];
      for (int again = 0; again < 2; ++again)
      {
        actor->GetBounds(moved);
      }
      const auto mesh = Skin(tube, pose, method);
      double tight[6] = { 1e300, -1e300, 1e300, -1e300, 1e300, -1e300 };
      for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
      {
        double at[3];
        place->TransformPoint(mesh->GetPoint(p), at);
        for (int axis = 0; axis < 3; ++axis)
        {
          tight[2 * axis] = std::min(tight[2 * axis], at[axis]);
          tight[2 * axis + 1] = std::max(tight[2 * axis + 1], at[axis]);
        }
      }
      for (int side = 0; side < 6; ++side)
      {
        const double out = (side % 2 ? 1. : -1.) * (tight[side] - moved[side]);
        RELIEVO_CHECK_THAT(out <= 1e-6,
          MethodName(method) + ": " + std::to_string(out) + " sticks out, pose " +
            std::to_string(i));
      }
      loosest = wild ? loosest : std::max(loosest, SizeOf(moved) / SizeOf(tight));
    }
  }
  RELIEVO_CHECK_AT_MOST(loosest, 1.6, "bounds of bent limbs beside the tightest");
}

// Far out of the rest mesh's place, the camera that VTK resets sees all of it.
void TestNothingClipped()
{
  SkinnedPair pair;
  const auto tube = MakeThreeBoneTube(33, 16);
  const glm::dmat4 away = MoveBy({ 40., -30., 20. });
  const auto pose =
    MakeSkeleton({ away, away * MoveBy({ 1.3, 0., 0. }), away * MoveBy({ 2.9, 0., 0. }) });
  pair.CPU.Set(tube, pose, vtkRelievoSkin::LINEAR);
  pair.GPU.Set(tube, pose, vtkRelievoSkin::LINEAR);
  vtkRenderer* renderer = pair.GPU.Stage.Renderer;
  renderer->ResetCamera();
  pair.CPU.Stage.Renderer->GetActiveCamera()->DeepCopy(renderer->GetActiveCamera());
  pair.CompareLayers("far away");
}

// Cells under each pixel, by VTK's hardware selector.
std::vector<vtkIdType> Pick(SkinnedSide& side)
{
  side.Stage.Window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(side.Stage.Renderer);
  const int* size = side.Stage.Window->GetSize();
  selector->SetArea(
    0, 0, static_cast<unsigned int>(size[0] - 1), static_cast<unsigned int>(size[1] - 1));
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  std::vector<vtkIdType> ids;
  RELIEVO_CHECK(selector->CaptureBuffers());
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const unsigned int at[2] = { static_cast<unsigned int>(x), static_cast<unsigned int>(y) };
      const auto found = selector->GetPixelInformation(at);
      RELIEVO_CHECK(!found.Valid || found.Prop == side.Actor);
      ids.push_back(found.Valid ? found.AttributeID : -1);
    }
  }
  return ids;
}

void TestPicking()
{
  SkinnedPair pair(160, 120);
  pair.Set(MakeThreeBoneTube(41, 20), MakeBentPose(0.7, 1., 1.), vtkRelievoSkin::DUAL_QUATERNION);
  const std::vector<vtkIdType> truth = Pick(pair.CPU);
  const std::vector<vtkIdType> picked = Pick(pair.GPU);
  int seen = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    seen += truth[i] >= 0 ? 1 : 0;
    const int x = static_cast<int>(i) % 160;
    const int y = static_cast<int>(i) / 160;
    RELIEVO_CHECK_THAT(truth[i] == picked[i] || pair.IsNearEdge(x, y, 1. / 256.),
      "another cell is picked at " + std::to_string(x) + " " + std::to_string(y));
  }
  RELIEVO_CHECK(seen > 1000);
}

// VTK's pickers on the CPU read the mapper's mesh, which is at rest; on the moved mesh they are
// right.
void TestPickingOnTheCPU()
{
  SkinnedSide side(true, 160, 120);
  side.Set(MakeThreeBoneTube(21, 10), MakeBentPose(1.2, 1., 1.), vtkRelievoSkin::LINEAR);
  side.Stage.Renderer->ResetCamera();
  const std::vector<vtkIdType> truth = Pick(side);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(side.Skinned->GetMovedMesh());
  vtkNew<vtkActor> moved;
  moved->SetMapper(mapper);
  const auto right = [&](vtkActor* actor) {
    vtkNew<vtkCellPicker> picker;
    picker->SetTolerance(0.);
    picker->PickFromListOn();
    picker->AddPickList(actor);
    int same = 0;
    int seen = 0;
    for (std::size_t i = 0; i < truth.size(); i += 7)
    {
      if (truth[i] >= 0)
      {
        ++seen;
        picker->Pick(static_cast<double>(i % 160) + 0.5, static_cast<double>(i / 160) + 0.5, 0.,
          side.Stage.Renderer);
        same += picker->GetCellId() == truth[i] ? 1 : 0;
      }
    }
    RELIEVO_CHECK(seen > 100);
    return static_cast<double>(same) / seen;
  };
  const double atRest = right(side.Actor);
  const double asMoved = right(moved);
  std::cout << "vtkCellPicker: " << atRest << " right, of the moved mesh " << asMoved << "\n";
  RELIEVO_CHECK_AT_MOST(atRest, 0.3, "cells that vtkCellPicker picks right of the mapper's mesh");
  RELIEVO_CHECK_AT_MOST(1. - asMoved, 0.1, "cells of the moved mesh that it picks wrong");
}

double Apart(vtkPolyData* a, vtkPolyData* b)
{
  RELIEVO_CHECK(a && b && a->GetNumberOfPoints() == b->GetNumberOfPoints());
  double apart = 0.;
  for (vtkIdType i = 0; a && i < a->GetNumberOfPoints(); ++i)
  {
    apart = Larger(apart, glm::distance(PointOf(a, i), PointOf(b, i)));
  }
  return apart;
}

// The moved mesh is that of all that was set, without a frame between.
void TestMovedMesh()
{
  const auto tube = MakeThreeBoneTube(33, 16);
  const auto pose = MakeBentPose(0.7, 1.2, 1.);
  const auto other = MakeBentPose(-0.5, 1., 1.);
  vtkNew<vtkRelievoSkinnedActor> actor;
  RELIEVO_CHECK(actor->GetMovedMesh() == nullptr);
  actor->SetInputData(tube);
  actor->SetSkeletonData(pose);
  RELIEVO_CHECK_AT_MOST(Apart(actor->GetMovedMesh(), Skin(tube, pose, 0)), 0., "a new actor");
  actor->SetMethod(vtkRelievoSkin::DUAL_QUATERNION);
  RELIEVO_CHECK_AT_MOST(Apart(actor->GetMovedMesh(), Skin(tube, pose, 1)), 0., "a method");
  actor->SetSkeletonData(other);
  RELIEVO_CHECK_AT_MOST(Apart(actor->GetMovedMesh(), Skin(tube, other, 1)), 0., "a skeleton");
  const auto wide = MakeThreeBoneTube(21, 16);
  actor->SetInputData(wide);
  RELIEVO_CHECK_AT_MOST(Apart(actor->GetMovedMesh(), Skin(wide, other, 1)), 0., "a mesh");
  RELIEVO_CHECK(actor->GetMovedMesh()->GetPointData()->GetNumberOfArrays() ==
    Skin(wide, other, 1)->GetPointData()->GetNumberOfArrays());
  actor->BindPoseOn();
  RELIEVO_CHECK_AT_MOST(Apart(actor->GetMovedMesh(), wide), 0., "the bind pose");
  actor->BindPoseOff();
  RELIEVO_CHECK_AT_MOST(Apart(actor->GetMovedMesh(), Skin(wide, other, 1)), 0., "the pose again");
  actor->SetInputData(nullptr);
  RELIEVO_CHECK(actor->GetMovedMesh() == nullptr);
  RELIEVO_CHECK(!vtkMath::AreBoundsInitialized(actor->GetBounds()));
}

// A marker lies around the figure where it has gone, along its own axes.
void TestMarkers()
{
  const auto tube = MakeThreeBoneTube(33, 16);
  const glm::dmat4 away = MoveBy({ 40., -30., 20. });
  vtkNew<vtkRelievoSkinnedActor> actor;
  actor->SetInputData(tube);
  actor->SetSkeletonData(
    MakeSkeleton({ away, away * MoveBy({ 1.3, 0., 0. }), away * MoveBy({ 2.9, 0., 0. }) }));
  actor->RotateZ(30.);
  actor->SetScale(2.);
  vtkNew<vtkRelievoMarkers> markers;
  markers->AddActor(actor);
  const std::vector<vtkRelievoMarkers::Box> boxes = markers->GetBoxes();
  if (RELIEVO_CHECK(boxes.size() == 1))
  {
    double b[6];
    tube->GetBounds(b);
    const glm::dvec3 middle(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]));
    const glm::dmat3 turn(TurnAbout({ 0., 0., 1. }, 30. * vtkMath::Pi() / 180.));
    const glm::dvec3 expected = turn * (2. * (middle + glm::dvec3(away[3])));
    for (int i = 0; i < 3; ++i)
    {
      RELIEVO_CHECK_NEAR(boxes[0].Center[i], expected[i], 1e-5, "the marker's middle");
      RELIEVO_CHECK_NEAR(boxes[0].Half[i], b[2 * i + 1] - b[2 * i], 1e-3, "its half size");
      RELIEVO_CHECK_NEAR(boxes[0].Axes[0][i], turn[0][i], 1e-9, "its first axis");
    }
  }
  actor->SetInputData(nullptr);
  RELIEVO_CHECK(markers->GetBoxes().empty());
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSkinnedActorUse)
{
  relievoTest::Session session;
  TestBounds();
  TestNothingClipped();
  TestPicking();
  TestPickingOnTheCPU();
  TestMovedMesh();
  TestMarkers();
  return session.Result();
}
}
