// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The expected cost and error of shadows against the real ones: the share of wrong pixels against
// Embree and against the bench's measurements, bytes and draw calls of frames.
//   testShadowEstimate CSV (of the bench of shadows)
#include "Check.h"
#include "CsvFile.h"
#include "EmbreeScene.h"
#include "Layers.h"
#include "Scenes.h"
#include "Session.h"
#include "ShadowErrors.h"
#include "ShadowScenes.h"
#include "TestCase.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace testShadowEstimate
{
namespace
{
using Pass = vtkRelievoShadowStage;
using relievoTest::SceneLight;

const char* const Names[] = { "map", "forward", "warped" };
const int Methods[] = { Pass::METHOD_MAP, Pass::METHOD_FORWARD, Pass::METHOD_WARPED };

// The laws are the least squares of all that the bench measured on real meshes.
void TestLaws(const std::string& csv)
{
  const std::vector<relievoTest::Row> rows = relievoTest::ReadCsv(csv);
  const std::vector<std::string> meshes = relievoTest::ReferenceMeshes();
  vtkNew<vtkRelievoShadowStage> pass;
  for (const int method : Methods)
  {
    double n = 0.;
    double sumX = 0.;
    double sumY = 0.;
    double sumXX = 0.;
    double sumXY = 0.;
    double worst = 1.;
    for (const relievoTest::Row& row : rows)
    {
      if (row.at("method") != Names[method] || row.at("window") != "600x600" ||
        row.at("shading") != "flat" ||
        std::find(meshes.begin(), meshes.end(), row.at("scene")) == meshes.end())
      {
        continue;
      }
      const double size = relievoTest::Value(row, "map");
      const double error = 0.01 * relievoTest::Value(row, "wrong %");
      const double x = std::log(size / 2048.);
      const double y = std::log(error);
      n += 1.;
      sumX += x;
      sumY += y;
      sumXX += x * x;
      sumXY += x * y;
      const double ratio = error / pass->EstimateWrongShare(method, static_cast<int>(size));
      worst = std::max({ worst, ratio, 1. / ratio });
    }
    const double power = -(n * sumXY - sumX * sumY) / (n * sumXX - sumX * sumX);
    const double at2048 = std::exp((sumY + power * sumX) / n);
    std::cout << Names[method] << ": " << n << " values, " << at2048 << " (n / 2048)^-" << power
              << ", worst factor " << worst << "\n";
    RELIEVO_CHECK_THAT(n >= 20., "values of the bench");
    RELIEVO_CHECK_NEAR(pass->EstimateWrongShare(method, 2048) / at2048, 1., 0.02, Names[method]);
    RELIEVO_CHECK_NEAR(
      std::log2(pass->EstimateWrongShare(method, 1024) / pass->EstimateWrongShare(method, 2048)),
      power, 0.02, Names[method]);
    RELIEVO_CHECK_AT_MOST(worst, 2.5, Names[method]);
  }
}

void TestMesh(const std::string& mesh, SceneLight kind, const std::string& name)
{
  const auto scene = relievoTest::MakeReferenceScene(mesh, kind);
  if (!scene.IsValid())
  {
    return;
  }
  auto window = relievoTest::MakeWindow(600, 600, scene.Renderer);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  Pass* shadows = frame->GetShadowStage();
  frame->ShadowsOn();
  frame->RequestLayer("shadow_0");
  window->Render();
  const auto truth = scene.MakeTruth();
  const auto view = truth->Trace(relievoTest::View(scene.Renderer));
  const auto judged = relievoTest::TraceShadow(*truth, view, scene.Light);
  for (const int method : Methods)
  {
    for (const int size : { 512, 1024 })
    {
      const std::string what =
        mesh + ", " + name + ", " + Names[method] + " of " + std::to_string(size);
      shadows->SetMethod(method);
      shadows->SetMapSize(size);
      window->Render();
      const int draws = shadows->GetDrawCalls();
      vtkNew<vtkImageData> image;
      RELIEVO_CHECK(frame->ReadLayer("shadow_0", image));
      const auto errors = relievoTest::CompareShadow(judged,
        vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"))->GetPointer(0));
      const double expected = shadows->EstimateWrongShare(method, size);
      std::cout << what << ": " << errors.Wrong() << " wrong, " << expected << " expected; "
                << draws << " draw calls\n";
      RELIEVO_CHECK_THAT(errors.Compared > 10000 && errors.Dark > 1000, what);
      RELIEVO_CHECK_AT_MOST(errors.Wrong() / expected, 3., what + ": more wrong than expected");
      RELIEVO_CHECK_AT_MOST(expected / errors.Wrong(), 3., what + ": less wrong than expected");
      const int maps = shadows->GetNumberOfMaps();
      RELIEVO_CHECK_THAT(
        shadows->GetBytesHeld() == shadows->EstimateBytes(method, size, maps, 1, 600, 600),
        what + ": bytes");
      const int most = shadows->EstimateDrawCalls(method, maps, 2);
      RELIEVO_CHECK_THAT(shadows->GetNumberOfMapsDrawn() == maps && draws > 0 && draws <= most,
        what + ": draw calls");
      // Evenly spaced maps draw each of the two props once.
      RELIEVO_CHECK(method == Pass::METHOD_WARPED || draws == most);
    }
  }
}

// A camera close above a ground that extends to the horizon: its place and the visible surfaces are
// far apart, and the estimate by rays is that of the picture all the same.
void TestHorizon()
{
  relievoTest::ShadowStage stage(320, 240);
  stage.AddPolesToHorizon();
  Pass* shadows = stage.GetShadows();
  for (const double height : { 0.8, 0.3 })
  {
    stage.Renderer->GetActiveCamera()->SetPosition(0., height, 4.);
    for (const int size : { 512, 1024, 2048 })
    {
      const std::string what =
        "eye " + std::to_string(height) + " over the ground, map of " + std::to_string(size);
      shadows->SetMapSize(size);
      const auto errors = relievoTest::JudgeShadow(stage, 0);
      const double expected = shadows->EstimateWrongShareInView(Pass::METHOD_MAP, size);
      std::cout << what << ": " << errors.Wrong() << " wrong, " << expected << " expected\n";
      RELIEVO_CHECK_AT_MOST(errors.Wrong() / expected, 3., what + ": more wrong than expected");
      RELIEVO_CHECK_AT_MOST(expected / errors.Wrong(), 3., what + ": less wrong than expected");
    }
  }
}

// The frame report's entry; a failure if it is missing.
double GetReportedShare(relievoTest::ShadowStage& stage)
{
  const std::string report = stage.GetFrame()->GetFrameReport();
  const std::string name = "\"expected_wrong_share\": ";
  const std::size_t at = report.find(name);
  RELIEVO_CHECK(at != std::string::npos);
  return at != std::string::npos ? std::stod(report.substr(at + name.size())) : -1.;
}

// The report has the share that belongs to the maps, and none if there are no shadows.
void TestReport()
{
  relievoTest::ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  stage.GetShadows()->SetMapSize(512);
  stage.GetFrame()->ShadowsOn();
  stage.Window->Render();
  RELIEVO_CHECK_NEAR(GetReportedShare(stage),
    stage.GetShadows()->EstimateWrongShare(Pass::METHOD_MAP, 512), 1e-8, "share of the report");
  const std::string report = stage.GetFrame()->GetFrameReport();
  RELIEVO_CHECK(report.find("expected share of wrong pixels 0.068 %") != std::string::npos);
  stage.GetFrame()->ShadowsOff();
  stage.Window->Render();
  RELIEVO_CHECK(
    stage.GetFrame()->GetFrameReport().find("\"expected_wrong_share\": null") != std::string::npos);
}

// Exact shadows know that a caster which rays cannot follow is in maps.
void TestReportOfExact()
{
  relievoTest::ShadowStage stage;
  stage.AddThings();
  const auto wires = stage.AddBox({ 1.4, 1.5, 0.8 }, { 0.6, 0.1, 0.6 });
  wires->VisibilityOff();
  wires->GetProperty()->SetRepresentationToWireframe();
  stage.AddSun(-3., 4., -2.);
  Pass* shadows = stage.GetShadows();
  shadows->SetMapSize(512);
  shadows->SetMethodToExact();
  stage.GetFrame()->ShadowsOn();
  stage.Window->Render();
  RELIEVO_CHECK_NEAR(GetReportedShare(stage), shadows->EstimateWrongShare(Pass::METHOD_EXACT, 512),
    1e-9, "share of rays");
  wires->VisibilityOn();
  stage.Window->Render();
  RELIEVO_CHECK_NEAR(GetReportedShare(stage), shadows->EstimateWrongShare(Pass::METHOD_MAP, 512),
    1e-8, "share of rays and maps");
}

void TestWrongQuestions()
{
  vtkNew<vtkRelievoShadowStage> pass;
  const relievoTest::ExpectMessage expected("was given method");
  RELIEVO_CHECK(pass->EstimateWrongShare(4, 512) == -1.);
  RELIEVO_CHECK(pass->EstimateWrongShare(Pass::METHOD_MAP, 0) == -1.);
  RELIEVO_CHECK(pass->EstimateBytes(-1, 512, 1, 1, 10, 10) == -1);
  RELIEVO_CHECK(pass->EstimateBytes(Pass::METHOD_FORWARD, 512, 1, 1, -10, 10) == -1);
  // 16 bytes a pixel, and 4 a tile of 8 x 8; triangles are not in it.
  RELIEVO_CHECK(
    pass->EstimateBytes(Pass::METHOD_EXACT, 512, 1, 1, 600, 604) == 16 * 600 * 604 + 4 * 75 * 76);
  RELIEVO_CHECK(pass->EstimateDrawCalls(Pass::METHOD_WARPED, -1, 2) == -1);
  RELIEVO_CHECK(pass->EstimateWrongShare(Pass::METHOD_EXACT, 1) == 2e-5); // whatever the size
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowEstimate)
{
  relievoTest::Session session;
  RELIEVO_CHECK(argc == 2);
  TestLaws(argc > 1 ? argv[1] : "");
  TestHorizon();
  TestReport();
  TestReportOfExact();
  TestWrongQuestions();
  for (const std::string& mesh : relievoTest::ReferenceMeshes())
  {
    TestMesh(mesh, SceneLight::Sun, "sun");
    TestMesh(mesh, SceneLight::Point, "point");
  }
  return session.Result();
}
}
