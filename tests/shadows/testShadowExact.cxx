// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact shadows: the real meshes against Embree, light through panes against the product of what
// they let pass, and what a hierarchy of triangles may stumble over.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Scenes.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "ShadowScenes.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowPass.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>

namespace
{
using relievoTest::Layers;
using relievoTest::SceneLight;
using relievoTest::ShadowStage;

constexpr double Limit = 2e-5;

const float* Visibility(vtkImageData* image)
{
  return vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"))->GetPointer(0);
}

void TestMesh(const std::string& mesh, SceneLight kind, int width, int height)
{
  const auto scene = relievoTest::MakeReferenceScene(mesh, kind);
  if (!scene.IsValid())
  {
    return;
  }
  auto window = relievoTest::MakeWindow(width, height, scene.Renderer);
  relievoTest::GLCheck gl(window);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->GetShadowPass()->SetMethodToExact();
  const auto truth = scene.MakeTruth();
  window->Render();
  const auto shadow =
    relievoTest::TraceShadow(*truth, truth->Trace(relievoTest::View(scene.Renderer)), scene.Light);
  const Layers phong(scene.Renderer, { "shadow_0" });
  const auto errors = relievoTest::CompareShadow(shadow, Visibility(phong.Image));
  const std::string what = mesh + ", " + std::to_string(width) + " x " + std::to_string(height);
  std::cout << what << ": " << errors.ToString() << std::endl;
  RELIEVO_CHECK_THAT(errors.Compared > width * height / 9 && errors.Dark > width * height / 200,
    what + ": what is compared");
  RELIEVO_CHECK_AT_MOST(errors.Wrong(), Limit, what + ": share of wrong verdicts");
  scene.MeshActor->GetProperty()->SetInterpolationToPBR();
  scene.GroundActor->GetProperty()->SetInterpolationToPBR();
  const Layers pbr(scene.Renderer, { "shadow_0" });
  RELIEVO_CHECK_AT_MOST(
    relievoTest::CountDifferent(phong, pbr, "shadow_0"), 0, what + ": pixels unlike with PBR");
  RELIEVO_CHECK_THAT(frame->GetShadowPass()->GetNumberOfMaps() == 0, what + ": maps");
  // At most 64 bytes for each of the mesh's triangles, and what the ground takes; 16 a pixel, and 4
  // for each tile of 8 x 8.
  const auto bytes = static_cast<double>(frame->GetShadowPass()->GetBytesHeld());
  RELIEVO_CHECK_AT_MOST(bytes,
    64. * static_cast<double>(truth->NumberOfTriangles()) + 4096. +
      (16. + 4. / 64.) * (width + 7) * (height + 7),
    what + ": bytes held");
  gl.Poll(mesh);
  vtkRelievoPass::Detach(scene.Renderer);
}

void TestHorizon()
{
  ShadowStage stage(400, 300);
  stage.AddPolesToHorizon();
  stage.GetShadows()->SetMethodToExact();
  relievoTest::CheckShadow(stage, 0, Limit, "horizon");
}

// Two panes over the ground: each point lets pass what its rays meet, by the panes' extent.
void TestPanes()
{
  ShadowStage stage;
  stage.AddGround();
  const double opacity[2] = { 0.3, 0.5 };
  for (int i = 0; i < 2; ++i)
  {
    const double x = -1.5 + 0.8 * i;
    const double y = 4. + i; // out of the picture
    const auto mesh = relievoTest::MakePolygons(
      { { x, y, -1. }, { x + 1.6, y, -1. }, { x + 1.6, y, 1. }, { x, y, 1. } });
    mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
    const auto pane = relievoTest::AddActor(stage.Renderer, mesh);
    pane->GetProperty()->SetOpacity(opacity[i]);
    stage.GetShadows()->SetPropCasts(pane, vtkRelievoShadowPass::CASTS_ALWAYS);
  }
  stage.AddSun(0., 5., 0.);
  stage.GetShadows()->SetMethodToExact();
  const auto image = relievoTest::CaptureShadow(stage, 0);
  relievoTest::EmbreeScene ground;
  const auto mesh = relievoTest::MakePolygons(
    { { -3., 0., 3. }, { 3., 0., 3. }, { 3., 0., -3. }, { -3., 0., -3. } });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  ground.AddActor(mesh);
  const auto view = ground.Trace(relievoTest::View(stage.Renderer));
  long long seen[4] = { 0, 0, 0, 0 };
  long long wrong = 0;
  for (std::size_t i = 0; i < view.Pixels.size(); ++i)
  {
    const glm::dvec3& p = view.Pixels[i].Position;
    if (!view.Pixels[i].Hit || std::abs(p.y) > 1e-6)
    {
      continue;
    }
    double passes = 1.;
    int which = 0;
    bool tie = false;
    for (int k = 0; k < 2; ++k)
    {
      const double x = -1.5 + 0.8 * k;
      // The edges, and the diagonals between a pane's two triangles, which count twice.
      const double diagonal = (p.x - x) / 1.6 - (p.z + 1.) / 2.;
      tie = tie || std::abs(p.x - x) < 1e-5 || std::abs(p.x - x - 1.6) < 1e-5 ||
        std::abs(std::abs(p.z) - 1.) < 1e-5 || std::abs(diagonal) < 1e-5;
      if (p.x > x && p.x < x + 1.6 && std::abs(p.z) < 1.)
      {
        passes *= 1. - opacity[k];
        which += 1 << k;
      }
    }
    ++seen[which];
    wrong += !tie && std::abs(Visibility(image)[i] - passes) > 0.51 / 255. ? 1 : 0; // 8 bits
  }
  RELIEVO_CHECK_THAT(seen[1] > 300 && seen[2] > 300 && seen[3] > 300, "panes: too little is seen");
  RELIEVO_CHECK_AT_MOST(wrong, 0, "panes: pixels that pass another share");
}

// A finely cut sheet over all that is seen: no ray slips through between its triangles.
void TestWatertight()
{
  ShadowStage stage;
  stage.AddGround();
  constexpr int Cells = 40;
  std::vector<glm::dvec3> points;
  for (int i = 0; i <= Cells; ++i)
  {
    for (int j = 0; j <= Cells; ++j)
    {
      points.emplace_back(-8. + 16. * i / Cells, 6. + 0.3 * std::sin(i * 7.) * std::cos(j * 3.),
        -8. + 16. * j / Cells);
    }
  }
  const auto mesh = relievoTest::MakePolygons(points);
  for (int i = 0; i < Cells; ++i)
  {
    for (int j = 0; j < Cells; ++j)
    {
      const vtkIdType p = i * (Cells + 1) + j;
      mesh->GetPolys()->InsertNextCell({ p, p + 1, p + Cells + 2, p + Cells + 1 });
    }
  }
  relievoTest::AddActor(stage.Renderer, mesh);
  stage.AddSun(0., 5., 0.); // right through the lattice's edges
  stage.GetShadows()->SetMethodToExact();
  double range[2];
  const auto image = relievoTest::CaptureShadow(stage, 0);
  long long lit = 0;
  const auto truth = relievoTest::TraceStage(stage, 0);
  for (std::size_t i = 0; i < truth.Verdicts.size(); ++i)
  {
    lit += truth.Verdicts[i] != relievoTest::ShadowTruth::Unjudged && Visibility(image)[i] > 0.f;
  }
  image->GetPointData()->GetArray("shadow_0")->GetRange(range);
  RELIEVO_CHECK_THAT(range[0] == 0., "watertight: nothing is dark");
  RELIEVO_CHECK_AT_MOST(lit, 0, "watertight: pixels that a ray slips through to");
}

long long CountUnlike(vtkImageData* first, vtkImageData* second)
{
  long long unlike = 0;
  for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
  {
    unlike += Visibility(first)[i] != Visibility(second)[i] ? 1 : 0;
  }
  return unlike;
}

// Bumps of a few pixels, to the rims of pictures whose last tiles are rows and columns of pixels:
// verdicts by tiles are those that each fragment of the mesh finds by itself in the first frame.
void TestBumps()
{
  for (const auto& size : { std::array<int, 2>{ 241, 177 }, std::array<int, 2>{ 121, 240 },
         std::array<int, 2>{ 97, 97 } })
  {
    ShadowStage stage(size[0], size[1]);
    constexpr int Cells = 300;
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= Cells; ++i)
    {
      for (int j = 0; j <= Cells; ++j)
      {
        points.emplace_back(-9. + 18. * i / Cells, 0.06 * std::sin(i * 1.7) * std::cos(j * 1.1),
          -9. + 18. * j / Cells);
      }
    }
    const auto mesh = relievoTest::MakePolygons(points);
    for (int i = 0; i < Cells; ++i)
    {
      for (int j = 0; j < Cells; ++j)
      {
        const vtkIdType p = i * (Cells + 1) + j;
        mesh->GetPolys()->InsertNextCell({ p, p + 1, p + Cells + 2, p + Cells + 1 });
      }
    }
    relievoTest::AddActor(stage.Renderer, mesh);
    stage.Renderer->GetActiveCamera()->SetPosition(0.5, 6., 3.);
    stage.AddSun(-4., 2., -1.);
    stage.GetShadows()->SetMethodToExact();
    const auto first = relievoTest::CaptureShadow(stage, 0);
    relievoTest::CaptureShadow(stage, 0);
    const auto kept = relievoTest::CaptureShadow(stage, 0);
    RELIEVO_CHECK_AT_MOST(CountUnlike(first, kept), 0,
      "bumps, " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + ": pixels unlike");
    relievoTest::CheckShadow(stage, 0, 1e-3, "bumps"); // edges everywhere, at 1/256 of a pixel
  }
}

