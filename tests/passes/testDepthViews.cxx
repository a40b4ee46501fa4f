// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth images from two and six sides: the cells that they say are inside are those of the same
// views in double, but for cells that a hundredth of a cell decides, also around the camera; the
// renderer and its picture stay as they were; moving actors.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoDepthViews.h>
#include <vtkRelievoVoxelShell.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>
#include <vtkTransformFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace testDepthViews
{
namespace
{
using namespace relievoTest;
using Cells = std::vector<unsigned char>;
constexpr double Box[6] = { -2., 2.4, -1.6, 1.6, -1.2, 1.2 };

struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Torus;
  vtkNew<vtkActor> Bowl;
  vtkSmartPointer<vtkRenderWindow> Window;

  explicit Scene(int width = 150, int height = 100)
  {
    const Solid solids[2] = { MakeTorus(1e-3), MakeBowl(1e-3, Turn({ 1., 0.2, 0.1 }, 50.)) };
    vtkActor* actors[2] = { this->Torus, this->Bowl };
    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(solids[i].Mesh);
      actors[i]->SetMapper(mapper);
      this->Renderer->AddActor(actors[i]);
    }
    this->Torus->SetOrientation(70., 13., 20.);
    this->Torus->SetPosition(-0.5, 0.1, 0.);
    this->Bowl->SetPosition(1.2, 0., 0.1);
    this->Bowl->SetScale(0.8);
    this->Renderer->SetBackground(0.2, 0.3, 0.4);
    this->Window = MakeWindow(width, height, this->Renderer);
  }

  // The geometry of both actors as data, in double.
  vtkSmartPointer<vtkPolyData> Data()
  {
    vtkNew<vtkAppendPolyData> both;
    both->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    for (vtkActor* actor : { this->Torus.Get(), this->Bowl.Get() })
    {
      vtkNew<vtkTransform> transform;
      transform->SetMatrix(actor->GetMatrix());
      vtkNew<vtkTransformFilter> moved;
      moved->SetInputData(vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput());
      moved->SetTransform(transform);
      moved->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      moved->Update();
      both->AddInputData(moved->GetPolyDataOutput());
    }
    both->Update();
    return both->GetOutput();
  }
};

void SetGrid(vtkRelievoVoxelShell* shell, double cell, const double shift[3])
{
  double box[6];
  for (int i = 0; i < 6; ++i)
  {
    box[i] = Box[i] + shift[i / 2];
  }
  shell->SetBounds(box);
  shell->SetCellSize(cell);
}

Cells CellsOf(vtkRelievoVoxelShell* shell)
{
  shell->Update();
  RELIEVO_CHECK(shell->GetErrorCode() == vtkErrorCode::NoError);
  auto* mask =
    vtkUnsignedCharArray::SafeDownCast(shell->GetOutput()->GetCellData()->GetArray("mask"));
  const unsigned char* first = mask->GetPointer(0);
  return Cells(first, first + mask->GetNumberOfValues());
}

Cells Seen(vtkRenderer* renderer, bool six, double cell, double texel)
{
  vtkNew<vtkRelievoDepthViews> views;
  views->SetRenderer(renderer);
  views->SetSixViews(six);
  views->SetBounds(Box);
  views->SetTexelSize(texel);
  vtkNew<vtkRelievoVoxelShell> shell;
  shell->SetInputConnection(1, views->GetOutputPort());
  const double none[3] = { 0., 0., 0. };
  SetGrid(shell, cell, none);
  return CellsOf(shell);
}

// In double, with the grid moved by so many cells.
Cells Computed(vtkPolyData* data, bool six, double cell, const double shift[3])
{
  vtkNew<vtkRelievoVoxelShell> shell;
  shell->SetInputData(data);
  shell->SetMethod(six ? vtkRelievoVoxelShell::SIX_VIEWS : vtkRelievoVoxelShell::TWO_VIEWS);
  const double moved[3] = { shift[0] * cell, shift[1] * cell, shift[2] * cell };
  SetGrid(shell, cell, moved);
  return CellsOf(shell);
}

