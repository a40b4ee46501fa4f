// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Certificates of shadows: they find Embree's errors, and none where there are none; the bound
// against closed forms; separately counted verdicts, and refused requests.
#include "Check.h"
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
#include <vtkCameraPass.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowCertificate.h>
#include <vtkRelievoShadowStage.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace testShadowCertify
{
namespace
{
using Certificate = vtkRelievoShadowCertificate;
using relievoTest::SceneLight;
using relievoTest::ShadowStage;

constexpr int All = 1 << 30;

// For n without an error, (1 - p)^n = 0.05; for n all but one wrong, 1 - p^n = 0.05; symmetric
// under exchange of right and wrong at the other confidence.
void TestBound()
{
  for (const long long n : { 1ll, 10ll, 6000ll, 10000000ll })
  {
    const double all = static_cast<double>(n);
    RELIEVO_CHECK_NEAR(
      Certificate::GetBound(0, n) / -std::expm1(std::log(0.05) / all), 1., 1e-6, "no error");
    RELIEVO_CHECK(Certificate::GetBound(n, n) == 1.);
  }
  for (const long long n : { 2ll, 10ll, 100ll })
  {
    RELIEVO_CHECK_NEAR(Certificate::GetBound(n - 1, n),
      std::exp(std::log(0.95) / static_cast<double>(n)), 1e-9, "all but one wrong");
  }
  RELIEVO_CHECK_AT_MOST(Certificate::GetBound(0, 6000), 5e-4, "the rule of three");
  // Tables of Clopper and Pearson: 3 of 20, two-sided 90 %.
  RELIEVO_CHECK_NEAR(Certificate::GetBound(3, 20), 0.34366, 1e-4, "3 of 20");
  RELIEVO_CHECK(Certificate::GetBound(0, 0) == 1.);
  RELIEVO_CHECK(Certificate::GetBound(0, 50, 0.5) < Certificate::GetBound(0, 50, 0.99));
  const relievoTest::ExpectMessage expected("GetBound was given");
  RELIEVO_CHECK(std::isnan(Certificate::GetBound(3, 2)));
  RELIEVO_CHECK(std::isnan(Certificate::GetBound(-1, 2)));
  RELIEVO_CHECK(std::isnan(Certificate::GetBound(1, 2, 1.)));
  // With a confidence below one half the bound may be below the share.
  RELIEVO_CHECK_NEAR(Certificate::GetBound(0, 1, 0.1), 0.1, 1e-9, "a confidence of 10 %");
  RELIEVO_CHECK_NEAR(Certificate::GetBound(1, 2, 0.1), std::sqrt(0.1), 1e-9, "one of two, 10 %");
  // Many wrong: the normal distribution's 1.645 sigma.
  RELIEVO_CHECK_NEAR(Certificate::GetBound(5000000, 10000000),
    0.5 + 1.645 * 0.5e-3 / std::sqrt(10.), 1e-6, "half of many");
}

// All verdicts of a coarse map: the share that Embree finds; a part of them by lot: a bound that
// holds; and none of exact shadows.
void TestMesh(const std::string& mesh, SceneLight kind)
{
  const auto scene = relievoTest::MakeReferenceScene(mesh, kind);
  if (!scene.IsValid())
  {
    return;
  }
  auto window = relievoTest::MakeWindow(110, 96, scene.Renderer);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  vtkRelievoShadowStage* shadows = frame->GetShadowStage();
  frame->ShadowsOn();
  shadows->SetMapSize(64);
  window->Render();
  const auto truth = scene.MakeTruth();
  const auto judged =
    relievoTest::TraceShadow(*truth, truth->Trace(relievoTest::View(scene.Renderer)), scene.Light);
  const relievoTest::Layers layers(scene.Renderer, { "shadow_0" });
  const auto errors = relievoTest::CompareShadow(judged,
    vtkFloatArray::SafeDownCast(layers.Image->GetPointData()->GetArray("shadow_0"))->GetPointer(0));
  const vtkSmartPointer<Certificate> all = shadows->Certify(All);
  RELIEVO_CHECK(all != nullptr);
  if (!all)
  {
    return;
  }
  std::cout << mesh << ": " << all->GetWords() << "\n  Embree: " << errors.ToString() << "\n";
  RELIEVO_CHECK_THAT(errors.Wrong() > 0.003, mesh + ": too little is wrong");
  RELIEVO_CHECK_NEAR(all->GetWrongShare() / errors.Wrong(), 1., 0.05, mesh + ": share");
  RELIEVO_CHECK_NEAR(static_cast<double>(all->GetJudged()) / static_cast<double>(errors.Compared),
    1., 0.01, mesh + ": judged");
  RELIEVO_CHECK_NEAR(static_cast<double>(all->GetFalseShadow()) /
      static_cast<double>(std::max(1LL, errors.FalseShadow)),
    1., 0.15, mesh + ": false shadow");
  RELIEVO_CHECK(all->GetUnknown() == 0);
  int below = 0;
  for (int seed = 0; seed < 10; ++seed)
  {
    const vtkSmartPointer<Certificate> some = shadows->Certify(2000, seed);
    RELIEVO_CHECK(some && some->GetJudged() == 2000);
    below += some && some->GetWrongShareBound() < all->GetWrongShare() ? 1 : 0;
  }
  RELIEVO_CHECK_AT_MOST(below, 2, mesh + ": bounds below the share"); // 0.5 are expected
  const vtkSmartPointer<Certificate> once = shadows->Certify(500, 3);
  const vtkSmartPointer<Certificate> again = shadows->Certify(500, 3);
  RELIEVO_CHECK(once->GetWords() == again->GetWords());
  shadows->SetMethodToExact();
  const vtkSmartPointer<Certificate> exact = shadows->Certify(All);
  std::cout << "  exact: " << exact->GetWords() << "\n";
  RELIEVO_CHECK_AT_MOST(exact->GetWrongShare(), 2e-5, mesh + ": exact");
  RELIEVO_CHECK(exact->GetTies() == all->GetTies() && exact->GetJudged() == all->GetJudged());
  vtkRelievoPass::Detach(scene.Renderer);
}

// Verdicts outside the share, one kind at a time; none of them counts as an error.
void TestCountedApart()
{
  ShadowStage stage;
  const auto ground = stage.AddGround();
  const auto box = stage.AddBox({ 0., 1., 0. }, { 0.6, 0.6, 0.6 });
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  stage.GetShadows()->SetMethodToExact();
  stage.Window->Render();
  const vtkSmartPointer<Certificate> good = stage.GetShadows()->Certify(All);
  RELIEVO_CHECK(good->GetWrong() == 0 && good->GetUnknown() == 0 && good->GetUnlit() == 0);
  RELIEVO_CHECK_THAT(good->GetJudged() > 5000 && good->GetGrazing() > 100, good->GetWords());
  stage.GetShadows()->SetPropReceives(ground, false);
  const vtkSmartPointer<Certificate> bare = stage.GetShadows()->Certify(All);
  RELIEVO_CHECK_THAT(bare->GetUnlit() > 5000 && bare->GetWrong() == 0, bare->GetWords());
  stage.GetShadows()->SetPropReceives(ground, true);
  // A wireframe has no triangles: places that it may shadow are not judged.
  box->GetProperty()->SetRepresentationToWireframe();
  const vtkSmartPointer<Certificate> lines = stage.GetShadows()->Certify(All);
  RELIEVO_CHECK_THAT(lines->GetUnknown() > 100 && lines->GetWrong() == 0, lines->GetWords());
  RELIEVO_CHECK(lines->GetJudged() > 5000);
}

void TestSpot()
{
  ShadowStage stage;
  stage.AddThings();
  stage.Renderer->GetActiveCamera()->SetParallelProjection(1);
  stage.AddLamp({ -1.5, 3., -1. }, { 0., 0., 0. }, 25.);
  stage.AddSun(2., 4., 1.);
  stage.GetFrame()->ShadowsOn();
  stage.GetShadows()->SetMapSize(48);
  stage.Window->Render();
  const vtkSmartPointer<Certificate> coarse = stage.GetShadows()->Certify(All);
  std::cout << "spot and sun: " << coarse->GetWords() << "\n";
  RELIEVO_CHECK_THAT(coarse->GetUnlit() > 1000, coarse->GetWords());
  RELIEVO_CHECK_THAT(coarse->GetWrongShare() > 1e-3, coarse->GetWords());
  stage.GetShadows()->SetMethodToExact();
  const vtkSmartPointer<Certificate> exact = stage.GetShadows()->Certify(All);
  RELIEVO_CHECK_THAT(exact->GetWrong() == 0, exact->GetWords());
}

// Geometry drawn as opaque casts as such, whatever its opacity.
void TestForcedOpaque()
{
  ShadowStage stage(120, 90);
  stage.AddGround();
  const auto box = stage.AddBox({ 0., 1., 0. }, { 0.6, 0.6, 0.6 });
  box->GetProperty()->SetOpacity(0.5);
  box->ForceOpaqueOn();
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  stage.GetShadows()->SetMethodToExact();
  stage.Window->Render();
  const relievoTest::ShadowErrors errors = relievoTest::JudgeShadow(stage, 0);
  RELIEVO_CHECK_THAT(errors.Compared > 3000, "forced to be opaque: what is compared");
  RELIEVO_CHECK_AT_MOST(errors.Wrong(), 1e-3, "forced to be opaque");
  const vtkSmartPointer<Certificate> all = stage.GetShadows()->Certify(All);
  RELIEVO_CHECK_THAT(all->GetWrong() == 0 && all->GetUnknown() == 0, all->GetWords());
}

// A plate thinner than the steps of half floats: its front is judged, not its back.
void TestThinPlate()
{
  long long grazing[2];
  for (const int format : { vtkRelievoLayersStage::DEPTH_32F, vtkRelievoLayersStage::DEPTH_16F })
  {
    ShadowStage stage(120, 90);
    stage.AddBox({ 0., 1., 0. }, { 1.5, 0.0005, 1.5 });
    stage.AddBox({ 0., 1.5, 0. }, { 0.3, 0.3, 0.3 });
    stage.AddSun(-1., -4., -2.);
    stage.AddSun(-3., 4., -2.);
    stage.GetFrame()->ShadowsOn();
    stage.GetFrame()->GetLayersStage()->SetDepthFormat(format);
    stage.GetShadows()->SetMethodToExact();
    stage.Window->Render();
    const vtkSmartPointer<Certificate> all = stage.GetShadows()->Certify(All);
    grazing[format == vtkRelievoLayersStage::DEPTH_16F ? 1 : 0] = all->GetGrazing();
    RELIEVO_CHECK(all->GetJudged() > 300);
  }
  RELIEVO_CHECK_NEAR(static_cast<double>(grazing[1]) / static_cast<double>(grazing[0]), 1., 0.02,
    "thin plate: turned away");
}

// Oblique projections, of both kinds.
void TestSheared()
{
  for (const int parallel : { 0, 1 })
  {
    ShadowStage stage(120, 90);
    stage.AddThings();
    stage.AddSun(-3., 4., -2.);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    camera->SetViewShear(0.2, 0.1, 1.);
    stage.GetFrame()->ShadowsOn();
    stage.GetShadows()->SetMethodToExact();
    stage.Window->Render();
    const vtkSmartPointer<Certificate> all = stage.GetShadows()->Certify(All);
    RELIEVO_CHECK_THAT(all->GetWrong() == 0 && all->GetJudged() > 2000, all->GetWords());
    RELIEVO_CHECK_AT_MOST(all->GetUnknown(), 0, "sheared: " + all->GetWords());
  }
}

// Under a pass of others, as ParaView has one.
void TestNested()
{
  ShadowStage stage(120, 90);
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  vtkNew<vtkCameraPass> around;
  around->SetDelegatePass(stage.GetFrame());
  stage.Renderer->SetPass(around);
  stage.Window->Render();
  const vtkSmartPointer<Certificate> some = shadows->Certify(1000);
  RELIEVO_CHECK(some && some->GetJudged() == 1000);
}

// Ties depend on the surfaces, not on the drawn verdicts.
void TestTies()
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  stage.GetFrame()->ShadowsOn();
  stage.GetShadows()->SetMethodToExact();
  stage.Window->Render();
  const vtkSmartPointer<Certificate> right = stage.GetShadows()->Certify(All);
  stage.GetShadows()->SetMethodToMap();
  stage.GetShadows()->SetMapSize(16);
  stage.GetShadows()->SetBias(100.); // no shadows at all
  stage.Window->Render();
  const vtkSmartPointer<Certificate> broken = stage.GetShadows()->Certify(All);
  std::cout << "right: " << right->GetWords() << "\nbroken: " << broken->GetWords() << "\n";
  RELIEVO_CHECK(right->GetWrong() == 0 && right->GetTies() > 0);
  RELIEVO_CHECK(broken->GetWrongShare() > 0.05);
  RELIEVO_CHECK(right->GetTies() == broken->GetTies());
  RELIEVO_CHECK(right->GetJudged() == broken->GetJudged());
}

void TestRefusals()
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  {
    const relievoTest::ExpectMessage expected("Certify has no picture");
    RELIEVO_CHECK(!stage.GetShadows()->Certify(100));
  }
  stage.GetFrame()->ShadowsOn();
  stage.Window->Render();
  {
    const relievoTest::ExpectMessage expected("Certify was given 0 rays");
    RELIEVO_CHECK(!stage.GetShadows()->Certify(0));
  }
  stage.GetShadows()->SetSoftSamples(8);
  const relievoTest::ExpectMessage expected("SoftSamples is 8");
  RELIEVO_CHECK(!stage.GetShadows()->Certify(100));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowCertify)
{
  relievoTest::Session session;
  TestBound();
  TestCountedApart();
  TestSpot();
  TestTies();
  TestRefusals();
  TestForcedOpaque();
  TestThinPlate();
  TestSheared();
  TestNested();
  TestMesh("bunny", SceneLight::Point);
  return session.Result();
}
}
