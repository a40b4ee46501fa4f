// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoMarkersStage: the coverage of each pixel against the same formula in double, in every
// projection; against the area of the pixel within the radius, on a plane; and the picture against
// color (1 - a) + marker a in linear light.
#include "Check.h"
#include "FogTruth.h"
#include "GLCheck.h"
#include "MarkerScene.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRelievoFogSpheres.h>
#include <vtkRelievoFogStage.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace testMarkersStage
{
namespace
{
using namespace relievoTest;
using M = vtkRelievoMarkers;

constexpr double Limit = 5e-5; // of the coverage: depths and their slopes are floats
const char* const ShapeNames[] = { "ring", "glow", "disc", "shadow" };

// On the floor, the wall and the ball, before the ball, around the eye, behind it, and in the sky.
std::vector<Mark> SomeMarks()
{
  return { { { 0.8, 0., 0.9 }, 0.7 }, { { -0.9, 1.1, -1.4 }, 0.8, 0.5, 4., 1., { 0., 1., 0.3 } },
    { { 0.1, 0.6, 0.4 }, 0.4, 0.1, 3., 0.5, { 0.2, 0.4, 1. } },
    { { -1., 0.4, 1. }, 0.9, 1., 2., 0.9 }, { { 0.3, 1.6, 4.5 }, 3.5, 0.05, 2., 0.6 },
    { { 0., 0.5, 9. }, 2. }, { { 1.8, 2., 0. }, 0.3 }, { { 1.5, 0.01, -0.5 }, 0.012, 0.5 } };
}

void Check(MarkerScene& scene, const std::string& what, int least, double limit = Limit)
{
  const MarkerErrors errors = scene.Compare();
  RELIEVO_CHECK_AT_MOST(errors.Covered, limit, what + ": what is covered");
  RELIEVO_CHECK_AT_MOST(errors.Picture, PictureLimit, what + ": levels of 255 of the picture");
  RELIEVO_CHECK_THAT(errors.Marked > least,
    what + ": marked " + std::to_string(errors.Marked) + ", edges " + std::to_string(errors.Edges));
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "ran");
}

void TestLayer()
{
  std::vector<Look> looks = PlainLooks;
  looks.push_back({ "sheared, off-centre", [](vtkCamera* camera) {
                     camera->SetWindowCenter(0.3, -0.2);
                     camera->SetViewShear(0.2, -0.1, 1.1);
                   } });
  for (const Look& look : looks)
  {
    MarkerScene scene(121, 91);
    look.Set(scene.Renderer->GetActiveCamera());
    GLCheck gl(scene.Window);
    for (int shape = M::RING; shape <= M::SHADOW; ++shape)
    {
      scene.Set(shape, SomeMarks());
      Check(scene, std::string(look.Name) + ", " + ShapeNames[shape], 600);
    }
    scene.Markers->SetUp(0.5, 2., 0.3);
    Check(scene, std::string(look.Name) + ", shadow from aside", 600);
  }
  // The comparison detects deviations from the scene.
  MarkerScene scene(60, 45);
  scene.Set(M::RING, SomeMarks());
  scene.Markers->SetArray("radius", "");
  scene.Markers->SetRadius(0.5);
  RELIEVO_CHECK(scene.Compare().Covered > 0.5);
  scene.Markers->SetArray("color", "");
  scene.Markers->SetColor(0., 0., 1.);
  RELIEVO_CHECK(scene.Compare().Picture > 20.);
}

// The most that is covered of an actor's pixels.
double LargestOn(MarkerScene& scene, int actor)
{
  const Layers layers = scene.Read({ "actor", "marker" });
  double largest = 0.;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const bool on = layers.Id("actor", x, y) == actor;
      largest = on ? std::max(largest, layers.Value("marker", x, y)) : largest;
    }
  }
  RELIEVO_CHECK(layers.CountId("actor", actor) > 100);
  return largest;
}

