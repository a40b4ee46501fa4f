// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's own drawing agrees with Embree's truth at every pixel, for all kinds of views and cells.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Scenes.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkHardwareSelector.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSelection.h>

#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace testDrawn
{
namespace
{
using relievoTest::PixelTruth;
using relievoTest::TruthImage;
using relievoTest::View;

struct Case
{
  const char* Name;
  int Width;
  int Height;
  std::function<void(vtkRenderer*, vtkCamera*)> Set;
};

const std::vector<Case> Cases = {
  { "wide", 500, 200, [](vtkRenderer*, vtkCamera*) {} },
  { "tall, part of a window", 333, 517,
    [](vtkRenderer* renderer, vtkCamera*) { renderer->SetViewport(0.13, 0.21, 0.78, 0.87); } },
  { "parallel", 320, 240,
    [](vtkRenderer*, vtkCamera* camera) {
      camera->ParallelProjectionOn();
      camera->SetParallelScale(1.7);
    } },
  { "off centre", 300, 250,
    [](vtkRenderer*, vtkCamera* camera) { camera->SetWindowCenter(0.3, -0.25); } },
  { "parallel, off centre, part of a window", 500, 400,
    [](vtkRenderer* renderer, vtkCamera* camera) {
      renderer->SetViewport(0.4, 0.1, 1., 0.9);
      camera->ParallelProjectionOn();
      camera->SetParallelScale(1.5);
      camera->SetWindowCenter(-0.2, 0.1);
    } },
  { "horizontal angle, rolled", 400, 200,
    [](vtkRenderer*, vtkCamera* camera) {
      camera->UseHorizontalViewAngleOn();
      camera->SetViewAngle(50.);
      camera->Roll(33.);
    } },
  { "near plane through the mesh", 300, 300,
    [](vtkRenderer*, vtkCamera* camera) { camera->SetClippingRange(6.9, 14.); } },
};

// Unlit and in pure colours, so that a pixel's colour is its actor.
void Paint(const relievoTest::ReferenceScene& scene)
{
  scene.MeshActor->GetProperty()->LightingOff();
  scene.GroundActor->GetProperty()->LightingOff();
  scene.MeshActor->GetProperty()->SetColor(1., 0., 0.);
  scene.GroundActor->GetProperty()->SetColor(0., 1., 0.);
  scene.Renderer->SetBackground(0., 0., 0.);
}

void TestView(const Case& test)
{
  const auto scene = relievoTest::MakeReferenceScene("armadillo");
  if (!RELIEVO_CHECK(scene.IsValid()))
  {
    return;
  }
  Paint(scene);
  // The truth must also apply a matrix that rotates, stretches and mirrors.
  scene.MeshActor->SetOrientation(0., 25., 0.);
  scene.MeshActor->SetScale(-0.9, 1., 1.1);
  const auto window = relievoTest::MakeWindow(test.Width, test.Height, scene.Renderer);
  const relievoTest::GLCheck gl(window);
  test.Set(scene.Renderer, scene.Renderer->GetActiveCamera());
  const auto picture = relievoTest::Picture(window);
  const View view(scene.Renderer);
  const TruthImage truth = scene.MakeTruth()->Trace(view);
  long long other = 0;
  long long otherInner = 0;
  long long meshes = 0;
  for (int y = 0; y < truth.Height; ++y)
  {
    for (int x = 0; x < truth.Width; ++x)
    {
      const PixelTruth& pixel = truth.At(x, y);
      const auto* rgb =
        static_cast<unsigned char*>(picture->GetScalarPointer(x + view.Left, y + view.Bottom, 0));
      const int drawn = rgb[0] > 127 ? 0 : (rgb[1] > 127 ? 1 : -1);
      meshes += pixel.Actor == 0 ? 1 : 0;
      other += drawn != pixel.Actor ? 1 : 0;
      otherInner += pixel.Inner && drawn != pixel.Actor ? 1 : 0;
    }
  }
  const std::string name = test.Name;
  std::cout << name << ": " << truth.Width << "x" << truth.Height << ", " << meshes
            << " pixels of the mesh, " << truth.NumberOfInner() << " inner, " << other
            << " show another actor\n";
  RELIEVO_CHECK(meshes > 1000 && truth.NumberOfInner() > 2000 && otherInner == 0);
  RELIEVO_CHECK_AT_MOST(static_cast<double>(other) / static_cast<double>(truth.Pixels.size()),
    0.001, name + ": share of another actor");
}

// VTK's selector identifies the drawn cell: polygons, also bent and concave ones, and strips.
void TestCells()
{
  const auto mesh =
    relievoTest::MakePolygons({ { -2, 0, 0 }, { -1, 0, 0.3 }, { -0.7, 0.8, 0 }, { -1.4, 0.3, 0.2 },
      { -2.2, 1, -0.4 }, { 0, 0, 0 }, { 1, 0, 0.2 }, { 1, 1, -0.2 }, { 0, 1, 0.4 }, { 1.3, 0, 0 },
      { 1.3, 1, 0 }, { 1.7, 0.1, 0.5 }, { 1.8, 0.9, -0.2 }, { 2.2, 0, 0 }, { 2.3, 1.2, 0 } });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3, 4 });
  mesh->GetPolys()->InsertNextCell({ 5, 6, 7, 8 });
  mesh->GetPolys()->InsertNextCell({ 2, 5, 8 });
  mesh->SetStrips(vtkNew<vtkCellArray>());
  mesh->GetStrips()->InsertNextCell({ 9, 11, 10, 12, 14 });
  mesh->GetStrips()->InsertNextCell({ 11, 13, 12 });

  const relievoTest::Stage stage(400, 300);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  const relievoTest::GLCheck gl(stage.Window);
  stage.Window->Render();
  relievoTest::EmbreeScene scene;
  RELIEVO_CHECK(scene.AddActors(stage.Renderer) == 1);
  const TruthImage truth = scene.Trace(View(stage.Renderer));

  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetArea(0, 0, 399, 299);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  RELIEVO_CHECK(selector->CaptureBuffers());
  long long hits = 0;
  long long other = 0;
  for (int y = 0; y < 300; ++y)
  {
    for (int x = 0; x < 400; ++x)
    {
      unsigned int place[2] = { static_cast<unsigned int>(x), static_cast<unsigned int>(y) };
      const auto drawn = selector->GetPixelInformation(place, 0);
      const long long cell = drawn.Valid ? drawn.AttributeID : -1;
      hits += truth.At(x, y).Hit ? 1 : 0;
      other += cell != truth.At(x, y).Cell ? 1 : 0;
    }
  }
  std::cout << "cells: " << hits << " pixels hit, " << other << " show another cell\n";
  RELIEVO_CHECK(hits > 5000);
  RELIEVO_CHECK_AT_MOST(static_cast<double>(other), 12., "pixels of another cell");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testDrawn)
{
  relievoTest::Session session;
  for (const Case& test : Cases)
  {
    TestView(test);
  }
  TestCells();
  return session.Result();
}
}
