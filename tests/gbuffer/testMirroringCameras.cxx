// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A picture that the camera mirrors, by its view, its model transform or its projection, is the
// other way round and nothing else: its layers are those of the picture that is not mirrored, which
// testLayersNormals compares with the truth.
#include "Check.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Truth.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>

namespace testMirroringCameras
{
namespace
{
using relievoTest::Layers;
using relievoTest::Stage;

void Mirror(vtkRenderer* renderer, const std::string& by)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkNew<vtkTransform> mirror;
  mirror->Scale(-1., 1., 1.);
  vtkNew<vtkMatrix4x4> matrix;
  if (by == "view")
  {
    camera->SetUserViewTransform(mirror);
  }
  else if (by == "model")
  {
    vtkMatrix4x4* toView = camera->GetViewTransformMatrix();
    vtkMatrix4x4::Invert(toView, matrix);
    vtkMatrix4x4::Multiply4x4(matrix, mirror->GetMatrix(), matrix);
    vtkMatrix4x4::Multiply4x4(matrix, toView, matrix);
    camera->SetModelTransformMatrix(matrix);
  }
  else
  {
    vtkMatrix4x4::Multiply4x4(
      camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1., 1.),
      mirror->GetMatrix(), matrix);
    camera->SetExplicitProjectionTransformMatrix(matrix);
    camera->UseExplicitProjectionTransformMatrixOn();
  }
}

void Test(const std::string& by, bool lit, relievoTest::Way way)
{
  const Stage stage(160, 120);
  const auto ball = relievoTest::AddActor(stage.Renderer, relievoTest::MakeBall(0.8));
  ball->SetPosition(-0.6, 0.7, 0.);
  vtkNew<vtkPolyDataNormals> normals; // of the points
  normals->SetInputData(relievoTest::MakeBox(1., 1., 1.));
  normals->Update();
  const auto box = relievoTest::AddActor(stage.Renderer, normals->GetOutput());
  box->SetPosition(0.9, 0.6, 0.);
  box->SetScale(-1., 1.2, 0.7);
  ball->GetProperty()->SetLighting(lit);
  box->GetProperty()->SetLighting(lit);
  const auto capture = [&]() {
    return Layers(stage.Renderer, { "depth", "normal", "geometric_normal", "actor", "cell" }, way,
      [](auto* g) { g->SetNormalFormat(vtkRelievoLayersStage::NORMAL_FLOAT32); });
  };
  const Layers plain = capture();
  Mirror(stage.Renderer, by);
  const Layers mirrored = capture();
  long long same = 0;
  double worst = 0.;
  for (int y = 0; y < plain.Height; ++y)
  {
    for (int x = 0; x < plain.Width; ++x)
    {
      const int other = plain.Width - 1 - x;
      const int actor = plain.Id("actor", x, y);
      if (actor < 0 || mirrored.Id("actor", other, y) != actor ||
        mirrored.Id("cell", other, y) != plain.Id("cell", x, y))
      {
        continue;
      }
      ++same;
      for (const char* name : { "normal", "geometric_normal" })
      {
        worst = std::max(worst,
          relievoTest::AngleDegrees(plain.Vector(name, x, y), mirrored.Vector(name, other, y)));
      }
    }
  }
  const std::string what = "mirrored by the " + by + ", " + relievoTest::ToString(way);
  RELIEVO_CHECK_THAT(same > 3000 && same > 0.97 * static_cast<double>(plain.Covered()),
    what + ": the same at " + std::to_string(same) + " pixels only");
  RELIEVO_CHECK_AT_MOST(worst, 0.1, what + ": normals, degrees");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testMirroringCameras)
{
  relievoTest::Session session;
  for (const char* by : { "view", "model", "projection" })
  {
    for (const bool lit : { true, false })
    {
      Test(by, lit, relievoTest::Way::Own);
      Test(by, lit, relievoTest::Way::Shared);
    }
  }
  return session.Result();
}
}
