// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Soft shadows from frame to frame: events that restart the accumulation, the samples in a
// picture's mean, captures and tiles, and no trace afterwards.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "ShadowPictures.h"
#include "SoftStage.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkImageFlip.h>
#include <vtkLight.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderWindow.h>
#include <vtkSSAOPass.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>
#include <vtkWindowToImageFilter.h>

#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace testShadowSoftFrames
{
namespace
{
using relievoTest::CountUnlike;
using relievoTest::Layers;
using relievoTest::SamePicture;

void TestGathering()
{
  SoftStage stage(0);
  const relievoTest::GLCheck gl(stage.Window);
  vtkRelievoPass* frame = stage.GetFrame();
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  const auto hard = Picture(stage.Window);
  const vtkIdType bytes = frame->GetBytesHeld();
  RELIEVO_CHECK(frame->GetSamplesLeft() == 0);
  shadows->SetSoftSamples(1);
  SamePicture(hard, Picture(stage.Window), "one sample");
  RELIEVO_CHECK(frame->GetBytesHeld() == bytes);

  shadows->SetSoftSamples(Samples);
  for (int left = Samples - 1; left >= 0; --left)
  {
    Picture(stage.Window);
    RELIEVO_CHECK_THAT(frame->GetSamplesLeft() == left,
      std::to_string(frame->GetSamplesLeft()) + " samples left, not " + std::to_string(left));
    RELIEVO_CHECK_THAT(frame->GetFrameReport().find("\"soft_gathered\": " +
                         std::to_string(Samples - left)) != std::string::npos,
      "the report: " + frame->GetFrameReport());
  }
  const auto soft = Picture(stage.Window);
  RELIEVO_CHECK(shadows->GetNumberOfMapsDrawn() == 0);
  RELIEVO_CHECK(CountUnlike(hard, soft, 8) > 100);
  SamePicture(soft, Picture(stage.Window), "a frame after the last");
  shadows->SoftAtOnceOn();
  SamePicture(soft, Picture(stage.Window), "all at once");
  shadows->SoftAtOnceOff();
  frame->WaitForSamplesOn();
  SamePicture(soft, Picture(stage.Window), "a frame that waits");
  frame->WaitForSamplesOff();

  shadows->SetSunAngle(0.);
  shadows->SetLampRadius(0.);
  SamePicture(hard, Picture(stage.Window), "lights without a size");
  RELIEVO_CHECK(frame->GetSamplesLeft() == 0);
  shadows->SetSunAngle(8.);
  shadows->SetSoftSamples(0);
  SamePicture(hard, Picture(stage.Window), "hard again");
  RELIEVO_CHECK(frame->GetBytesHeld() == bytes);
}

// After each change the picture is that of a gathering that was never of anything else.
void TestChanges()
{
  struct Change
  {
    const char* What;
    std::function<void(SoftStage&)> Make;
  };
  const std::vector<Change> changes = {
    { "camera", [](SoftStage& s) { s.Renderer->GetActiveCamera()->Azimuth(5.); } },
    { "clipping range",
      [](SoftStage& s) { s.Renderer->GetActiveCamera()->SetClippingRange(0.5, 40.); } },
    { "actor", [](SoftStage& s) { s.Box->SetPosition(-0.3, 0.2, 0.1); } },
    { "points",
      [](SoftStage& s) {
        auto* mesh = vtkPolyDataMapper::SafeDownCast(s.Box->GetMapper())->GetInput();
        mesh->GetPoints()->SetPoint(0, 0.5, 0.5, 0.5);
        mesh->GetPoints()->Modified();
      } },
    { "colour", [](SoftStage& s) { s.Box->GetProperty()->SetColor(0.9, 0.1, 0.1); } },
    { "visibility", [](SoftStage& s) { s.Box->VisibilityOff(); } },
    { "light's place", [](SoftStage& s) { s.Sun->SetPosition(-3., 4., -1.); } },
    { "light's intensity", [](SoftStage& s) { s.Lamp->SetIntensity(0.2); } },
    { "light's size", [](SoftStage& s) { s.GetShadows()->SetLightSize(s.Lamp, 0.4); } },
    { "strength", [](SoftStage& s) { s.GetShadows()->SetStrength(0.5); } },
    { "map's size", [](SoftStage& s) { s.GetShadows()->SetMapSize(200); } },
    { "background", [](SoftStage& s) { s.Renderer->SetBackground(0.1, 0.2, 0.3); } },
    { "window", [](SoftStage& s) { s.Window->SetSize(70, 66); } },
    { "clipping plane", [](SoftStage& s) { s.Plane->SetOrigin(0.3, 0., 0.); } },
    { "image of a texture", [](SoftStage& s) { s.Image->SetFilteredAxis(1); } },
    { "uniform",
      [](SoftStage& s) {
        s.Sheet->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf("shade", 0.2f);
      } },
    { "glyphs' block", [](SoftStage& s) { s.Blocks->SetBlockVisibility(s.Block, false); } },
    { "setting of a delegate", [](SoftStage& s) { s.Occlusion->SetRadius(0.1); } },
  };
  SoftStage stage(4);
  stage.AddSubObjects();
  for (const Change& change : changes)
  {
    stage.Window->Render();
    stage.Window->Render();
    RELIEVO_CHECK_THAT(stage.GetFrame()->GetSamplesLeft() < 3,
      std::string("nothing is gathered before another ") + change.What);
    change.Make(stage);
    const auto gathered = stage.DrawAll();
    RELIEVO_CHECK_THAT(
      stage.GetFrame()->GetSamplesLeft() == 0, std::string("after another ") + change.What);
    stage.GetShadows()->SetSoftSamples(0);
    stage.Window->Render(); // the accumulated samples are gone
    stage.GetShadows()->SetSoftSamples(4);
    SamePicture(stage.DrawAll(), gathered, std::string("after another ") + change.What);
  }
  SoftStage fresh(4);
  fresh.AddSubObjects();
  for (const Change& change : changes)
  {
    change.Make(fresh);
  }
  SamePicture(fresh.DrawAll(), stage.DrawAll(), "after all changes");
}

// A capture accumulates its own samples and leaves the window's picture unchanged.
void TestCaptures()
{
  SoftStage stage;
  const auto all = SoftStage().DrawAll();
  Picture(stage.Window);
  Picture(stage.Window);
  const Layers own(stage.Renderer, { "shadow_0", "shadow_1", "depth" });
  RELIEVO_CHECK(stage.GetFrame()->GetSamplesLeft() == Samples - 2);
  stage.Window->Render();
  RELIEVO_CHECK(stage.GetFrame()->GetSamplesLeft() == Samples - 3);
  SamePicture(all, stage.DrawAll(), "gathered around a capture");
  stage.GetShadows()->SoftAtOnceOn();
  const Layers shared(
    stage.Renderer, { "shadow_0", "shadow_1", "depth" }, relievoTest::Way::Shared);
  RELIEVO_CHECK(relievoTest::CountDifferent(own, shared, "shadow_0") == 0);
  RELIEVO_CHECK(relievoTest::CountDifferent(own, shared, "shadow_1") == 0);
  auto* shares = vtkFloatArray::SafeDownCast(own.Image->GetPointData()->GetArray("shadow_1"));
  int between = 0;
  for (vtkIdType i = 0; i < shares->GetNumberOfTuples(); ++i)
  {
    between += shares->GetValue(i) > 0.1f && shares->GetValue(i) < 0.9f ? 1 : 0;
  }
  RELIEVO_CHECK(between > 40);

  // Shown as the picture, the layer is gathered, and the colour is not.
  stage.GetShadows()->SoftAtOnceOff();
  stage.GetFrame()->SetDisplayLayer("shadow_1");
  const auto shown = stage.DrawAll();
  auto* levels = shown->GetPointData()->GetScalars();
  int mismatches = 0;
  for (vtkIdType i = 0; i < shares->GetNumberOfTuples(); ++i)
  {
    const bool hit = own.Image->GetPointData()->GetArray("depth")->GetComponent(i, 0) < 1e6;
    mismatches +=
      hit && std::abs(levels->GetComponent(i, 0) - 255. * shares->GetValue(i)) > 1. ? 1 : 0;
  }
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "pixels that show another share than the layer's");
}

// A picture in tiles has all samples in each, and equals that of a larger window.
void TestTiles()
{
  SoftStage large(Samples, 160, 120);
  const auto whole = large.DrawAll();
  SoftStage stage;
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(stage.Window);
  filter->SetScale(2);
  filter->ReadFrontBufferOff();
  filter->Update();
  RELIEVO_CHECK_AT_MOST(
    CountUnlike(whole, filter->GetOutput(), 3), 160 * 120 / 400, "pixels unlike in tiles");
}

void TestOtherPictures()
{
  // Samples of a pixel: the mean of its own.
  SoftStage stage;
  const auto plain = stage.DrawAll();
  SoftStage smooth;
  smooth.Window->SetMultiSamples(4);
  const auto multisampled = smooth.DrawAll();
  RELIEVO_CHECK_AT_MOST(CountUnlike(plain, multisampled, 40), 250, "pixels unlike with 4 samples");
  SoftStage deferred;
  deferred.GetFrame()->DeferredOn();
  RELIEVO_CHECK_AT_MOST(
    CountUnlike(plain, deferred.DrawAll(), 4), 30, "pixels unlike with deferred shading");
  for (const int method : { 1, 3 })
  {
    SoftStage other;
    other.GetShadows()->SetMethod(method);
    const auto picture = other.DrawAll();
    std::cout << "method " << method << ": " << CountUnlike(plain, picture, 60)
              << " pixels far from map's\n";
    RELIEVO_CHECK_AT_MOST(CountUnlike(plain, picture, 60), 40, "pixels unlike by another method");
  }
  // Where there is no linear colour shadows stay hard.
  SoftStage kept;
  kept.Renderer->PreserveDepthBufferOn();
  kept.Window->Render();
  RELIEVO_CHECK(kept.GetFrame()->GetSamplesLeft() == 0);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowSoftFrames)
{
  relievoTest::Session session;
  TestGathering();
  TestChanges();
  TestCaptures();
  TestTiles();
  TestOtherPictures();
  return session.Result();
}
}
