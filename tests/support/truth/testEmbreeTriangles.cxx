// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cell and actor that a ray hits, in which order, and the drawn size of its triangle.
#include "Check.h"
#include "EmbreeScene.h"
#include "ScreenTriangle.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace testEmbreeTriangles
{
namespace
{
using relievoTest::EmbreeScene;
using relievoTest::MakeBox;
using relievoTest::MakePolygons;
using relievoTest::PixelTruth;
using relievoTest::Ray;
using relievoTest::Stage;
using relievoTest::SurfacePoint;
using relievoTest::TruthImage;
using relievoTest::View;

// The cell of a triangle, for all kinds of cells.
void TestCells()
{
  // A vertex, a line, then a pentagon, a quad, and a strip of three triangles.
  const auto mesh = MakePolygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 1.5, 1, 0 }, { 0.5, 2, 0 },
    { -0.5, 1, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 4, 1, 0 }, { 3, 1, 0 }, { 5, 0, 0 }, { 5, 1, 0 },
    { 6, 0, 0 }, { 6, 1, 0 }, { 7, 0, 0 } });
  mesh->SetVerts(vtkNew<vtkCellArray>());
  mesh->GetVerts()->InsertNextCell({ 0 });
  mesh->SetLines(vtkNew<vtkCellArray>());
  mesh->GetLines()->InsertNextCell({ 0, 1 });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3, 4 });
  mesh->GetPolys()->InsertNextCell({ 5, 6, 7, 8 });
  mesh->SetStrips(vtkNew<vtkCellArray>());
  mesh->GetStrips()->InsertNextCell({ 9, 11, 10, 12 });
  mesh->GetStrips()->InsertNextCell({ 11, 13, 12 });
  EmbreeScene scene;
  RELIEVO_CHECK(scene.AddActor(mesh) == 0);
  RELIEVO_CHECK(scene.NumberOfTriangles() == 3 + 2 + 2 + 1);

  const auto cast = [&](double x, double y) {
    return scene.Cast(Ray{ { x, y, 5. }, { 0., 0., -1. } }, 0., 100.);
  };
  RELIEVO_CHECK(cast(0.5, 0.5).Cell == 2 && cast(-0.3, 1.).Cell == 2 && cast(1.4, 1.).Cell == 2);
  RELIEVO_CHECK(cast(3.9, 0.5).Cell == 3 && cast(3.1, 0.9).Cell == 3);
  RELIEVO_CHECK(cast(5.1, 0.2).Cell == 4 && cast(5.9, 0.8).Cell == 4 && cast(6.2, 0.1).Cell == 5);
  RELIEVO_CHECK(!cast(2.5, 0.5).Hit && cast(2.5, 0.5).Cell == -1);
  // All were made counter-clockwise as seen from +z; from behind, their back is visible.
  for (const double x : { 0.5, 3.5, 5.1, 5.9, 6.2 })
  {
    RELIEVO_CHECK(cast(x, 0.3).FrontFacing);
    const SurfacePoint back = scene.Cast(Ray{ { x, 0.3, -5. }, { 0., 0., 1. } }, 0., 100.);
    RELIEVO_CHECK(back.Hit && !back.FrontFacing && back.Normal.z == -1.);
  }

  const SurfacePoint point = cast(3.25, 0.125);
  const auto ids = scene.PointIds(point.Triangle);
  const auto corners = scene.Corners(point.Triangle);
  const glm::dvec3 weights = scene.Weights(point.Triangle, point.Position);
  glm::dvec3 sum(0.);
  for (int i = 0; i < 3; ++i)
  {
    double p[3];
    mesh->GetPoint(ids[i], p);
    RELIEVO_CHECK(corners[i] == glm::dvec3(p[0], p[1], p[2]));
    RELIEVO_CHECK(weights[i] >= 0.);
    sum += weights[i] * corners[i];
  }
  RELIEVO_CHECK(glm::length(sum - glm::dvec3(3.25, 0.125, 0.)) < 1e-14);
}

void TestBadGeometry()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto mesh = MakePolygons({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { nan, 0, 0 },
    { 0, std::numeric_limits<double>::infinity(), 0 }, { 0, 0, 0 } });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 3 });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 4 });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 5 });
  mesh->GetPolys()->InsertNextCell({ 0, 1 });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2 });
  EmbreeScene scene;
  scene.AddActor(mesh);
  RELIEVO_CHECK(scene.NumberOfTriangles() == 1);
  const SurfacePoint point = scene.Cast(Ray{ { 0.2, 0.2, 1. }, { 0., 0., -1. } }, 0., 9.);
  RELIEVO_CHECK(point.Hit && point.Cell == 4);
  RELIEVO_CHECK(relievoTest::FailuresOf([&] { scene.AddActor(mesh); }) == 1);

  EmbreeScene empty;
  RELIEVO_CHECK(!empty.Cast(Ray{ { 0., 0., 1. }, { 0., 0., -1. } }, 0., 9.).Hit);
  RELIEVO_CHECK(empty.Size() == 0.);
  Stage stage(20, 10);
  const TruthImage image = empty.Trace(View(stage.Renderer));
  RELIEVO_CHECK(image.Pixels.size() == 200 && image.NumberOfHits() == 0);
  RELIEVO_CHECK(std::isinf(image.At(3, 4).Depth) && image.At(3, 4).Actor == -1);
}

