// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The linear colour without a picture, for captures: a function of the scene, whatever was captured
// before, without texts; the window keeps its picture.
#include "Check.h"
#include "GLCheck.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace testFrameCapture
{
namespace
{
constexpr int Width = 120;
constexpr int Height = 90;

struct Scene
{
  vtkNew<vtkRenderer> Below;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor2D> Bar;
  vtkSmartPointer<vtkRenderWindow> Window;

  explicit Scene(int layer = 0, int samples = 0)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetThetaResolution(40);
    ball->SetPhiResolution(40);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.9, 0.5, 0.2);
    this->Renderer->AddActor(actor);
    this->Renderer->SetBackground(0.1, 0.2, 0.4);
    this->Window = relievoTest::MakeWindow(Width, Height, layer ? this->Below : this->Renderer);
    this->Window->SetMultiSamples(samples);
    if (layer)
    {
      this->Below->SetBackground(0.5, 0.0, 0.0);
      this->Window->SetNumberOfLayers(2);
      this->Renderer->SetLayer(1);
      this->Window->AddRenderer(this->Renderer);
    }
    this->Renderer->ResetCamera();
  }

  void AddBar(double left, double right)
  {
    vtkNew<vtkPlaneSource> bar;
    bar->SetOrigin(left, 20.0, 0.0);
    bar->SetPoint1(right, 20.0, 0.0);
    bar->SetPoint2(left, 60.0, 0.0);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputConnection(bar->GetOutputPort());
    this->Bar->SetMapper(mapper);
    this->Bar->GetProperty()->SetColor(0.25, 1.0, 0.5);
    this->Renderer->AddViewProp(this->Bar);
  }
};

std::vector<double> GetColor(vtkImageData* image)
{
  std::vector<double> values;
  vtkDataArray* color = image->GetPointData()->GetArray("color");
  if (RELIEVO_CHECK(color && color->GetNumberOfComponents() == 4))
  {
    for (vtkIdType i = 0; i < 4 * color->GetNumberOfTuples(); ++i)
    {
      values.push_back(color->GetComponent(i / 4, static_cast<int>(i % 4)));
    }
  }
  return values;
}

std::vector<double> Capture(vtkRenderer* renderer)
{
  vtkNew<vtkRelievoLayerSource> layers;
  layers->SetRenderer(renderer);
  layers->AddLayer("color");
  layers->HDROn();
  layers->Update();
  return GetColor(layers->GetOutput());
}

double GetDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double most = a.size() == b.size() && !a.empty() ? 0.0 : 1e9;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    most = std::max(most, std::isfinite(a[i]) ? std::abs(a[i] - b[i]) : 1e9);
  }
  return most;
}

std::vector<unsigned char> GetWindow(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetRGBACharPixelData(0, 0, Width - 1, Height - 1, 0, bytes);
  return { bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues() };
}

// Texts and bars are in no capture of the colour, and captures do not draw them elsewhere either.
void TestTexts()
{
  for (const int samples : { 0, 8 })
  {
    Scene without(0, samples);
    const std::vector<double> truth = Capture(without.Renderer);
    Scene scene(0, samples);
    const std::string what = std::to_string(samples) + " samples: ";
    scene.AddBar(10.0, 70.0);
    relievoTest::GLCheck gl(scene.Window);
    RELIEVO_CHECK_THAT(
      GetDifference(Capture(scene.Renderer), truth) == 0.0, what + "a bar in the colour");
    // The window's picture has it where it was.
    scene.Window->SetSwapBuffers(false);
    scene.Window->Render();
    const std::vector<unsigned char> picture = GetWindow(scene.Window);
    scene.Bar->SetPosition(40.0, 20.0);
    RELIEVO_CHECK_THAT(
      GetDifference(Capture(scene.Renderer), truth) == 0.0, what + "a bar in the second capture");
    RELIEVO_CHECK_THAT(GetWindow(scene.Window) == picture, what + "the window has changed");
    // With the picture the colour is the same.
    vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
    frame->RequestLayer("color");
    scene.Window->Render();
    vtkNew<vtkImageData> image;
    RELIEVO_CHECK(frame->ReadLayer("color", image));
    RELIEVO_CHECK_THAT(GetDifference(GetColor(image), truth) == 0.0, what + "with the picture");
    gl.Poll(what);
  }
}

