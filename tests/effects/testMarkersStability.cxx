// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Markers where they could fail: data that marks nothing, eyes in markers, sizes and places far
// apart, wires, small and several viewports; and that switched off, or without data, they leave no
// trace.
#include "Check.h"
#include "GLCheck.h"
#include "MarkerScene.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkCamera.h>
#include <vtkPolyData.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace testMarkersStability
{
namespace
{
using namespace relievoTest;
using M = vtkRelievoMarkers;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Limit = 5e-5;
const Mark Good{ { 0.8, 0., 0.9 }, 0.7 };

Mark With(double Mark::*value, double number)
{
  Mark mark = Good;
  mark.*value = number;
  return mark;
}

void CheckAgainstTruth(MarkerScene& scene, const std::string& what, double limit = Limit)
{
  const MarkerErrors errors = scene.Compare();
  RELIEVO_CHECK_AT_MOST(errors.Covered, limit, what + ": what is covered");
  RELIEVO_CHECK_AT_MOST(errors.Picture, PictureLimit, what + ": levels of 255");
}

void TestData()
{
  MarkerScene scene(60, 45);
  const auto plain = Picture(scene.Window);
  RELIEVO_CHECK(scene.Stage->GetReasonCode() == "idle" && scene.Frame->GetBytesHeld() == 0);
  scene.Set(M::RING, { Good });
  const Layers expected = scene.Read({ "marker", "color" });
  Mark nowhere = Good;
  nowhere.Center.x = NaN;
  Mark away = Good;
  away.Center.y = Infinity;
  Mark colorless = Good;
  colorless.Color.y = NaN;
  Mark negative = Good;
  negative.Color.z = -0.1;
  Mark far = Good;
  far.Center.x = 1e300;
  scene.Set(M::RING,
    { nowhere, away, far, colorless, negative, With(&Mark::Radius, 0.), With(&Mark::Radius, -1.),
      With(&Mark::Radius, NaN), With(&Mark::Radius, Infinity), With(&Mark::Width, 0.),
      With(&Mark::Width, -0.5), With(&Mark::Opacity, 0.), With(&Mark::Opacity, -1.), Good });
  CheckSame(expected, scene, "marker");
  RELIEVO_CHECK(scene.Markers->GetNumberLeftOut() == 12 && scene.Stage->GetNumberDrawn() == 1);
  scene.Set(M::SHADOW, { With(&Mark::Reach, 0.), With(&Mark::Reach, -1.), With(&Mark::Width, 0.) });
  scene.Window->Render();
  RELIEVO_CHECK(scene.Markers->GetNumberLeftOut() == 2 && scene.Stage->GetNumberDrawn() == 1);
  scene.Set(M::RING, { With(&Mark::Width, 7.), With(&Mark::Opacity, 5.) });
  scene.Window->Render();
  RELIEVO_CHECK(scene.Stage->GetNumberDrawn() == 2);

  // None at all: nothing is held, and the picture is VTK's own.
  scene.Set(M::RING, { With(&Mark::Radius, 0.) });
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "only one without a radius"));
  scene.Set(M::RING, {});
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "no points"));
  scene.Markers->SetInputData(vtkNew<vtkPolyData>());
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "empty polydata"));
  scene.Markers->SetInputData(nullptr);
  scene.Markers->AddActor(vtkNew<vtkActor>());
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "an actor of nothing"));
  scene.Markers->RemoveAllActors();
  scene.Stage->RemoveAllPoints();
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "no markers"));
  RELIEVO_CHECK(scene.Stage->GetBytesHeld() == 0 && scene.Frame->GetBytesHeld() == 0);

  // Blocks, and one value for all.
  CheckBlocks(scene, scene.Stage, scene.Markers, MakeMarkerPoints({ Good }),
    MakeMarkerPoints({ With(&Mark::Radius, -1.) }), expected, "marker");
  scene.Markers->SetRadius(Good.Radius);
  CheckSame(expected, scene, "marker");
}

