// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ambient occlusion in several processes that each have a part of the scene: the nearest of their
// pictures and layers equals the result of one process, and all accumulate samples together,
// whatever moves in one of them or lacks memory.
#include "Check.h"
#include "Layers.h"
#include "Props.h"
#include "Ranks.h"
#include "Session.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeSource.h>
#include <vtkImageData.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoAmbientStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoTextureBuffer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace testAmbientRanks
{
namespace
{
constexpr int Width = 120;
constexpr int Height = 90;
constexpr int Pixels = Width * Height;
constexpr int Values = 5; // of a pixel: depth, the sky's share, colour
constexpr int Frames = 4; // that gather all samples

// A process's part of the scene: all props, but only its own mesh.
struct Part
{
  int Rank;
  int Last;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkRelievoPass* Frame = nullptr;
  vtkRelievoAmbientStage* Stage = nullptr;
  vtkSmartPointer<vtkActor> Tall;
  vtkSmartPointer<vtkActor> Low;

  explicit Part(vtkMultiProcessController* controller)
    : Rank(controller->GetLocalProcessId())
    , Last(controller->GetNumberOfProcesses() - 1)
  {
    this->Window = relievoTest::MakeWindow(Width, Height, this->Renderer);
    this->Frame = vtkRelievoPass::Attach(this->Renderer);
    this->Frame->SetController(controller);
    this->Stage = vtkRelievoAmbientStage::SafeDownCast(this->Frame->GetStage("ambient"));
    this->Stage->EnabledOn();
    this->Stage->SetSamples(16);
    this->Stage->SetSamplesPerFrame(16 / Frames);
    vtkNew<vtkPlaneSource> ground;
    ground->SetOrigin(-3., -3., 0.);
    ground->SetPoint1(3., -3., 0.);
    ground->SetPoint2(-3., 3., 0.);
    this->Add(ground, this->Last);
    this->Tall = this->AddBox({ 0.2, 0.1, 0.8 }, { 1., 0.6, 1.6 }, 0);
    this->Low = this->AddBox({ -0.9, -0.3, 0.3 }, { 1., 0.8, 0.6 }, std::min(1, this->Last));
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(-1., -7., 5.);
    camera->SetFocalPoint(0., 0., 0.5);
    camera->SetViewUp(0., 0., 1.);
    camera->SetClippingRange(3., 16.);
  }

  vtkSmartPointer<vtkActor> Add(vtkPolyDataAlgorithm* source, int owner)
  {
    source->Update();
    vtkNew<vtkPolyData> nothing;
    return relievoTest::AddActor(
      this->Renderer, owner == this->Rank ? source->GetOutput() : nothing.GetPointer());
  }

  vtkSmartPointer<vtkActor> AddBox(
    const std::vector<double>& center, const std::vector<double>& size, int owner)
  {
    vtkNew<vtkCubeSource> box;
    box->SetCenter(center.data());
    box->SetXLength(size[0]);
    box->SetYLength(size[1]);
    box->SetZLength(size[2]);
    return this->Add(box, owner);
  }

  // Appends the window's next frame, and layers of a capture if there are any.
  void Record(bool there, std::vector<float>& numbers)
  {
    const auto picture = relievoTest::Picture(this->Window);
    const relievoTest::Layers layers(this->Renderer,
      there ? std::vector<std::string>{ "depth", "ambient" } : std::vector<std::string>{ "depth" });
    for (int i = 0; i < Pixels; ++i)
    {
      numbers.push_back(static_cast<float>(layers.Value("depth", i % Width, i / Width)));
      numbers.push_back(
        there ? static_cast<float>(layers.Value("ambient", i % Width, i / Width)) : 1.f);
      for (int channel = 0; channel < 3; ++channel)
      {
        numbers.push_back(
          static_cast<float>(picture->GetPointData()->GetScalars()->GetComponent(i, channel)));
      }
    }
  }
};

struct Step
{
  std::string Name;
  int Left; // samples that the frame is short of
  std::function<void(Part&)> Do;
  bool Made = true;
};

// Changes in one process, unknown to the others.
const std::vector<Step> Steps = {
  { "first", Frames - 1, [](Part&) {} },
  { "second", Frames - 2, [](Part&) {} },
  { "moved on the first", Frames - 1,
    [](Part& part) {
      if (part.Rank == 0)
      {
        part.Tall->AddPosition(-0.3, -0.4, 0.);
      }
    } },
  { "second after it", Frames - 2, [](Part&) {} },
  { "all at once", 0, [](Part& part) { part.Frame->WaitForSamplesOn(); } },
  { "hidden where it is", 0,
    [](Part& part) {
      if (part.Rank == std::min(1, part.Last))
      {
        part.Low->VisibilityOff();
      }
    } },
  { "shown, and the camera", 0,
    [](Part& part) {
      part.Low->VisibilityOn();
      part.Renderer->GetActiveCamera()->SetPosition(2., -6., 4.);
    } },
  { "no room on the last", 0,
    [](Part& part) {
      if (part.Rank == part.Last)
      {
        vtkRelievoTextureBuffer::SetMostTexels(16);
      }
      part.Tall->RotateZ(10.);
    },
    false },
  { "room", 0,
    [](Part& part) {
      vtkRelievoTextureBuffer::SetMostTexels(0);
      part.Tall->RotateZ(10.);
    } },
};

std::vector<float> DrawAll(vtkMultiProcessController* controller)
{
  std::vector<float> numbers;
  Part part(controller);
  for (const Step& step : Steps)
  {
    step.Do(part);
    const std::unique_ptr<relievoTest::ExpectMessage> expected(!step.Made && part.Rank == 0
        ? new relievoTest::ExpectMessage("There is no ambient occlusion")
        : nullptr);
    part.Record(step.Made, numbers);
    RELIEVO_CHECK_THAT(!expected || expected->Count() == 1, step.Name + ": one message");
    RELIEVO_CHECK_THAT(part.Frame->GetSamplesLeft() == step.Left,
      step.Name + ": process " + std::to_string(part.Rank) + " is short of " +
        std::to_string(part.Frame->GetSamplesLeft()));
    const std::string report = part.Stage->GetReason();
    const bool others = report.find(" of them from other processes") != std::string::npos;
    RELIEVO_CHECK_THAT(others == (step.Made && part.Last > 0), step.Name + ": " + report);
  }
  return numbers;
}
}

RELIEVO_TEST_CASE_APART(testAmbientRanks)
{
  relievoTest::Session session;
  const auto compare = [](int ranks, const float* one, const float* several) {
    for (const auto& step : Steps)
    {
      int unlike = 0;
      int dark = 0;
      for (int pixel = 0; pixel < Pixels; ++pixel, one += Values, several += Values)
      {
        unlike += std::equal(one, one + Values, several) ? 0 : 1;
        dark += one[1] < 0.9f ? 1 : 0;
      }
      const std::string what = step.Name + ", " + std::to_string(ranks) + " processes: ";
      RELIEVO_CHECK_AT_MOST(unlike, 0, what + "pixels that differ");
      RELIEVO_CHECK_THAT(dark > Pixels / 50 || !step.Made, what + std::to_string(dark));
    }
  };
  relievoTest::CompareRanks(DrawAll, Values, Steps.size() * Pixels * Values, compare);
  return session.Result();
}
}