void TestAgainstDouble()
{
  Scene scene;
  const vtkSmartPointer<vtkPolyData> data = scene.Data();
  const double cell = 0.04;
  for (const bool six : { false, true })
  {
    const Cells seen = Seen(scene.Renderer, six, cell, cell);
    std::vector<Cells> computed;
    for (int i = -1; i < 8; ++i)
    {
      // OpenGL places corners on a grid of 1/256 pixel.
      const double by = i < 0 ? 0. : 0.01;
      const double shift[3] = { i & 1 ? by : -by, i & 2 ? by : -by, i & 4 ? by : -by };
      computed.push_back(Computed(data, six, cell, shift));
    }
    int mismatches = 0;
    int decided = 0;
    for (std::size_t c = 0; c < seen.size(); ++c)
    {
      const bool flips = std::any_of(computed.begin(), computed.end(),
        [&](const Cells& each) { return each[c] != computed[0][c]; });
      decided += flips ? 0 : 1;
      mismatches += !flips && seen[c] != computed[0][c] ? 1 : 0;
    }
    RELIEVO_CHECK(seen.size() == computed[0].size());
    RELIEVO_CHECK_AT_MOST(mismatches, 0., six ? "cells, six views" : "cells, two views");
    RELIEVO_CHECK(decided > 0.99 * static_cast<double>(seen.size()));
    RELIEVO_CHECK(std::count(seen.begin(), seen.end(), 1) > 10000);
  }
}

// A body around the camera, in its rock, in its air, and one of which nothing is seen: the cells
// are those that are found from outside.
void TestCameraInside()
{
  Scene scene;
  const double cell = 0.04;
  const Cells outside = Seen(scene.Renderer, true, cell, cell);
  const auto found = std::find(outside.begin(), outside.end(), 1);
  const auto first = static_cast<int>(found - outside.begin());
  const double inRock[3] = { Box[0] + (first % 110 + 0.5) * cell,
    Box[2] + (first / 110 % 80 + 0.5) * cell, Box[4] + (first / 110 / 80 + 0.5) * cell };
  const double inHole[3] = { -0.5, 0.1, 0. }; // of the torus
  for (const double* eye : { inRock, inHole })
  {
    for (const double far : { 10., 0.02 })
    {
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetPosition(eye);
      camera->SetFocalPoint(eye[0] + 1., eye[1] + 0.2, eye[2]);
      camera->SetClippingRange(1e-3, far);
      const auto before = Picture(scene.Window);
      RELIEVO_CHECK_THAT(Seen(scene.Renderer, true, cell, cell) == outside,
        "cells that depend on the camera in the body");
      RELIEVO_CHECK(SamePicture(before, Picture(scene.Window), "a camera in the body"));
    }
  }
}

void TestSides()
{
  Scene scene;
  vtkNew<vtkRelievoDepthViews> views;
  views->SetRenderer(scene.Renderer);
  views->SetBounds(Box);
  views->SetTexelSize(0.04);
  views->Update();
  vtkMultiBlockDataSet* blocks = views->GetOutput();
  RELIEVO_CHECK(blocks->GetNumberOfBlocks() == 6);
  const int sizes[6][2] = { { 80, 60 }, { 80, 60 }, { 110, 60 }, { 110, 60 }, { 110, 80 },
    { 110, 80 } };
  for (unsigned int i = 0; i < 6; ++i)
  {
    auto* image = vtkImageData::SafeDownCast(blocks->GetBlock(i));
    RELIEVO_CHECK(image && image->GetDimensions()[0] == sizes[i][0]);
    RELIEVO_CHECK(image && image->GetDimensions()[1] == sizes[i][1]);
  }
  views->SixViewsOff();
  views->SetAxis(1);
  views->Update();
  RELIEVO_CHECK(views->GetOutput()->GetNumberOfBlocks() == 2);
  // In a window with fewer pixels than texels the texels are larger: cells are off by one texel.
  Scene small(40, 30);
  const Cells coarse = Seen(small.Renderer, true, 0.04, 0.04);
  const Cells fine = Seen(scene.Renderer, true, 0.04, 0.04);
  const auto count = static_cast<double>(std::count(fine.begin(), fine.end(), 1));
  RELIEVO_CHECK_NEAR(
    static_cast<double>(std::count(coarse.begin(), coarse.end(), 1)) / count, 1., 0.1, "volume");
}