void TestArrays()
{
  MarkerScene scene(60, 45);
  const vtkSmartPointer<vtkPolyData> points = MakeMarkerPoints({ Good });
  CheckWrongArrays(scene, scene.Markers, points,
    { { "radius", "size", "not among the point arrays" },
      { "width", "pairs", "has 2 components; needed: one number per point" },
      { "reach", "words", "holds no numbers" },
      { "opacity", "pairs", "needed: one number per point" },
      { "color", "reach", "has 1 components; needed: red, green and blue" } });
  {
    ExpectMessage expect("one of radius, width, reach, opacity, color");
    scene.Markers->SetArray("colour", "radius");
  }
  ExpectMessage expect("expected a non-zero direction");
  scene.Markers->SetUp(0., 0., 0.);
  scene.Markers->SetUp(NaN, 0., 1.);
  RELIEVO_CHECK(expect.Count() == 2 && scene.Markers->GetUp()[1] == 1.);
}

void TestEyes()
{
  MarkerScene scene(61, 45);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double* at = camera->GetPosition();
  const glm::dvec3 eye(at[0], at[1], at[2]);
  GLCheck gl(scene.Window);
  for (int shape = M::RING; shape <= M::SHADOW; ++shape)
  {
    const std::string name = std::to_string(shape);
    scene.Set(shape, { { eye, 3.5, 0.5 } });
    CheckAgainstTruth(scene, name + ": eye at the centre");
    scene.Set(shape, { { eye + glm::dvec3(0., 0., 1.5), 4., 0.5 } });
    CheckAgainstTruth(scene, name + ": eye within, the centre behind");
    scene.Set(shape, { { eye + glm::dvec3(0., 0., -3.), 3., 0.5 } });
    CheckAgainstTruth(scene, name + ": eye on the sphere");
    scene.Set(shape, { { { 0., 0.5, 0. }, 1e3, 0.9, 4., 0.5 } });
    CheckAgainstTruth(scene, name + ": radius 1000");
    scene.Set(shape, { { { 0.8, 0., 0.9 }, 1e-9 }, { { 1e9, 0., 0. }, 1. }, Good });
    CheckAgainstTruth(scene, name + ": hardly any");
  }
  scene.Set(M::DISC, { { { 1., 2., 3. }, 1e9, 0.1, 4., 0.5 } });
  CheckAgainstTruth(scene, "radius 1e9");
  camera->SetClippingRange(1e-6, 10.);
  scene.Set(M::RING, { Good });
  CheckAgainstTruth(scene, "far / near 1e7");
}

void TestPlaces()
{
  // Coordinates have steps of 2e-9 there.
  MarkerScene far(60, 45, glm::dvec3(1e7, -1e7, 1e7));
  GLCheck gl(far.Window);
  for (int shape = M::RING; shape <= M::SHADOW; ++shape)
  {
    far.Set(shape, { Good });
    CheckAgainstTruth(far, "at 1e7");
  }
  MarkerScene small(1, 3);
  small.Set(M::DISC, { { { 0., 0.5, 0.2 }, 1. } });
  CheckAgainstTruth(small, "1 x 3 pixels");
  MarkerScene one(1, 1);
  one.Set(M::RING, { { { 0., 0.5, 0.2 }, 1., 1. } });
  CheckAgainstTruth(one, "one pixel");
  RELIEVO_CHECK(one.Stage->GetNumberDrawn() == 1);

  // Two viewports of a window: each has its own, in its own pixels.
  MarkerScene alone(60, 45);
  alone.Set(M::RING, { Good });
  MarkerScene both(120, 45);
  both.Renderer->SetViewport(0.5, 0., 1., 1.);
  both.Set(M::RING, { Good });
  vtkNew<vtkRenderer> other;
  other->SetViewport(0., 0., 0.5, 1.);
  both.Window->AddRenderer(other);
  const Layers beside = both.Read({ "marker" });
  RELIEVO_CHECK(beside.Width == 60);
  RELIEVO_CHECK_AT_MOST(
    LargestDifference(alone.Read({ "marker" }), beside, "marker"), Limit, "two viewports");
  CheckBeside(alone, both, { 30, 40, 50 }, 12);
}