// Sheets that a depth buffer of 24 bits can hardly tell apart: the verdicts that are kept are those
// of the sheet that the picture shows, as each fragment finds them by itself in the first frame,
// but for a pixel in which the two fight.
void TestCoarseDepth()
{
  ShadowStage stage;
  stage.AddThings();
  for (int i = 0; i < 2; ++i)
  {
    const auto sheet = stage.AddGround();
    sheet->SetPosition(0., 0.02 * (i + 1), 0.);
    sheet->SetScale(0.8 - 0.2 * i, 1., 0.8);
    sheet->RotateZ(0.1 * i);
  }
  stage.AddSun(-3., 4., -2.);
  stage.Renderer->GetActiveCamera()->SetClippingRange(1e-3, 1e3);
  stage.GetShadows()->SetMethodToExact();
  const auto first = relievoTest::CaptureShadow(stage, 0);
  relievoTest::CaptureShadow(stage, 0);
  const auto kept = relievoTest::CaptureShadow(stage, 0);
  RELIEVO_CHECK_AT_MOST(CountUnlike(first, kept), 1, "coarse depth: pixels unlike the first's");
}

// Slivers, triangles without area or place, surfaces twice in one place; then all moves and hides.
void TestTroubles()
{
  ShadowStage stage;
  stage.AddGround();
  stage.AddGround();
  stage.AddThings();
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto mesh =
    relievoTest::MakePolygons({ { -1., 1.5, 0. }, { 1., 1.5, 0. }, { 1., 1.5 + 1e-7, 1e-5 },
      { 0., 1.5, 0. }, { none, 0., 0. }, { -2., 1.2, 1. }, { -1., 1.2, 1. }, { -1., 1.2, 2. } });
  for (const auto& cell :
    { std::array<vtkIdType, 3>{ 0, 1, 2 }, { 0, 1, 3 }, { 0, 3, 3 }, { 0, 1, 4 }, { 5, 6, 7 } })
  {
    mesh->GetPolys()->InsertNextCell(3, cell.data());
  }
  relievoTest::AddActor(stage.Renderer, mesh);
  const auto box = stage.AddBox({ 1.4, 1.5, 0.8 }, { 0.6, 0.1, 0.6 });
  stage.AddSun(-3., 4., -2.);
  stage.GetShadows()->SetMethodToExact();
  relievoTest::CheckShadow(stage, 0, 4e-5, "troubles");
  auto* data = vtkPolyDataMapper::SafeDownCast(box->GetMapper())->GetInput();
  for (int step = 0; step < 3; ++step)
  {
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      double p[3];
      data->GetPoint(i, p);
      data->GetPoints()->SetPoint(i, p[0] - 0.4, p[1] + 0.1 * (i % 2), p[2]);
    }
    data->GetPoints()->Modified();
    relievoTest::CheckShadow(stage, 0, 4e-5, "moved points, step " + std::to_string(step));
  }
  box->SetPosition(0.3, 0.2, -0.4);
  relievoTest::CheckShadow(stage, 0, 4e-5, "moved actor");
  box->VisibilityOff();
  relievoTest::CheckShadow(stage, 0, 4e-5, "hidden");
}