void TestStays()
{
  Scene scene;
  scene.Renderer->GetActiveCamera()->SetPosition(3., 2., 5.);
  scene.Renderer->ResetCamera();
  scene.Renderer->SetViewport(0.25, 0., 1., 0.9);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const vtkSmartPointer<vtkImageData> before = Picture(scene.Window);
  const Cells first = Seen(scene.Renderer, true, 0.1, 0.1);
  RELIEVO_CHECK(scene.Renderer->GetActiveCamera() == camera);
  RELIEVO_CHECK(scene.Renderer->GetViewport()[0] == 0.25);
  RELIEVO_CHECK(scene.Renderer->GetPass() == nullptr);
  const vtkSmartPointer<vtkImageData> after = Picture(scene.Window);
  auto* a = static_cast<unsigned char*>(before->GetScalarPointer());
  auto* b = static_cast<unsigned char*>(after->GetScalarPointer());
  RELIEVO_CHECK(std::equal(a, a + 3 * before->GetNumberOfPoints(), b));
  RELIEVO_CHECK(*std::max_element(a, a + 3 * before->GetNumberOfPoints()) > 200);
  // The cells depend only on the scene: not on the camera, the viewport, or earlier results.
  RELIEVO_CHECK(Seen(scene.Renderer, true, 0.1, 0.1) == first);
  scene.Torus->SetPosition(0.5, 0.3, 0.2);
  RELIEVO_CHECK(Seen(scene.Renderer, true, 0.1, 0.1) != first);
  scene.Torus->SetPosition(-0.5, 0.1, 0.);
  RELIEVO_CHECK(Seen(scene.Renderer, true, 0.1, 0.1) == first);
  scene.Torus->VisibilityOff();
  scene.Bowl->VisibilityOff();
  const Cells none = Seen(scene.Renderer, true, 0.1, 0.1);
  RELIEVO_CHECK(std::count(none.begin(), none.end(), 1) == 0);
  // A renderer that has not drawn yet still finds its own camera.
  Scene fresh;
  RELIEVO_CHECK(Seen(fresh.Renderer, true, 0.1, 0.1) == first);
  RELIEVO_CHECK(!fresh.Renderer->IsActiveCameraCreated());
}

// While its window draws a picture in tiles, the views are whole, and the tile is as it was.
void TestTiles()
{
  Scene scene;
  const Cells whole = Seen(scene.Renderer, true, 0.1, 0.1);
  scene.Window->SetTileScale(2, 3);
  scene.Window->SetTileViewport(0.5, 1. / 3., 1., 2. / 3.);
  RELIEVO_CHECK(Seen(scene.Renderer, true, 0.1, 0.1) == whole);
  RELIEVO_CHECK(scene.Window->GetTileScale()[0] == 2 && scene.Window->GetTileScale()[1] == 3);
  const double* tile = scene.Window->GetTileViewport();
  RELIEVO_CHECK(tile[0] == 0.5 && tile[1] == 1. / 3. && tile[2] == 1. && tile[3] == 2. / 3.);
}

void TestRefusals()
{
  vtkNew<vtkRelievoDepthViews> views;
  {
    relievoTest::ExpectMessage expect("no renderer");
    views->Update();
  }
  vtkNew<vtkRenderer> renderer;
  views->SetRenderer(renderer);
  {
    relievoTest::ExpectMessage expect("a renderer without a window");
    views->Update();
  }
  RELIEVO_CHECK(views->GetOutput()->GetNumberOfBlocks() == 0);
  Scene scene;
  views->SetRenderer(scene.Renderer);
  const double infinity = std::numeric_limits<double>::infinity();
  views->SetBounds(-infinity, infinity, -1., 1., -1., 1.);
  {
    relievoTest::ExpectMessage expect("along x the box is from -inf to inf");
    views->Update();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  RELIEVO_CHECK(views->GetOutput()->GetNumberOfBlocks() == 0);
  RELIEVO_CHECK(views->GetErrorCode() == vtkErrorCode::UserError);
}

void TestAbort()
{
  Scene scene;
  vtkNew<vtkRelievoDepthViews> views;
  views->SetRenderer(scene.Renderer);
  views->SetBounds(Box);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    auto* filter = vtkAlgorithm::SafeDownCast(caller);
    filter->SetAbortExecute(filter->GetProgress() > 0.4);
  });
  const unsigned long tag = views->AddObserver(vtkCommand::ProgressEvent, abort);
  views->Update();
  RELIEVO_CHECK(views->GetOutput()->GetNumberOfBlocks() == 0);
  views->RemoveObserver(tag);
  views->SetAbortExecute(0);
  views->Update();
  RELIEVO_CHECK(views->GetOutput()->GetNumberOfBlocks() == 6);
}
}

RELIEVO_TEST_CASE(testDepthViews)
{
  relievoTest::Session session;
  TestAgainstDouble();
  TestCameraInside();
  TestSides();
  TestStays();
  TestTiles();
  TestRefusals();
  TestAbort();
  return session.Result();
}
}
