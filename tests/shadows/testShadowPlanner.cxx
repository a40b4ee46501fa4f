// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner of shadows: its choice for a tolerance meets it, on scenes that no estimate was
// fitted to; the choice does not depend on earlier frames; reports; times; refused goals.
#include "Check.h"
#include "EmbreeScene.h"
#include "Scenes.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "ShadowScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace testShadowPlanner
{
namespace
{
using Pass = vtkRelievoShadowStage;
using relievoTest::ShadowStage;

std::pair<int, int> GetWay(Pass* shadows)
{
  const int method = shadows->GetMethodUsed();
  return { method, method == Pass::METHOD_EXACT ? 0 : shadows->GetMapSizeUsed() };
}

void TestTolerances(ShadowStage& stage, const std::string& what)
{
  Pass* shadows = stage.GetShadows();
  stage.GetFrame()->ShadowsOn();
  for (const double tolerance : { 2e-3, 5e-4, 4e-5, 2e-5 })
  {
    shadows->SetTolerance(tolerance);
    stage.Window->Render();
    const relievoTest::ShadowErrors errors = relievoTest::JudgeShadow(stage, 0);
    std::cout << what << ": " << shadows->GetPlan() << "; " << errors.ToString() << "\n";
    RELIEVO_CHECK_THAT(errors.Compared > 3000, what + ": what is compared");
    // Exact shadows are chosen for the last two. They may be expected to miss the last: it is said.
    const bool exact = shadows->GetMethodUsed() == Pass::METHOD_EXACT;
    RELIEVO_CHECK_THAT(exact || tolerance > 1e-4, what + ": maps for a small tolerance");
    const double expected =
      exact ? shadows->EstimateWrongShareInView(Pass::METHOD_EXACT, 1) : tolerance;
    RELIEVO_CHECK_AT_MOST(
      errors.Wrong() / std::max(expected, tolerance), 1.5, what + ": share over what is expected");
    const bool met = shadows->GetPlan().find("the tolerance is not met") == std::string::npos;
    RELIEVO_CHECK_THAT(met == (expected <= tolerance), what + ": " + shadows->GetPlan());
    RELIEVO_CHECK(met || tolerance < 4e-5);
  }
}

void TestScenes()
{
  {
    ShadowStage stage;
    stage.AddThings();
    stage.AddSun(-3., 4., -2.);
    TestTolerances(stage, "things, sun");
  }
  {
    ShadowStage stage(300, 120, 1e3, { 5e5, 0., 2e4 });
    stage.AddThings();
    stage.AddLamp({ -1.5, 3., -1. }, { 0., 0., 0. }, 90.);
    TestTolerances(stage, "things far away, point");
  }
  {
    ShadowStage stage(320, 200);
    stage.AddPolesToHorizon();
    TestTolerances(stage, "poles");
  }
}

// Without a goal the settings apply, without any message.
void TestNoWish()
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  stage.Window->Render();
  Pass* shadows = stage.GetShadows();
  RELIEVO_CHECK(GetWay(shadows) == std::make_pair(int(Pass::METHOD_MAP), 2048));
  RELIEVO_CHECK(shadows->GetPlan().empty() && shadows->GetExpectedMilliseconds() == -1. &&
    shadows->GetMillisecondsTaken() == -1.);
  const std::string report = stage.GetFrame()->GetFrameReport();
  RELIEVO_CHECK(report.find("\"shadow_plan\": null") != std::string::npos);
}

// A camera that goes around the scene and comes back, with a tolerance that changes: each place has
// its choice, whatever was drawn before.
void TestCameraPath()
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  Pass* shadows = stage.GetShadows();
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  const double away = camera->GetDistance();
  const auto go = [&](int place) {
    const double angle = 0.03 * place;
    camera->SetFocalPoint(0., 0.5, 0.);
    camera->SetPosition(away * std::sin(angle), 0.5 + 0.4 * away, away * std::cos(angle));
    stage.Renderer->ResetCameraClippingRange();
    shadows->SetTolerance(place % 3 == 0 ? 2e-5 : 2e-3);
    stage.Window->Render();
    return GetWay(shadows);
  };
  constexpr int Places = 15;
  std::vector<std::pair<int, int>> ways;
  int exact = 0;
  for (int i = 0; i < Places; ++i)
  {
    ways.push_back(go(i));
    exact += ways.back().first == Pass::METHOD_EXACT ? 1 : 0;
  }
  RELIEVO_CHECK_THAT(exact >= Places / 3 && exact < Places, "one method for all tolerances");
  int unlike = 0;
  for (int i = Places - 1; i >= 0; --i)
  {
    unlike += go(i) != ways[i] ? 1 : 0;
  }
  RELIEVO_CHECK_AT_MOST(unlike, 0, "choices that depend on the way there");
}