// Widths and edge distances of a triangle whose pixels are known.
void TestScreenTriangle()
{
  Stage stage(100, 100);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(50.);
  camera->SetPosition(0., 0., 10.);
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetClippingRange(1., 100.);
  const View view(stage.Renderer);
  // One pixel is one unit, the centre of the view is pixel (50, 50).
  const relievoTest::ScreenTriangle triangle(
    view, { glm::dvec3(-20., -10., 0.), glm::dvec3(20., -10., 0.), glm::dvec3(0., 10., 0.) });
  RELIEVO_CHECK_NEAR(triangle.Width(), 20., 1e-12, "smallest altitude");
  RELIEVO_CHECK_NEAR(triangle.Distance({ 50., 41. }), 1., 1e-12, "distance inside");
  RELIEVO_CHECK_NEAR(triangle.Distance({ 50., 38. }), -2., 1e-12, "distance outside");
  RELIEVO_CHECK_NEAR(triangle.Distance({ 50., 70. }), -10., 1e-12, "distance beyond a corner");
  // Reversed, the triangle has equal values.
  const relievoTest::ScreenTriangle reversed(
    view, { glm::dvec3(20., -10., 0.), glm::dvec3(-20., -10., 0.), glm::dvec3(0., 10., 0.) });
  RELIEVO_CHECK_NEAR(reversed.Distance({ 50., 41. }), 1., 1e-12, "reversed");

  // A corner before the near plane is cut off.
  camera->ParallelProjectionOff();
  camera->SetViewAngle(90.);
  const View perspective(stage.Renderer);
  const relievoTest::ScreenTriangle cut(
    perspective, { glm::dvec3(-5., 0., 5.), glm::dvec3(5., 0., 5.), glm::dvec3(0., 0.5, 11.) });
  RELIEVO_CHECK(cut.Distance({ 50., 51. }) > 0. && std::isfinite(cut.Width()) && cut.Width() > 0.);
  const relievoTest::ScreenTriangle behind(
    perspective, { glm::dvec3(-5., 0., 15.), glm::dvec3(5., 0., 15.), glm::dvec3(0., 0.5, 11.) });
  RELIEVO_CHECK(behind.Width() == 0. && behind.Distance({ 50., 50. }) < 0.);
}

void TestInsideAndRange()
{
  // Within a box every ray hits its inner side.
  Stage stage(64, 64);
  stage.Renderer->GetActiveCamera()->SetClippingRange(0.01, 100.);
  const View view(stage.Renderer);
  EmbreeScene box;
  box.AddActor(MakeBox(20., 20., 20.));
  const TruthImage image = box.Trace(view);
  RELIEVO_CHECK(image.NumberOfHits() == 64 * 64);
  RELIEVO_CHECK(std::none_of(image.Pixels.begin(), image.Pixels.end(),
    [](const PixelTruth& pixel) { return pixel.FrontFacing; }));

  // The range is respected at both ends, and earlier surfaces are skipped.
  EmbreeScene two;
  two.AddActor(MakeBox(1., 1., 1.));
  const Ray ray{ { 0.1, 0.2, 5.5 }, { 0., 0., -2. } };
  RELIEVO_CHECK(two.Cast(ray, 0., 99.).Depth == 2.5);
  RELIEVO_CHECK(two.Cast(ray, 2.500001, 99.).Depth == 3.);
  RELIEVO_CHECK(two.Cast(ray, 2.5, 99.).Depth == 2.5);
  RELIEVO_CHECK(!two.Cast(ray, 0., 2.499999).Hit);
  RELIEVO_CHECK(!two.Cast(ray, 3.000001, 99.).Hit);
  RELIEVO_CHECK(two.Cast(ray, 0., 99., two.Cast(ray, 0., 99.).Triangle).Depth == 3.);
}

// Actors as in a renderer.
void TestRenderer()
{
  Stage stage(64, 64);
  const auto add = [&](double x, bool visible) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(MakeBox(0.5, 0.5, 0.5));
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(x, 0.5, 0.);
    actor->SetVisibility(visible);
    stage.Renderer->AddActor(actor);
  };
  add(-1., true);
  add(0., false);
  add(1., true);
  EmbreeScene scene;
  RELIEVO_CHECK(scene.AddActors(stage.Renderer) == 2);
  const auto cast = [&](double x) {
    return scene.Cast(Ray{ { x, 0.51, 5. }, { 0., 0., -1. } }, 0., 99.).Actor;
  };
  RELIEVO_CHECK(cast(-1.) == 0 && cast(0.) == -1 && cast(1.) == 1);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testEmbreeTriangles)
{
  relievoTest::Session session;
  TestCells();
  TestBadGeometry();
  TestScreenTriangle();
  TestInsideAndRange();
  TestRenderer();
  return session.Result();
}
}
