// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rays of a View compared with VTK's own transforms, which share no code with it.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "View.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <vector>

namespace testView
{
namespace
{
struct Case
{
  const char* Name;
  int Width;
  int Height;
  std::function<void(vtkRenderer*, vtkCamera*)> Set;
};

const std::vector<Case> Cases = {
  { "square", 300, 300, [](vtkRenderer*, vtkCamera*) {} },
  { "wide", 801, 450, [](vtkRenderer*, vtkCamera*) {} },
  { "tall, part of a window", 333, 717,
    [](vtkRenderer* renderer, vtkCamera*) { renderer->SetViewport(0.13, 0.21, 0.58, 0.87); } },
  { "parallel", 640, 480,
    [](vtkRenderer*, vtkCamera* camera) {
      camera->ParallelProjectionOn();
      camera->SetParallelScale(1.7);
    } },
  { "off centre", 500, 400,
    [](vtkRenderer*, vtkCamera* camera) { camera->SetWindowCenter(0.3, -0.45); } },
  { "parallel, off centre, part of a window", 500, 400,
    [](vtkRenderer* renderer, vtkCamera* camera) {
      renderer->SetViewport(0.5, 0., 1., 0.5);
      camera->ParallelProjectionOn();
      camera->SetWindowCenter(-0.2, 0.1);
    } },
  { "horizontal angle", 500, 200,
    [](vtkRenderer*, vtkCamera* camera) {
      camera->UseHorizontalViewAngleOn();
      camera->SetViewAngle(75.);
    } },
  { "own aspect", 500, 200,
    [](vtkRenderer*, vtkCamera* camera) {
      camera->UseExplicitAspectRatioOn();
      camera->SetExplicitAspectRatio(1.25);
    } },
  { "rolled, far from the origin", 500, 200,
    [](vtkRenderer*, vtkCamera* camera) {
      camera->SetPosition(5e5 + 2.5, 5e6 + 3., 6.);
      camera->SetFocalPoint(5e5, 5e6 + 0.5, 0.);
      camera->Roll(33.);
    } },
  { "far / near of 1e7", 300, 300,
    [](vtkRenderer*, vtkCamera* camera) { camera->SetClippingRange(1e-3, 1e4); } },
};

void TestCase(const Case& test)
{
  vtkNew<vtkRenderer> renderer;
  const auto window = relievoTest::MakeWindow(test.Width, test.Height, renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(2.5, 3., 6.);
  camera->SetFocalPoint(0., 0.5, 0.);
  camera->SetClippingRange(2., 14.);
  test.Set(renderer, camera);
  const relievoTest::View view(renderer);

  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  RELIEVO_CHECK(view.Width == size[0] && view.Height == size[1]);
  RELIEVO_CHECK(view.Left == origin[0] && view.Bottom == origin[1]);

  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0., 1.);
  double worstPixel = 0.;
  double worstDepth = 0.;
  double worstBack = 0.;
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec2 pixel(share(random) * view.Width, share(random) * view.Height);
    const double depth = view.Near * std::pow(view.Far / view.Near, share(random));
    const glm::dvec3 world = view.PixelRay(pixel.x, pixel.y).At(depth);

    glm::dvec3 ndc = world;
    renderer->WorldToView(ndc.x, ndc.y, ndc.z);
    const glm::dvec2 theirs = 0.5 * (glm::dvec2(ndc) + 1.) * glm::dvec2(size[0], size[1]);
    worstPixel = std::max(worstPixel, glm::length(theirs - pixel));

    const double eye[4] = { world.x, world.y, world.z, 1. };
    double inEye[4];
    camera->GetViewTransformMatrix()->MultiplyPoint(eye, inEye);
    worstDepth = std::max(worstDepth, std::abs(-inEye[2] - depth) / depth);
    worstDepth = std::max(worstDepth, std::abs(view.Depth(world) - depth) / depth);

    glm::dvec2 back(-1.);
    RELIEVO_CHECK(view.Project(world, back));
    worstBack = std::max(worstBack, glm::length(back - pixel));
  }
  // Coordinates of 5e6 leave a relative rounding of 1e-9 in double.
  const std::string name = test.Name;
  RELIEVO_CHECK_AT_MOST(worstPixel, 1e-6, name + ": pixels off VTK's");
  RELIEVO_CHECK_AT_MOST(worstBack, 1e-6, name + ": pixels off after projecting back");
  RELIEVO_CHECK_AT_MOST(worstDepth, 1e-9, name + ": depth off VTK's");
}

// The edges of the clipping range are at 0 and 1 of vtkRenderer::WorldToView.
void TestRange()
{
  vtkNew<vtkRenderer> renderer;
  const auto window = relievoTest::MakeWindow(100, 100, renderer);
  renderer->GetActiveCamera()->SetClippingRange(2., 14.);
  const relievoTest::View view(renderer);
  glm::dvec3 nearPoint = view.PixelRay(20., 30.).At(view.Near);
  glm::dvec3 farPoint = view.PixelRay(20., 30.).At(view.Far);
  renderer->WorldToView(nearPoint.x, nearPoint.y, nearPoint.z);
  renderer->WorldToView(farPoint.x, farPoint.y, farPoint.z);
  RELIEVO_CHECK_NEAR(nearPoint.z, 0., 1e-12, "near plane");
  RELIEVO_CHECK_NEAR(farPoint.z, 1., 1e-12, "far plane");
  glm::dvec2 pixel;
  RELIEVO_CHECK(!view.Project(view.Eye - view.Forward, pixel));
  RELIEVO_CHECK(!view.Project(view.Eye, pixel));
}

void TestRefusals()
{
  vtkNew<vtkRenderer> renderer;
  RELIEVO_CHECK(relievoTest::FailuresOf([&] { relievoTest::View(nullptr); }) == 1);
  RELIEVO_CHECK(relievoTest::FailuresOf([&] { relievoTest::View{ renderer }; }) == 1);
  const auto window = relievoTest::MakeWindow(100, 100, renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  const auto refused = [&] {
    return relievoTest::FailuresOf([&] { relievoTest::View{ renderer }; }) == 1;
  };
  RELIEVO_CHECK(!refused());
  camera->SetViewShear(0.1, 0., 1.);
  RELIEVO_CHECK(refused());
  camera->SetViewShear(0., 0., 1.);
  camera->UseOffAxisProjectionOn();
  RELIEVO_CHECK(refused());
  camera->UseOffAxisProjectionOff();
  vtkNew<vtkMatrix4x4> model;
  model->SetElement(0, 3, 1.);
  camera->SetModelTransformMatrix(model);
  RELIEVO_CHECK(refused());
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testView)
{
  relievoTest::Session session;
  for (const Case& test : Cases)
  {
    TestCase(test);
  }
  TestRange();
  TestRefusals();
  return session.Result();
}
}
