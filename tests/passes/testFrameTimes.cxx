// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Times of the frame report belong to the stage that did the work, even if software OpenGL draws
// long after the commands; frames whose times are not requested are not slowed.
#include "Check.h"
#include "ColorStage.h"
#include "FrameTimes.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkLight.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <string>

namespace testFrameTimes
{
namespace
{
using relievoTest::FrameTimes;

double Render(relievoTest::ShadowStage& stage)
{
  const auto start = std::chrono::steady_clock::now();
  stage.Window->Render();
  stage.Window->WaitForCompletion();
  return 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void TestMapsThatAreDrawn()
{
  relievoTest::ShadowStage stage;
  stage.AddThings();
  auto sun = stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  stage.GetShadows()->SetMapSize(4096); // many more texels than the picture has pixels
  for (int i = 0; i < 5; ++i)
  {
    Render(stage);
  }
  const std::string early = stage.GetFrame()->GetFrameReport();
  const bool isSoftware = early.find("\"untimed\"") != std::string::npos;
  std::cout << (isSoftware ? "software" : "hardware") << " OpenGL\n" << early;
  // Nothing is better than wrong.
  RELIEVO_CHECK(!isSoftware || FrameTimes(early).Stages.at("shadows") < 0.0);

  // A light that moves has its map drawn anew in every frame; one that stands has not.
  // The least of several: a machine that does other work takes longer, never less.
  double moving = 1e30;
  double still = 1e30;
  for (int i = 0; i < 6; ++i)
  {
    const bool moves = i < 3;
    double time = 0.0;
    for (int k = 0; k < 4; ++k) // GPU times arrive some frames later
    {
      sun->SetPosition(-3. + (moves ? 0.1 * k + i : 0.), 4., -2.);
      time = Render(stage);
      const bool first = i == 0 && k == 0; // it stands where it stood
      const bool back = i == 3 && k == 0;
      RELIEVO_CHECK(
        stage.GetShadows()->GetNumberOfMapsDrawn() == ((moves && !first) || back ? 1 : 0));
      stage.GetFrame()->GetFrameReport();
    }
    const std::string report = stage.GetFrame()->GetFrameReport();
    const FrameTimes times(report);
    RELIEVO_CHECK_THAT(times.Judge().empty(), times.Judge() + "\n" + report);
    const double shadows = times.Stages.at("shadows");
    std::cout << (moves ? "moves: " : "stands: ") << shadows << " ms of " << times.Frame
              << ", by the clock " << time << "\n";
    // In software the report is of the frame that was drawn last, whose commands are waited for.
    RELIEVO_CHECK(!isSoftware || times.Frame <= time);
    (moves ? moving : still) = std::min(moves ? moving : still, shadows);
  }
  // Sixteen million texels take their time; timestamps in software say a thousandth of it.
  RELIEVO_CHECK(!isSoftware || moving > 2.0 * still);
}

// Stages that draw while the delegate does, before its texts, or after it: no work is another's.
void TestOwnWork()
{
  relievoTest::ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  vtkRelievoPass* frame = stage.GetFrame();
  frame->ShadowsOn();
  frame->RequestLayer("depth");
  vtkNew<relievoTest::ColorStage> color;
  frame->AddStage(color);
  for (const bool own : { false, true })
  {
    frame->GetLayersStage()->SetShareGeometryPass(!own);
    frame->GetFrameReport();
    for (int i = 0; i < 8; ++i)
    {
      Render(stage);
    }
    const std::string report = frame->GetFrameReport();
    const FrameTimes times(report);
    RELIEVO_CHECK_THAT(times.Judge().empty(), times.Judge() + "\n" + report);
    RELIEVO_CHECK(times.Stages.count("gbuffer") && times.Stages.count("shift"));
    RELIEVO_CHECK(times.Stages.size() == 4);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testFrameTimes)
{
  relievoTest::Session session;
  TestMapsThatAreDrawn();
  TestOwnWork();
  return session.Result();
}
}