// Things of one pixel's width before something far away are marked as anything else.
void TestWires()
{
  MarkerScene scene(61, 61);
  scene.Ball->VisibilityOff();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0., 1., 6.);
  camera->SetFocalPoint(0., 1., 0.);
  const double pixel = 2. * 5. * std::tan(25. * 3.14159265358979 / 180.) / 61.;
  auto wire = AddActor(scene.Renderer, MakeBox(1.2 * pixel, 2., 0.01));
  wire->SetPosition(0., 1., 1.);
  scene.Set(M::DISC, { { { 0., 1., 1. }, 0.5, 1., 4., 1. } });
  const Layers layers = scene.Read({ "marker", "depth" });
  RELIEVO_CHECK(std::abs(layers.Value("depth", 30, 30) - 5.) < 0.01);
  RELIEVO_CHECK(layers.Value("depth", 28, 30) > 6. && layers.Value("depth", 32, 30) > 6.);
  RELIEVO_CHECK_AT_MOST(1. - layers.Value("marker", 30, 30), 1e-6, "on the wire");
  RELIEVO_CHECK_AT_MOST(layers.Value("marker", 28, 30), 0., "behind the wire");
  CheckAgainstTruth(scene, "wires");
}

void TestToggles()
{
  MarkerScene scene(60, 45);
  scene.Stage->EnabledOff();
  const auto plain = Picture(scene.Window);
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
  scene.Stage->EnabledOn();
  scene.Set(M::RING, { Good });
  const auto marked = Picture(scene.Window);
  const vtkIdType held = scene.Frame->GetBytesHeld();
  RELIEVO_CHECK(scene.Stage->GetBytesHeld() == 60 * 45 * 16 + 144);
  RELIEVO_CHECK(scene.Stage->GetDrawCalls() == 2);
  CheckToggles(scene, scene.Stage, marked);
  scene.Set(M::SHADOW, { Good });
  scene.Window->Render();
  scene.Set(M::RING, { Good });
  RELIEVO_CHECK(SamePicture(marked, Picture(scene.Window), "after a shadow"));
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == held);
  scene.Stage->EnabledOff();
  RELIEVO_CHECK(SamePicture(plain, Picture(scene.Window), "off"));
  RELIEVO_CHECK(scene.Frame->GetBytesHeld() == 0);
}

void TestRequests()
{
  MarkerScene scene(60, 45);
  scene.Set(M::DISC, { { { 100., 0., 0. }, 1. } });
  const Layers none = scene.Read({ "marker" });
  RELIEVO_CHECK(none.Value("marker", 30, 22) == 0. && scene.Stage->GetNumberDrawn() == 0);
  RELIEVO_CHECK(scene.Stage->GetDrawCalls() == 0);

  // The layer shown as the picture: white is all.
  scene.Set(M::DISC, { Good });
  scene.Frame->SetDisplayLayer("marker");
  const Layers layers = scene.Read({ "marker" });
  const auto shown = Picture(scene.Window);
  RELIEVO_CHECK(layers.Value("marker", 40, 12) > 0.7);
  RELIEVO_CHECK_NEAR(shown->GetScalarComponentAsDouble(40, 12, 0, 1),
    255. * layers.Value("marker", 40, 12), 1., "shown as grey");
  scene.Frame->SetDisplayLayer(nullptr);

  // Without any markers nothing is covered; a stage that is off makes no layer.
  scene.Stage->RemoveAllPoints();
  const Layers without = scene.Read({ "marker" });
  RELIEVO_CHECK(without.Value("marker", 40, 12) == 0.);
  CheckOff(scene, "markers", "marker");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testMarkersStability)
{
  Session session;
  TestData();
  TestArrays();
  TestEyes();
  TestPlaces();
  TestWires();
  TestToggles();
  TestRequests();
  return session.Result();
}
}