// Boxes around actors, which are followed as they turn, stretch, move and hide.
void TestActors()
{
  MarkerScene scene(121, 91);
  GLCheck gl(scene.Window);
  vtkNew<vtkTransform> more;
  more->RotateY(70.);
  more->Scale(1.3, 1.3, 1.3);
  for (int step = 0; step < 3; ++step)
  {
    for (int shape = M::RING; shape <= M::SHADOW; ++shape)
    {
      Mark ball{ {}, 0.3, 0.3, 3. };
      ball.Actor = scene.Ball;
      Mark wall = ball;
      wall.Actor = scene.Wall;
      scene.Set(shape, { ball, wall });
      Check(
        scene, "step " + std::to_string(step) + ", " + ShapeNames[shape] + " around actors", 50);
      scene.Markers->SetInputData(nullptr);
    }
    scene.Ball->RotateZ(20.);
    scene.Ball->RotateX(35.);
    scene.Ball->AddPosition(0.4, 0.5, 0.5);
    scene.Ball->SetUserMatrix(more->GetMatrix());
    scene.Wall->SetScale(0.6, 0.9, 3.);
  }
  // A shadow of no more than the box itself; on the ball, which throws it, there is none.
  Mark ball{ {}, 0., 0.3, 3., 1. };
  ball.Actor = scene.Ball;
  scene.Set(M::SHADOW, { ball });
  Check(scene, "shadow without a radius", 100);
  RELIEVO_CHECK_AT_MOST(LargestOn(scene, 1), 0., "on what throws it");
  // Flat objects on edge still cast a small shadow.
  vtkNew<vtkRenderer> elsewhere;
  auto sheet = AddActor(elsewhere, MakeSquare());
  sheet->SetPosition(0.8, 1.2, 0.9);
  sheet->RotateY(33.);
  ball.Actor = sheet;
  scene.Set(M::SHADOW, { ball });
  Check(scene, "shadow of a sheet", 3);
  ball.Actor = scene.Ball;

  // A sheared actor has the box along the world's axes.
  Mark wall{ {}, 0.4, 1., 3., 1. };
  wall.Actor = scene.Wall;
  more->Identity();
  more->Scale(1., 1., 3.);
  scene.Wall->SetUserMatrix(more->GetMatrix());
  scene.Set(M::DISC, { wall });
  const Layers found = scene.Read({ "marker" });
  RELIEVO_CHECK(scene.Stage->GetNumberDrawn() == 1);
  auto same = AddActor(elsewhere, MakeBox(1., 1., 1.));
  const double* b = scene.Wall->GetBounds();
  same->SetScale(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  same->SetPosition((b[0] + b[1]) / 2., (b[2] + b[3]) / 2., (b[4] + b[5]) / 2.);
  scene.Markers->RemoveAllActors();
  scene.Markers->AddActor(same);
  RELIEVO_CHECK_AT_MOST(LargestDifference(found, scene.Read({ "marker" }), "marker"), Limit,
    "the box of a sheared actor");

  scene.Set(M::SHADOW, { ball });
  scene.Window->Render();
  const int drawn = scene.Stage->GetNumberDrawn();
  scene.Ball->VisibilityOff();
  scene.Window->Render();
  RELIEVO_CHECK(drawn == 1 && scene.Stage->GetNumberDrawn() == 0);
}

// The shadow of a point with a ball around it is on the floor, not on the ball.
void TestBall()
{
  MarkerScene scene(121, 91);
  scene.Set(M::SHADOW, { { { 0., 0.5, 0. }, 0.6, 1., 4., 1. } });
  RELIEVO_CHECK_AT_MOST(LargestOn(scene, 1), 0.02, "on the ball");
  const Layers layers = scene.Read({ "marker", "actor" });
  double largest = 0.;
  for (int i = 0; i < 121 * 91; ++i)
  {
    largest = std::max(largest, layers.Value("marker", i % 121, i / 121));
  }
  // (1 - height / 4 radii), a little beside the axis.
  RELIEVO_CHECK(largest > 0.5 && largest < 1. - 0.5 / 2.4);
}

// A pixel's coverage on a plane is its area within the marker, to a filter's difference; also for
// rings thinner than a pixel, and seen at an angle.
void TestArea()
{
  const struct
  {
    const char* Name;
    int Shape;
    Mark Given;
    double Angle; // degrees from the plane
    double Most, Mean;
    glm::dvec3 Box = glm::dvec3(0.); // around the centre
  } cases[] = {
    { "disc from above", M::DISC, { { 0.013, 0., 0.021 }, 1., 0.2, 4., 1. }, 90., 0.06, 1e-3 },
    { "ring from above", M::RING, { { 0.013, 0., 0.021 }, 1., 0.3, 4., 1. }, 90., 0.06, 1e-3 },
    { "thin ring", M::RING, { { 0.013, 0., 0.021 }, 1., 0.01, 4., 1. }, 90., 0.1, 1e-3 },
    { "ring at 20 degrees", M::RING, { { 0.013, 0., 0.021 }, 1.2, 0.3, 4., 1. }, 20., 0.07, 1e-3 },
    { "disc at 5 degrees", M::DISC, { { 0.013, 0., 0.021 }, 1.2, 0.3, 4., 1. }, 5., 0.2, 1e-3 },
    // A pixel shows 0.028.
    { "disc of a fifth of a pixel", M::DISC, { { 0.013, 0., 0.021 }, 0.003, 0.3, 4., 1. }, 90.,
      0.02, 5e-6 },
    { "disc of half a pixel", M::DISC, { { 0.013, 0., 0.021 }, 0.007, 0.3, 4., 1. }, 90., 0.06,
      2e-5 },
    { "disc of a pixel", M::DISC, { { 0.013, 0., 0.021 }, 0.014, 0.3, 4., 1. }, 90., 0.08, 4e-5 },
    { "disc of half a pixel at 20 degrees", M::DISC, { { 0.013, 0., 0.021 }, 0.007, 0.3, 4., 1. },
      20., 0.1, 3e-5 },
    { "ring of a pixel", M::RING, { { 0.013, 0., 0.021 }, 0.014, 0.3, 4., 1. }, 90., 0.08, 4e-5 },
    { "box", M::DISC, { { 0.013, 0., 0.021 }, 0.3, 0.3, 4., 1. }, 90., 0.06, 1e-3,
      { 0.9, 0.2, 0.4 } },
    { "rod thinner than a pixel", M::DISC, { { 0.013, 0., 0.021 }, 0.004, 0.3, 4., 1. }, 90., 0.08,
      1e-4, { 0.8, 0.0005, 0.0005 } },
    { "rod thinner than a pixel, as a ring", M::RING, { { 0.013, 0., 0.021 }, 0.012, 0.5, 4., 1. },
      90., 0.1, 4e-4, { 0.002, 0.002, 0.8 } },
  };
  for (const auto& each : cases)
  {
    MarkerScene scene(100, 75);
    scene.Ball->VisibilityOff();
    scene.Wall->VisibilityOff();
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    const double angle = each.Angle * 3.14159265358979 / 180.;
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetPosition(0., 4. * std::sin(angle), 4. * std::cos(angle));
    camera->SetViewUp(0., std::cos(angle), -std::sin(angle));
    Mark mark = each.Given;
    vtkNew<vtkRenderer> elsewhere;
    const auto box = AddActor(elsewhere, MakeBox(each.Box.x, each.Box.y, each.Box.z));
    box->SetPosition(mark.Center.x, mark.Center.y, mark.Center.z);
    mark.Actor = each.Box.x > 0. ? box.Get() : nullptr;
    scene.Set(each.Shape, { mark });
    const Layers layers = scene.Read({ "marker", "depth" });
    vtkRelievoFrameCamera view;
    view.Take(scene.Renderer, nullptr);
    const glm::dmat4 toWorld = glm::inverse(view.WorldToView);
    const double inner = each.Shape == M::RING ? each.Given.Radius * (1. - each.Given.Width) : -1.;
    constexpr int Samples = 16;
    double most = 0.;
    double sum = 0.;
    double areas = 0.;
    for (int y = 0; y < layers.Height; ++y)
    {
      for (int x = 0; x < layers.Width; ++x)
      {
        int inside = 0;
        for (int i = 0; i < Samples * Samples; ++i)
        {
          const double px = x + (i % Samples + 0.5) / Samples;
          const double py = y + (i / Samples + 0.5) / Samples; // NOLINT: rows
          const glm::dvec3 eye(toWorld[3]);
          const glm::dvec3 ahead(toWorld * glm::dvec4(glm::dvec3(PointAt(view, px, py, 1.L)), 1.));
          const glm::dvec3 point = eye + (ahead - eye) * (eye.y / (eye.y - ahead.y));
          const glm::dvec3 from = glm::abs(point - mark.Center) - each.Box / 2.;
          const double range = glm::length(glm::max(from, glm::dvec3(0.)));
          const bool onFloor = std::abs(point.x) < 3. && std::abs(point.z) < 3. && ahead.y < eye.y;
          inside += onFloor && range < each.Given.Radius && range >= inner ? 1 : 0;
        }
        const double area = inside / static_cast<double>(Samples * Samples);
        const double error = std::abs(area - layers.Value("marker", x, y));
        most = std::max(most, error);
        sum += error;
        areas += area;
      }
    }
    RELIEVO_CHECK_AT_MOST(most, each.Most, std::string(each.Name) + ": largest error of the area");
    RELIEVO_CHECK_AT_MOST(
      sum / (layers.Width * layers.Height), each.Mean, std::string(each.Name) + ": mean error");
    RELIEVO_CHECK(areas > 0.01);
  }
}

// From as far as 10 000 radii as well as from near by.
void TestFar()
{
  for (const double distance : { 100., 1e4 })
  {
    MarkerScene scene(120, 90);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(0.3 * distance, 0.3 * distance, 0.9 * distance);
    camera->SetFocalPoint(0., 0.4, 0.);
    camera->SetClippingRange(0.5 * distance, 2. * distance);
    camera->SetViewAngle(170. / distance);
    for (const int shape : { M::RING, M::GLOW })
    {
      scene.Set(shape, { { { 0.3, 0.1, 0.5 }, 0.9 }, { { -0.7, 1.1, -1.4 }, 0.5 } });
      // One step of the depth there is 5e-4: a hundredth of a pixel, in which slopes are measured.
      Check(scene, "from " + std::to_string(distance), 500, distance > 1e3 ? 2e-3 : Limit);
    }
  }
}

// Later sets and points lie over earlier ones; shadows below all.
void TestOrder()
{
  MarkerScene scene(60, 45);
  const Mark red{ { 0.8, 0., 0.9 }, 0.5, 1., 4., 1., { 1., 0., 0. } };
  const Mark blue{ { 0.9, 0., 0.9 }, 0.5, 1., 4., 1., { 0., 0., 1. } };
  scene.Set(M::DISC, { red, blue });
  const auto blueOver = Picture(scene.Window);
  scene.Set(M::DISC, { blue, red });
  const auto redOver = Picture(scene.Window);
  RELIEVO_CHECK(FailuresOf([&]() { RELIEVO_CHECK(SamePicture(blueOver, redOver, "orders")); }) > 0);
  scene.Set(M::DISC, { red });
  vtkNew<M> other;
  other->SetInputData(MakeMarkerPoints({ blue }));
  other->SetShapeToDisc();
  scene.Stage->AddPoints(other);
  RELIEVO_CHECK(SamePicture(blueOver, Picture(scene.Window), "in two sets"));
  scene.Stage->RemovePoints(scene.Markers);
  scene.Stage->AddPoints(scene.Markers);
  RELIEVO_CHECK(SamePicture(redOver, Picture(scene.Window), "the first set added again"));
  vtkNew<M> shadow;
  shadow->SetShapeToShadow();
  shadow->SetInputData(MakeMarkerPoints({ { { 0.85, 0.2, 0.9 }, 0.4, 1., 4., 1. } }));
  scene.Stage->AddPoints(shadow);
  scene.Stage->RemovePoints(other);
  scene.Stage->RemovePoints(scene.Markers);
  scene.Stage->AddPoints(other);
  scene.Stage->AddPoints(scene.Markers);
  RELIEVO_CHECK(SamePicture(redOver, Picture(scene.Window), "the shadow is below"));
  RELIEVO_CHECK(scene.Stage->GetNumberDrawn() == 3);

  // Fog lies over them: the visible share of a marker, plus the fog's own light.
  scene.Stage->RemoveAllPoints();
  scene.Stage->AddPoints(scene.Markers);
  scene.Set(M::DISC, { { { 0., 0., 0. }, 50., 1., 4., 1., { 1., 0., 0. } } });
  vtkNew<vtkRelievoFogSpheres> fog;
  fog->SetInputData(MakeMarkerPoints({ {} }));
  fog->SetArray("radius", "");
  fog->SetArray("color", "");
  fog->SetRadius(50.);
  fog->SetDensity(0.2);
  fog->SetColor(0., 0., 1.);
  scene.Frame->GetFogStage()->AddPoints(fog);
  const Layers layers = scene.Read({ "color", "fog" });
  const double passes = layers.Value("fog", 30, 15);
  RELIEVO_CHECK(passes > 0.2 && passes < 0.8);
  RELIEVO_CHECK_NEAR(layers.Value("color", 30, 15, 0), passes, 2e-3, "the marker behind fog");
  RELIEVO_CHECK_NEAR(layers.Value("color", 30, 15, 2), 1. - passes, 2e-3, "fog over the marker");

  // And so does glass: a green ball that covers half of a red disc.
  scene.Frame->GetFogStage()->RemovePoints(fog);
  scene.Ball->GetProperty()->SetOpacity(0.5);
  scene.Ball->GetProperty()->SetColor(0., 1., 0.);
  scene.Ball->GetProperty()->LightingOff();
  scene.Ball->GetProperty()->BackfaceCullingOn();
  const Layers glass = scene.Read({ "color", "blend", "marker" });
  int seen = 0;
  for (int y = 0; y < glass.Height; ++y)
  {
    for (int x = 0; x < glass.Width; ++x)
    {
      if (std::abs(glass.Value("blend", x, y, 3) - 0.5) < 1e-2 && glass.Value("marker", x, y) == 1.)
      {
        ++seen;
        RELIEVO_CHECK(std::abs(glass.Value("color", x, y, 0) - 0.5) < 1e-2);
        RELIEVO_CHECK(std::abs(glass.Value("color", x, y, 1) - 0.5) < 1e-2);
      }
    }
  }
  RELIEVO_CHECK(seen > 20);
}

// Depths belong to the centres of pixels, whatever the multisampling.
void TestSamples()
{
  MarkerScene scene(60, 45);
  scene.Set(M::RING, SomeMarks());
  const Layers one = scene.Read({ "marker" });
  scene.Window->SetMultiSamples(8);
  const MarkerErrors errors = scene.Compare();
  RELIEVO_CHECK_AT_MOST(errors.Covered, Limit, "8 samples: what is covered");
  RELIEVO_CHECK_AT_MOST(errors.Picture, 2.01, "8 samples: levels of 255");
  const Layers eight = scene.Read({ "marker" });
  RELIEVO_CHECK_AT_MOST(LargestDifference(one, eight, "marker"), Limit, "8 samples and one");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testMarkersStage)
{
  Session session;
  TestLayer();
  TestActors();
  TestBall();
  TestArea();
  TestFar();
  TestOrder();
  TestSamples();
  return session.Result();
}
}