// Tiles of a large picture are made as the picture is.
void TestTiles()
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddBox({ 2.2, 0.2, 1.8 }, { 0.05, 0.2, 0.05 });
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  Pass* shadows = stage.GetShadows();
  std::vector<std::pair<int, int>> ways;
  std::vector<double> shares;
  auto note = [&]() {
    ways.push_back(GetWay(shadows));
    shares.push_back(shadows->EstimateWrongShareInView(Pass::METHOD_MAP, 1024));
  };
  using Note = decltype(note);
  vtkNew<vtkCallbackCommand> drawn;
  drawn->SetClientData(&note);
  drawn->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { (*static_cast<Note*>(data))(); });
  for (const double tolerance : { 2e-3, 1e-3, 7e-4, 5e-4, 3e-4 })
  {
    shadows->SetTolerance(tolerance);
    ways.clear();
    shares.clear();
    const unsigned long observer = stage.Window->AddObserver(vtkCommand::EndEvent, drawn);
    vtkNew<vtkWindowToImageFilter> tiles;
    tiles->SetInput(stage.Window);
    tiles->SetScale(2);
    tiles->Update();
    stage.Window->RemoveObserver(observer);
    stage.Window->SetSize(480, 360);
    stage.Window->Render();
    const double whole = shadows->EstimateWrongShareInView(Pass::METHOD_MAP, 1024);
    RELIEVO_CHECK(ways.size() >= 4);
    for (std::size_t tile = 0; tile < ways.size(); ++tile)
    {
      RELIEVO_CHECK_THAT(ways[tile] == GetWay(shadows), "a tile of another choice");
      RELIEVO_CHECK_NEAR(shares[tile] / whole, 1., 0.02, "a tile's share");
    }
    stage.Window->SetSize(240, 180);
  }
}

// Props that enter the view, and the way back: the expectation at a place is equal. It follows mere
// receivers and culled sides.
void TestEntering()
{
  ShadowStage stage;
  const auto ground = stage.AddGround();
  const auto box = stage.AddBox({ 0.8, 0.5, 0. }, { 0.2, 0.5, 0.2 });
  stage.AddBox({ 2.4, 0.5, 0.5 }, { 0.2, 0.5, 0.2 });
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  Pass* shadows = stage.GetShadows();
  shadows->SetTolerance(1e-3);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  const auto go = [&](int place) {
    const double x = 0.01 * place;
    camera->SetFocalPoint(x, 0.3, 0.);
    camera->SetPosition(x, 1.5, 3.);
    camera->SetClippingRange(0.1, 20.);
    stage.Window->Render();
    return shadows->EstimateWrongShareInView(Pass::METHOD_MAP, 1024);
  };
  constexpr int Places = 40;
  std::vector<double> shares;
  for (int i = 0; i < Places; ++i)
  {
    shares.push_back(go(i));
  }
  int unlike = 0;
  for (int i = Places - 1; i >= 0; --i)
  {
    unlike += go(i) != shares[i] ? 1 : 0;
  }
  RELIEVO_CHECK_AT_MOST(unlike, 0, "shares that depend on the way there");
  const double before = go(0);
  shadows->SetPropReceives(ground, false);
  RELIEVO_CHECK_THAT(go(0) != before, "what receives: nothing new");
  shadows->SetPropReceives(ground, true);
  RELIEVO_CHECK_THAT(go(0) == before, "what receives: not as before");
  shadows->SetPropCasts(ground, Pass::CASTS_NEVER);
  const double receives = go(0);
  ground->SetPosition(0., -0.4, 0.);
  RELIEVO_CHECK_THAT(go(0) != receives, "what merely receives has moved: nothing new");
  box->GetProperty()->SetFrontfaceCulling(1);
  const double moved = go(0);
  box->GetProperty()->SetFrontfaceCulling(0);
  RELIEVO_CHECK_THAT(go(0) != moved, "what is culled: nothing new");
}

