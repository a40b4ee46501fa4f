// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Arrays may have any name: those named like stages' resources are read and shown like any other,
// and nothing else is drawn for them.
#include "Check.h"
#include "ColorStage.h"
#include "GLCheck.h"
#include "NamedSquare.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkUnsignedCharArray.h>

namespace testFrameArrays
{
namespace
{
using relievoTest::ColorStage;
using relievoTest::IsSame;
using relievoTest::Picture;
using Scene = relievoTest::NamedSquare;

const std::vector<std::string>& Names = relievoTest::ResourceNames;

std::string Pixels(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetRGBACharPixelData(0, 0, 59, 49, 0, bytes);
  return std::string(reinterpret_cast<char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
}

double Middle(vtkImageData* image, const std::string& name)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name.c_str());
  return RELIEVO_CHECK_THAT(array, name) ? array->GetComponent(25 * 60 + 30, 0) : -1.0;
}

void TestArrays()
{
  Scene scene;
  relievoTest::GLCheck gl(scene.Window);
  scene.Window->SetSwapBuffers(false);
  const auto plain = Picture(scene.Window);
  const std::string pixels = Pixels(scene.Window);
  scene.Renderer->SetBackground(0.3, 0.7, 0.1); // the next picture would be another
  for (const bool shadows : { false, true })
  {
    for (const bool hdr : { false, true })
    {
      vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
      frame->SetShadows(shadows);
      vtkNew<vtkRelievoLayerSource> layers;
      layers->SetRenderer(scene.Renderer);
      for (const std::string& name : Names)
      {
        layers->AddLayer(name);
      }
      if (hdr)
      {
        layers->AddLayer("color");
        layers->HDROn();
      }
      layers->Update();
      for (std::size_t i = 0; i < Names.size(); ++i)
      {
        RELIEVO_CHECK_NEAR(
          Middle(layers->GetOutput(), Names[i]), 1.0 + static_cast<double>(i), 1e-6, Names[i]);
      }
      if (hdr)
      {
        RELIEVO_CHECK(Middle(layers->GetOutput(), "color") > 0.1);
      }
      RELIEVO_CHECK_THAT(Pixels(scene.Window) == pixels, "the window has changed");
      vtkRelievoPass::Detach(scene.Renderer);
    }
  }
  // Arrays shown as the picture: each has one value and so one colour, another array another.
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  frame->SetDisplayRange(0.0, 5.0);
  std::vector<vtkSmartPointer<vtkImageData>> shown;
  for (const std::string& name : Names)
  {
    frame->SetDisplayLayer(name.c_str());
    shown.push_back(Picture(scene.Window));
    RELIEVO_CHECK_THAT(frame->GetStage("display")->GetReasonCode() == "ran",
      name + ": " + frame->GetStage("display")->GetReason());
    RELIEVO_CHECK_THAT(!IsSame(plain, shown.back()), name + " is not shown");
    RELIEVO_CHECK_THAT(shown.size() < 2 || !IsSame(shown.front(), shown.back()), name);
  }
  frame->SetDisplayLayer(nullptr);
  // Beside a stage on the colour.
  vtkNew<ColorStage> stage;
  frame->AddStage(stage);
  frame->RequestLayer("drawn");
  frame->RequestLayer("picture");
  const auto through = Picture(scene.Window);
  frame->ReleaseLayers();
  RELIEVO_CHECK(IsSame(through, Picture(scene.Window)));
  RELIEVO_CHECK(stage->Executed == 2);
  gl.Poll("arrays");
}
}

RELIEVO_TEST_CASE(testFrameArrays)
{
  relievoTest::Session session;
  TestArrays();
  return session.Result();
}
}
