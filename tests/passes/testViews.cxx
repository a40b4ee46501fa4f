// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Layers of unusual views: off-centre windows, several viewports, resized, tiny, empty and huge
// windows, two windows with one pass, a camera inside, up along the view, release and render again.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>

#include <cmath>
#include <cstring>

namespace testViews
{
namespace
{
using relievoTest::Layers;
using relievoTest::Way;

// Every position seen must be on the ball of radius 1 about `center`, and be seen at its pixel.
void CheckBall(const std::string& what, vtkRenderer* renderer, const Layers& layers,
  const glm::dvec3& center, double tolerance, long atLeast)
{
  long seen = 0;
  double worst = 0.;
  double worstPixel = 0.;
  vtkMatrix4x4* toView = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1., 1.);
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      if (!std::isfinite(layers.Value("depth", x, y)))
      {
        continue;
      }
      ++seen;
      const glm::dvec3 p = layers.Vector("position", x, y);
      worst = std::max(worst, std::abs(glm::length(p - center) - 1.));
      const double world[4] = { p.x, p.y, p.z, 1. };
      double clip[4];
      toView->MultiplyPoint(world, clip);
      worstPixel =
        std::max({ worstPixel, std::abs((clip[0] / clip[3] + 1.) / 2. * layers.Width - (x + 0.5)),
          std::abs((clip[1] / clip[3] + 1.) / 2. * layers.Height - (y + 0.5)) });
    }
  }
  RELIEVO_CHECK_THAT(seen >= atLeast, what + ": only " + std::to_string(seen) + " pixels seen");
  RELIEVO_CHECK_AT_MOST(worst, tolerance, what + ": distance from the ball's surface");
  RELIEVO_CHECK_AT_MOST(worstPixel, 0.01, what + ": position's distance from its pixel");
}

// The facets of the ball (12 x 9) are within this of the unit sphere.
const double Facets = 0.11;

void TestCameras()
{
  for (const Way way : relievoTest::BothWays)
  {
    const std::string name = relievoTest::ToString(way);
    relievoTest::Stage stage(160, 120);
    relievoTest::AddActor(stage.Renderer, relievoTest::MakeBall(1.));
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    auto check = [&](const std::string& what, long atLeast) {
      CheckBall(name + ", " + what, stage.Renderer,
        Layers(stage.Renderer, { "depth", "position" }, way), glm::dvec3(0.), Facets, atLeast);
    };
    check("reference", 500);
    camera->SetWindowCenter(0.3, -0.2);
    check("off centre", 500);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.5);
    check("off centre, parallel", 500);
    camera->ParallelProjectionOff();
    camera->SetWindowCenter(0., 0.);
    camera->SetUseHorizontalViewAngle(1);
    check("horizontal view angle", 500);
    camera->SetUseHorizontalViewAngle(0);
    camera->SetPosition(0., 6., 0.);
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., 1., 0.);
    {
      // VTK makes no picture of it; whatever comes is finite or nothing, and no crash.
      vtkNew<vtkRelievoLayerSource> source;
      source->SetRenderer(stage.Renderer);
      source->AddLayer("normal");
      source->AddLayer("depth");
      source->Update();
    }
    camera->SetViewUp(0., 0., -1.);
    check("from above", 500);
    camera->SetPosition(0.1, 0., 0.);
    camera->SetFocalPoint(-1., 0., 0.);
    camera->SetViewUp(0., 1., 0.);
    camera->SetClippingRange(0.01, 10.);
    check("from inside", 160 * 120);
  }
}