// What is no triangle is drawn into a map, and takes what rays let pass.
void TestOthers()
{
  ShadowStage stage;
  stage.AddGround();
  stage.AddBox({ 0.2, 0.8, -0.1 }, { 1.2, 1.6, 0.5 });
  stage.AddBox({ -1.4, 0.5, 0.9 }, { 0.9, 0.4, 0.7 })
    ->GetProperty()
    ->SetRepresentationToWireframe();
  stage.AddSun(-3., 4., -2.);
  stage.GetShadows()->SetMethodToExact();
  const auto both = relievoTest::CaptureShadow(stage, 0);
  RELIEVO_CHECK(stage.GetShadows()->GetNumberOfMaps() == 1);
  stage.GetShadows()->SetMethodToMap();
  const auto map = relievoTest::CaptureShadow(stage, 0);
  long long unlike = 0;
  long long dark = 0;
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    dark += Visibility(map)[i] < 0.5f;
    unlike += std::abs(Visibility(map)[i] - Visibility(both)[i]) > 0.6f;
  }
  RELIEVO_CHECK_THAT(dark > 1000, "others: too little is dark");
  RELIEVO_CHECK_AT_MOST(unlike, dark / 100, "others: pixels unlike map's");
  // Nothing at all casts.
  ShadowStage empty;
  empty.AddSun(-3., 4., -2.);
  empty.GetShadows()->SetMethodToExact();
  empty.GetFrame()->ShadowsOn();
  empty.Window->Render();
  RELIEVO_CHECK(empty.GetShadows()->GetNumberOfMaps() == 0);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  relievoTest::Session session;
  if (argc > 1 && std::string(argv[1]) == "few")
  {
    TestHorizon();
    TestPanes();
    TestTroubles();
    return session.Result();
  }
  TestMesh("bunny", SceneLight::Sun, 300, 300);
  TestMesh("bunny", SceneLight::Spot, 400, 225);
  TestMesh("motorBike", SceneLight::Sun, 300, 300);
  TestMesh("buildings", SceneLight::Point, 200, 600);
  TestHorizon();
  TestPanes();
  TestWatertight();
  TestBumps();
  TestCoarseDepth();
  TestTroubles();
  TestOthers();
  return session.Result();
}
