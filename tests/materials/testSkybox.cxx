// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Each pixel of a skybox against the light of the ray through it: projections, views, rotations,
// edges, and the unchanged rest of the picture.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "Surroundings.h"
#include "TestCase.h"
#include "View.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRelievoEnvironment.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoSkybox.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>

namespace testSkybox
{
namespace
{
using namespace relievoTest;

const glm::dvec3 Nothing(-1.);
const glm::dvec3 Sides[6] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
  { 0, 0, -1 } };

struct Scene
{
  relievoTest::Stage Stage{ 160, 120 };
  vtkRenderer* Renderer = this->Stage.Renderer;
  vtkNew<vtkRelievoEnvironment> Environment;
  vtkNew<vtkRelievoSkybox> Sky;
  GLCheck Watch{ this->Stage.Window };

  Scene(const Light& light, int projection, int n)
  {
    this->Environment->SetImage(MakeEnvironment(light, projection, n));
    this->Sky->SetEnvironment(this->Environment);
    this->Renderer->AddViewProp(this->Sky);
  }
  double Worst(const Light& truth, int least = 1000)
  {
    return WorstDifference(this->Renderer, truth, least);
  }
};

// Half a 255th is rounding.
void TestSides()
{
  Scene scene(SixColors, Cube, 64);
  for (const glm::dvec3& side : Sides)
  {
    LookAlong(scene.Renderer, glm::dvec3(0.), side, 110.);
    const auto truth = [](const glm::dvec3& d) {
      return AngleToEdge(d) > 0.05 ? SixColors(d) : Nothing;
    };
    RELIEVO_CHECK_AT_MOST(scene.Worst(truth), 1e-6, "six colours, 255ths");
  }
}

void TestProjections()
{
  const char* const names[] = { "", "equirectangular", "cube", "sphere map" };
  for (const int projection : { Equirectangular, Cube, SphereMap })
  {
    Scene scene(Smooth, projection, projection == SphereMap ? 512 : 128);
    for (const glm::dvec3& side : Sides)
    {
      // Behind, a sphere map has few texels.
      const auto truth = [projection](const glm::dvec3& d) {
        return projection == SphereMap && d.z < -0.95 ? Nothing : Smooth(d);
      };
      LookAlong(scene.Renderer, glm::dvec3(0.), side, 100.);
      RELIEVO_CHECK_AT_MOST(scene.Worst(truth), projection == SphereMap ? 1.5 : 1.,
        std::string(names[projection]) + ", 255ths");
    }
    if (projection == SphereMap)
    {
      // Exactly behind: the rim of the circle, of any place; nothing from beyond it.
      LookAlong(scene.Renderer, glm::dvec3(0.), { 0, 0, -1 }, 20.);
      RELIEVO_CHECK_AT_MOST(scene.Worst(Smooth), 25., "sphere map, back-facing, 255ths");
    }
  }
}

void TestViews()
{
  Scene scene(Smooth, Cube, 256);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const glm::dvec3 forward = glm::normalize(glm::dvec3(0.5, -0.3, -0.8));
  for (const double angle : { 1., 30., 90., 150., 170. })
  {
    LookAlong(scene.Renderer, glm::dvec3(0.), forward, angle);
    // Where pixels see wide angles, they are of means.
    RELIEVO_CHECK_AT_MOST(scene.Worst(Smooth), angle < 120. ? 0.6 : 1.2,
      "view angle " + std::to_string(angle) + ", 255ths");
  }
  LookAlong(scene.Renderer, glm::dvec3(0.), forward, 40.);
  const Photo photo(scene.Stage.Window);
  for (const double away : { 1., 1e3, 1e6, 1e9 })
  {
    LookAlong(scene.Renderer, glm::dvec3(away, -away, 0.3 * away), forward, 40.);
    RELIEVO_CHECK_AT_MOST(scene.Worst(Smooth), 0.6, "eye at " + std::to_string(away) + ", 255ths");
  }
  LookAlong(scene.Renderer, glm::dvec3(0.), forward, 40.);
  camera->SetClippingRange(1e-4, 1e7);
  RELIEVO_CHECK_THAT(Photo(scene.Stage.Window).Bytes == photo.Bytes, "near and far take no part");
  camera->SetWindowCenter(0.8, -0.5);
  RELIEVO_CHECK_AT_MOST(scene.Worst(Smooth), 0.6, "shifted window, 255ths");
  camera->SetWindowCenter(0., 0.);
  camera->SetRoll(37.);
  RELIEVO_CHECK_AT_MOST(scene.Worst(Smooth), 0.6, "rolled, 255ths");

  // Off axis: the screen is a window of 4 x 3 at z = 0, looked through from beside.
  camera->SetUseOffAxisProjection(1);
  camera->SetScreenBottomLeft(-2., -1.5, 0.);
  camera->SetScreenBottomRight(2., -1.5, 0.);
  camera->SetScreenTopRight(2., 1.5, 0.);
  const glm::dvec3 eye(1.3, -0.4, 3.);
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetFocalPoint(eye.x, eye.y, 0.);
  camera->SetViewUp(0., 1., 0.);
  camera->SetEyeSeparation(0.);
  camera->SetEyePosition(const_cast<double*>(&eye[0]));
  camera->SetClippingRange(0.1, 100.);
  const Photo beside(scene.Stage.Window);
  double worst = 0.;
  for (int y = 0; y < beside.Height; ++y)
  {
    for (int x = 0; x < beside.Width; ++x)
    {
      // The camera's viewing direction at a place of the screen, in the camera's own axes, which
      // are the world's; the eye's position in them is as set.
      const glm::dvec3 place(
        4. * (x + 0.5) / beside.Width - 2., 3. * (y + 0.5) / beside.Height - 1.5, 0.);
      const glm::dvec3 off = glm::abs(Smooth(glm::normalize(place - eye)) - beside.At(x, y));
      worst = std::max({ worst, off.x, off.y, off.z });
    }
  }
  RELIEVO_CHECK_AT_MOST(255. * worst, 0.6, "off axis, 255ths");
  camera->SetUseOffAxisProjection(0);
}

void TestParallel()
{
  Scene scene(Smooth, Cube, 256);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const glm::dvec3 forward = glm::normalize(glm::dvec3(0.5, -0.3, -0.8));
  LookAlong(scene.Renderer, glm::dvec3(7.), forward, 50.);
  camera->ParallelProjectionOn();
  RELIEVO_CHECK_AT_MOST(scene.Worst(Smooth), 0.6, "parallel: one direction, 255ths");
  camera->ParallelProjectionOff();
  const Photo perspective(scene.Stage.Window);
  camera->ParallelProjectionOn();
  scene.Sky->SetParallelViewAngle(50.);
  const Photo parallel(scene.Stage.Window);
  double worst = 0.;
  for (std::size_t i = 0; i < parallel.Bytes.size(); ++i)
  {
    worst = std::max(worst, std::abs(double(parallel.Bytes[i]) - double(perspective.Bytes[i])));
  }
  RELIEVO_CHECK_AT_MOST(worst, 1., "parallel with an angle: as in perspective, 255ths");
}

// Twice as large a picture out of tiles has the same directions.
void TestTiles()
{
  for (const bool parallel : { false, true })
  {
    Scene scene(Smooth, Cube, 256);
    LookAlong(scene.Renderer, glm::dvec3(0.), { 0.5, -0.3, -0.8 }, 60.);
    scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    scene.Sky->SetParallelViewAngle(60.);
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(scene.Stage.Window);
    grab->SetScale(2, 2);
    grab->SetInputBufferTypeToRGB();
    grab->ReadFrontBufferOff();
    grab->Update();
    vtkImageData* image = grab->GetOutput();
    RELIEVO_CHECK(image->GetDimensions()[0] == 320);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
    const View view(scene.Renderer);
    double worst = 0.;
    for (int y = 0; y < 240; ++y)
    {
      for (int x = 0; x < 320; ++x)
      {
        const glm::dvec3 truth =
          Smooth(glm::normalize(view.PixelRay((x + 0.5) / 2., (y + 0.5) / 2.).Direction));
        for (int c = 0; c < 3; ++c)
        {
          worst = std::max(
            worst, std::abs(255. * truth[c] - image->GetScalarComponentAsDouble(x, y, 0, c)));
        }
      }
    }
    RELIEVO_CHECK_AT_MOST(worst, 0.6, parallel ? "tiles, parallel, 255ths" : "tiles, 255ths");
  }
}

void TestTurns()
{
  Scene scene(Smooth, Equirectangular, 256);
  LookAlong(scene.Renderer, glm::dvec3(0.), { 0.5, -0.3, -0.8 }, 90.);
  for (const double degrees : { 0., 90., -90., 180., 37., 450. })
  {
    scene.Environment->SetRotation(degrees);
    RELIEVO_CHECK_AT_MOST(scene.Worst([degrees](const glm::dvec3& d) {
      return Smooth(TurnedAbout({ 0, 1, 0 }, -degrees, d));
    }),
      1., "turned by " + std::to_string(degrees) + ", 255ths");
  }
  scene.Environment->SetRotation(90.);
  scene.Environment->SetUpAxis(2);
  RELIEVO_CHECK_AT_MOST(scene.Worst([](const glm::dvec3& world) {
    const glm::dvec3 d = TurnedAbout({ 0, 0, 1 }, -90., world);
    return Smooth({ d.x, d.z, -d.y });
  }),
    1., "z up, turned by 90, 255ths");
  scene.Environment->SetUpAxis(0);
  scene.Environment->SetRotation(20.);
  RELIEVO_CHECK_AT_MOST(scene.Worst([](const glm::dvec3& world) {
    const glm::dvec3 d = TurnedAbout({ 1, 0, 0 }, -20., world);
    return Smooth({ -d.y, d.x, d.z });
  }),
    1., "x up, turned by 20, 255ths");
  // The renderer's axes as those of VTK's environments: here z is up, y looks back.
  scene.Environment->SetUpAxis(1);
  scene.Environment->SetRotation(0.);
  scene.Renderer->SetEnvironmentUp(0., 0., 1.);
  RELIEVO_CHECK_AT_MOST(scene.Worst([](const glm::dvec3& d) {
    return Smooth({ d.x, d.z, -d.y });
  }),
    1., "the renderer's axes, 255ths");
  scene.Renderer->SetEnvironmentUp(0., 1., 0.);
  scene.Environment->SetIntensity(0.5);
  RELIEVO_CHECK_AT_MOST(
    scene.Worst([](const glm::dvec3& d) { return 0.5 * Smooth(d); }), 1., "half the light, 255ths");
  scene.Environment->GammaCorrectOn();
  RELIEVO_CHECK_AT_MOST(scene.Worst([](const glm::dvec3& d) {
    return glm::pow(0.5 * Smooth(d), glm::dvec3(1. / 2.2));
  }),
    1.5, "encoded, 255ths");
}

// Few texels, of unequal light, magnified: the change from pixel to pixel is less than a 255th,
// except at a seam.
void TestSeams()
{
  auto image = MakeEnvironment(
    [](const glm::dvec3& d) {
      const double noise = std::sin(317. * d.x + 211. * d.y + 97. * d.z);
      return glm::dvec3(0.5 + 0.15 * noise, 0.5 - 0.15 * noise, 0.5);
    },
    Cube, 4);
  relievoTest::Stage stage(161, 161);
  vtkNew<vtkRelievoEnvironment> environment;
  environment->SetImage(image);
  vtkNew<vtkRelievoSkybox> sky;
  sky->SetEnvironment(environment);
  stage.Renderer->AddViewProp(sky);
  GLCheck watch(stage.Window);
  int ramps = 0;
  for (int corner = 0; corner < 27; ++corner)
  {
    // The middle pixel's ray is exactly on an edge or a corner.
    const glm::dvec3 to(corner % 3 - 1., corner / 3 % 3 - 1., corner / 9 - 1.);
    if (glm::dot(to, to) < 1.5)
    {
      continue;
    }
    LookAlong(stage.Renderer, glm::dvec3(0.), to, 10.);
    const Photo photo(stage.Window);
    int step = 0;
    int least = 255;
    int most = 0;
    for (int y = 1; y < photo.Height; ++y)
    {
      for (int x = 1; x < photo.Width; ++x)
      {
        const std::size_t at = 3 * (static_cast<std::size_t>(y) * photo.Width + x);
        const std::size_t below = at - 3 * static_cast<std::size_t>(photo.Width);
        step = std::max({ step, std::abs(photo.Bytes[at] - photo.Bytes[at - 3]),
          std::abs(photo.Bytes[at] - photo.Bytes[below]) });
        least = std::min<int>(least, photo.Bytes[at]);
        most = std::max<int>(most, photo.Bytes[at]);
      }
    }
    ramps += most - least > 3 ? 1 : 0;
    RELIEVO_CHECK_AT_MOST(step, 1., "a pixel to the next about an edge or corner, 255ths");
  }
  RELIEVO_CHECK_THAT(ramps > 10, "the edges' sides differ: " + std::to_string(ramps));
}

void TestKeeps()
{
  Scene scene(Smooth, Cube, 32);
  vtkRenderer* renderer = scene.Renderer;
  AddActor(renderer, MakeBall(0.8));
  const Photo with(scene.Stage.Window);
  scene.Sky->VisibilityOff();
  const Photo without(scene.Stage.Window);
  const Layers bare(renderer, { "depth", "normal", "actor" });
  scene.Sky->VisibilityOn();
  const Layers layers(renderer, { "depth", "normal", "actor" });
  int surface = 0;
  int differ = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const bool seen = std::isfinite(bare.Value("depth", x, y));
      surface += seen ? 1 : 0;
      const double a = layers.Value("depth", x, y);
      const double b = bare.Value("depth", x, y);
      differ += (seen ? a != b : std::isfinite(a)) ||
          (layers.Value("actor", x, y) < 0.) != (bare.Value("actor", x, y) < 0.) ||
          (seen && with.At(x, y) != without.At(x, y))
        ? 1
        : 0;
    }
  }
  RELIEVO_CHECK(surface > 500);
  RELIEVO_CHECK_THAT(differ == 0, "layers and surfaces stay: " + std::to_string(differ));
  vtkRelievoPass* frame = vtkRelievoPass::Attach(renderer);
  frame->ShadowsOn();
  const Photo shadowed(scene.Stage.Window);
  RELIEVO_CHECK_THAT(shadowed.At(1, 1) == with.At(1, 1), "in a frame with shadows");
  vtkRelievoPass::Detach(renderer);

  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  RELIEVO_CHECK_AT_MOST(bounds[1], 0.81, "the scene's bounds");
  RELIEVO_CHECK(scene.Environment->GetBytesHeld() > 6 * 32 * 32 * 3 * 2);
  RELIEVO_CHECK(scene.Environment->GetBytesHeld() <= 6 * 32 * 32 * 3 * 2 * 4 / 3);
  scene.Sky->ReleaseGraphicsResources(scene.Stage.Window);
  RELIEVO_CHECK(scene.Environment->GetBytesHeld() == 0);
  RELIEVO_CHECK_THAT(Photo(scene.Stage.Window).Bytes == with.Bytes, "again after a release");

  // One environment in two windows, with a sky for each.
  relievoTest::Stage other(160, 120);
  vtkNew<vtkRelievoSkybox> sky;
  sky->SetEnvironment(scene.Environment);
  other.Renderer->AddViewProp(sky);
  AddActor(other.Renderer, MakeBall(0.8));
  RELIEVO_CHECK_THAT(Photo(other.Window).Bytes == with.Bytes, "another window");
  RELIEVO_CHECK_THAT(Photo(scene.Stage.Window).Bytes == with.Bytes, "and the first one again");
}
}

RELIEVO_TEST_CASE(testSkybox)
{
  relievoTest::Session session;
  TestSides();
  TestProjections();
  TestViews();
  TestParallel();
  TestTiles();
  TestTurns();
  TestSeams();
  TestKeeps();
  return session.Result();
}
}
