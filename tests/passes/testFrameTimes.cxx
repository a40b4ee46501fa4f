// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Times of the frame report belong to the stage that did the work, also where OpenGL in software
// draws long after the commands; frames that nobody wants times of are not slowed for them.
#include "Check.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "Window.h"

#include <vtkLight.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowPass.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <string>

namespace
{
// A stage's milliseconds in a report, or the frame's; negative if it has none.
double GetTime(const std::string& report, const std::string& stage)
{
  const std::string name = "\"name\": \"" + stage + "\"";
  std::size_t from = stage == "frame" ? report.find("  ],") : report.find(name);
  from = report.find("\"gpu_ms\": ", from);
  RELIEVO_CHECK(from != std::string::npos);
  const std::string number = report.substr(from + 10);
  return number.compare(0, 4, "null") == 0 ? -1.0 : std::stod(number);
}

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
  RELIEVO_CHECK(!isSoftware || GetTime(early, "shadows") < 0.0); // nothing is better than wrong

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
    const double shadows = GetTime(report, "shadows");
    const double frame = GetTime(report, "frame");
    std::cout << (moves ? "moves: " : "stands: ") << shadows << " ms of " << frame
              << ", by the clock " << time << "\n";
    RELIEVO_CHECK(shadows > 0.0 && shadows <= frame);
    RELIEVO_CHECK(GetTime(report, "delegate") <= frame);
    RELIEVO_CHECK(!isSoftware || frame <= time);
    (moves ? moving : still) = std::min(moves ? moving : still, shadows);
  }
  // Sixteen million texels take their time; timestamps in software say a thousandth of it.
  RELIEVO_CHECK(moving > 2.0 * still);
}
}

//------------------------------------------------------------------------------
int main()
{
  relievoTest::Session session;
  TestMapsThatAreDrawn();
  return session.Result();
}