// Without lights nothing is planned, nor said.
void TestLightsGone()
{
  ShadowStage stage;
  stage.AddThings();
  const auto sun = stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  Pass* shadows = stage.GetShadows();
  shadows->SetTolerance(1e-3);
  stage.Window->Render();
  RELIEVO_CHECK(!shadows->GetPlan().empty());
  sun->SwitchOff();
  stage.Window->Render();
  RELIEVO_CHECK(shadows->GetPlan().empty() && shadows->GetMillisecondsTaken() == -1.);
}

void TestTimes()
{
  ShadowStage stage(480, 360); // in smaller pictures rays are the fastest
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  Pass* shadows = stage.GetShadows();
  shadows->SetTimeBudget(1e6);
  for (int frame = 0; frame < 4; ++frame)
  {
    stage.Window->Render();
  }
  RELIEVO_CHECK(shadows->GetMethodUsed() == Pass::METHOD_EXACT);
  RELIEVO_CHECK(shadows->GetMillisecondsTaken() > 0. && shadows->GetExpectedMilliseconds() > 0.);
  const std::string report = stage.GetFrame()->GetFrameReport();
  for (const char* words : { "exact was chosen for a time of 1e+06 ms",
         "\"frame_ms\": ", "\"expected_frame_ms\": ", "\"shadow_plan\": \"exact was chosen" })
  {
    RELIEVO_CHECK_THAT(report.find(words) != std::string::npos, words);
  }
  RELIEVO_CHECK(report.find("\"frame_ms\": null") == std::string::npos);
  // No way fits: the cheapest, and it is said.
  shadows->SetTimeBudget(1e-3);
  stage.Window->Render();
  RELIEVO_CHECK(GetWay(shadows) == std::make_pair(int(Pass::METHOD_MAP), 1024));
  RELIEVO_CHECK_THAT(
    shadows->GetPlan().find("the time is not met") != std::string::npos, shadows->GetPlan());
  // With both, the tolerance comes first.
  shadows->SetTolerance(3e-5);
  stage.Window->Render();
  RELIEVO_CHECK(shadows->GetMethodUsed() == Pass::METHOD_EXACT);
  RELIEVO_CHECK_THAT(
    shadows->GetPlan().find(": the time is not met") != std::string::npos, shadows->GetPlan());
  shadows->SetTolerance(1e-7);
  shadows->SetTimeBudget(0.);
  stage.Window->Render();
  RELIEVO_CHECK_THAT(
    shadows->GetPlan().find(": the tolerance is not met") != std::string::npos, shadows->GetPlan());
  shadows->SetTolerance(0.);
  stage.Window->Render();
  RELIEVO_CHECK(GetWay(shadows) == std::make_pair(int(Pass::METHOD_MAP), 2048));
}

void TestRefusals()
{
  ShadowStage stage;
  Pass* shadows = stage.GetShadows();
  shadows->SetTolerance(0.001);
  shadows->SetTimeBudget(20.);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  {
    const relievoTest::ExpectMessage expected("SetTolerance was given");
    for (const double invalid : { -0.1, 1.1, nan })
    {
      shadows->SetTolerance(invalid);
    }
  }
  {
    const relievoTest::ExpectMessage expected("SetTimeBudget was given");
    for (const double invalid : { -1., HUGE_VAL, nan })
    {
      shadows->SetTimeBudget(invalid);
    }
  }
  {
    const relievoTest::ExpectMessage expected("the last frame made no shadows");
    RELIEVO_CHECK(shadows->EstimateWrongShareInView(Pass::METHOD_MAP, 1024) == -1.);
  }
  RELIEVO_CHECK(shadows->GetTolerance() == 0.001 && shadows->GetTimeBudget() == 20.);
  RELIEVO_CHECK(!shadows->TrySetParameter("tolerance", "2").empty());
  RELIEVO_CHECK(shadows->TrySetParameter("tolerance", "0.0005").empty());
  RELIEVO_CHECK(shadows->GetTolerance() == 0.0005);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowPlanner)
{
  relievoTest::Session session;
  TestNoWish();
  TestTimes();
  TestRefusals();
  TestScenes();
  TestCameraPath();
  TestTiles();
  TestEntering();
  TestLightsGone();
  return session.Result();
}
}