// If VTK does not clear the colour: no ghosts of earlier captures, nothing of renderers below.
void TestNoGhosts()
{
  enum Ways
  {
    LAYER,
    NOT_ERASED,
    KEEPS_COLOR,
    KEEPS_DEPTH,
    NESTED
  };
  for (const int way : { LAYER, NOT_ERASED, KEEPS_COLOR, KEEPS_DEPTH, NESTED })
  {
    for (const int samples : { 0, 4 })
    {
      const std::string what =
        "way " + std::to_string(way) + ", " + std::to_string(samples) + " samples: ";
      auto make = [&](Scene& scene) {
        scene.Renderer->SetErase(way != NOT_ERASED);
        scene.Renderer->SetPreserveColorBuffer(way == KEEPS_COLOR || way == LAYER);
        scene.Renderer->SetPreserveDepthBuffer(way == KEEPS_DEPTH);
      };
      auto capture = [&](Scene& scene) {
        if (way != NESTED)
        {
          return Capture(scene.Renderer);
        }
        vtkNew<vtkRelievoPass> frame;
        frame->RequestLayer("color");
        frame->LayersOnlyOn();
        vtkNew<vtkCameraPass> camera;
        camera->SetDelegatePass(frame);
        scene.Renderer->SetPass(camera);
        scene.Window->Render();
        vtkNew<vtkImageData> image;
        RELIEVO_CHECK(frame->ReadLayer("color", image));
        return GetColor(image);
      };
      Scene fresh(way == LAYER, samples);
      make(fresh);
      fresh.Renderer->GetActiveCamera()->Azimuth(30.0);
      fresh.Renderer->GetActiveCamera()->SetFocalPoint(0.5, 0.0, 0.0);
      const std::vector<double> truth = capture(fresh);
      Scene scene(way == LAYER, samples);
      make(scene);
      // Attached, so that the buffers stay.
      if (way != NESTED)
      {
        vtkRelievoPass::Attach(scene.Renderer)->RequestLayer("color");
      }
      capture(scene);
      scene.Renderer->GetActiveCamera()->Azimuth(30.0);
      scene.Renderer->GetActiveCamera()->SetFocalPoint(0.5, 0.0, 0.0);
      const std::vector<double> second = capture(scene);
      RELIEVO_CHECK_THAT(GetDifference(second, truth) == 0.0, what + "another colour");
      const bool kept = way == LAYER || way == NOT_ERASED || way == KEEPS_COLOR;
      const std::vector<double> corner(second.begin(), second.begin() + 4);
      if (kept)
      {
        RELIEVO_CHECK_THAT((corner == std::vector<double>{ 0.0, 0.0, 0.0, 0.0 }), what + "corner");
      }
      else
      {
        RELIEVO_CHECK_THAT(corner[2] > 0.1 && corner[0] < 0.02, what + "no background");
      }
    }
  }
}

// Drawing over the finished picture stays within its renderer.
void TestScissor()
{
  for (const int samples : { 0, 8 })
  {
    for (const bool above : { false, true })
    {
      Scene scene(above, samples);
      scene.Renderer->SetViewport(0.4, 0.3, 0.7, 0.8);
      scene.AddBar(-30.0, 200.0);
      scene.Window->SetSwapBuffers(false);
      scene.Window->Render();
      const std::vector<unsigned char> plain = GetWindow(scene.Window);
      vtkRelievoPass::Attach(scene.Renderer)->RequestLayer("color");
      scene.Window->Render();
      const std::vector<unsigned char> through = GetWindow(scene.Window);
      int most = 0;
      for (std::size_t i = 0; i < plain.size(); ++i)
      {
        most = std::max(most, std::abs(plain[i] - through[i]));
      }
      RELIEVO_CHECK_AT_MOST(most, samples && above ? 2 : 1,
        std::to_string(samples) + " samples" + (above ? ", in a layer above" : ""));
    }
  }
}
}

RELIEVO_TEST_CASE(testFrameCapture)
{
  relievoTest::Session session;
  TestTexts();
  TestNoGhosts();
  TestScissor();
  return session.Result();
}
}