void TestWindows()
{
  relievoTest::Stage stage(160, 120);
  relievoTest::AddActor(stage.Renderer, relievoTest::MakeBall(1.));
  relievoTest::GLCheck gl(stage.Window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  frame->RequestLayer("position");
  frame->RequestLayer("depth");
  const int sizes[][2] = { { 160, 120 }, { 301, 50 }, { 1, 1 }, { 64, 200 }, { 160, 120 } };
  for (const auto& size : sizes)
  {
    stage.Window->SetSize(size[0], size[1]);
    stage.Window->Render();
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(frame->ReadLayer("depth", image) && frame->ReadLayer("position", image));
    const Layers layers(image);
    RELIEVO_CHECK(layers.Width == size[0] && layers.Height == size[1]);
    CheckBall(std::to_string(size[0]) + " x " + std::to_string(size[1]), stage.Renderer, layers,
      glm::dvec3(0.), Facets, size[0] > 1 ? 100 : 0);
  }
  // Release and render again.
  frame->ReleaseGraphicsResources(stage.Window);
  RELIEVO_CHECK(frame->GetBytesHeld() == 0);
  stage.Window->Render();
  vtkNew<vtkImageData> again;
  RELIEVO_CHECK(frame->ReadLayer("depth", again) && frame->GetBytesHeld() > 0);
  vtkRelievoPass::Detach(stage.Renderer);
  gl.Poll("windows");
}

void TestNothingThere()
{
  relievoTest::Stage stage(40, 30);
  auto ball = relievoTest::AddActor(stage.Renderer, relievoTest::MakeBall(1.));
  ball->VisibilityOff();
  const Layers layers(stage.Renderer,
    { "depth", "range", "normal", "position", "albedo", "actor", "block", "cell" }, Way::Own);
  for (int y = 0; y < 30; ++y)
  {
    for (int x = 0; x < 40; ++x)
    {
      RELIEVO_CHECK(std::isinf(layers.Value("depth", x, y)) && layers.Value("depth", x, y) > 0.);
      RELIEVO_CHECK(std::isinf(layers.Value("range", x, y)));
      RELIEVO_CHECK(layers.Vector("normal", x, y) == glm::dvec3(0.));
      RELIEVO_CHECK(layers.Vector("position", x, y) == glm::dvec3(0.));
      RELIEVO_CHECK(layers.Value("albedo", x, y, 3) == 0.);
      RELIEVO_CHECK(layers.Id("actor", x, y) == -1 && layers.Id("block", x, y) == -1 &&
        layers.Id("cell", x, y) == -1);
    }
  }
  stage.Renderer->RemoveAllViewProps();
  const Layers empty(stage.Renderer, { "depth", "cell" }, Way::Own);
  RELIEVO_CHECK(empty.Id("cell", 20, 15) == -1);
}

// Each renderer its own layers, and no pixel outside its viewport touched.
void TestViewports()
{
  relievoTest::Stage stage(300, 100);
  vtkNew<vtkRenderer> second;
  vtkNew<vtkRenderer> third;
  vtkRenderer* renderers[3] = { stage.Renderer, second, third };
  for (int i = 0; i < 3; ++i)
  {
    renderers[i]->SetViewport(i / 3., 0., (i + 1) / 3., 1.);
    auto ball = relievoTest::AddActor(renderers[i], relievoTest::MakeBall(1.));
    ball->GetProperty()->SetColor(i == 0, i == 1, i == 2);
    if (i > 0)
    {
      renderers[i]->SetActiveCamera(stage.Renderer->GetActiveCamera());
      stage.Window->AddRenderer(renderers[i]);
    }
  }
  const auto before = relievoTest::Picture(stage.Window);
  vtkRelievoPass::Attach(second)->RequestLayer("depth");
  vtkRelievoPass::Attach(third)->SetDisplayLayer("normal");
  const auto after = relievoTest::Picture(stage.Window);
  long other[3] = { 0, 0, 0 };
  for (int y = 0; y < 100; ++y)
  {
    for (int x = 0; x < 300; ++x)
    {
      other[x / 100] +=
        std::memcmp(before->GetScalarPointer(x, y, 0), after->GetScalarPointer(x, y, 0), 3) != 0;
    }
  }
  RELIEVO_CHECK(other[0] == 0 && other[1] == 0 && other[2] > 1000);
  vtkNew<vtkImageData> image;
  auto* frame = vtkRelievoPass::SafeDownCast(second->GetPass());
  RELIEVO_CHECK(frame && frame->GetLayersStage()->GetShared() && frame->ReadLayer("depth", image));
  const Layers shared(image);
  const Layers alone(second, { "depth" }, Way::Own);
  RELIEVO_CHECK(shared.Width == 100 && shared.Height == 100);
  for (int y = 0; y < 100; ++y)
  {
    for (int x = 0; x < 100; ++x)
    {
      RELIEVO_CHECK(shared.Value("depth", x, y) == alone.Value("depth", x, y));
    }
  }
  vtkRelievoPass::Detach(second);
  vtkRelievoPass::Detach(third);
}

void TestTwoWindows()
{
  relievoTest::Stage one(80, 60);
  relievoTest::Stage two(120, 50);
  relievoTest::AddActor(one.Renderer, relievoTest::MakeBall(1.));
  relievoTest::AddActor(two.Renderer, relievoTest::MakeBall(1.));
  vtkNew<vtkRelievoPass> frame;
  frame->RequestLayer("depth");
  frame->RequestLayer("position");
  one.Renderer->SetPass(frame);
  two.Renderer->SetPass(frame);
  for (int i = 0; i < 6; ++i)
  {
    relievoTest::Stage& stage = i % 2 ? two : one;
    stage.Window->Render();
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(frame->ReadLayer("depth", image) && frame->ReadLayer("position", image));
    CheckBall("window " + std::to_string(i % 2), stage.Renderer, Layers(image), glm::dvec3(0.),
      Facets, 100);
  }
  one.Renderer->SetPass(nullptr);
  two.Renderer->SetPass(nullptr);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testViews)
{
  relievoTest::Session session;
  session.Allow("Resetting view-up");
  TestCameras();
  TestWindows();
  TestNothingThere();
  TestViewports();
  TestTwoWindows();
  return session.Result();
}
}
