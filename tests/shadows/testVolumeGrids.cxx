// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Grids of optical depths: closed forms of a ramp and a ball, their certificate, their size for a
// memory, a tolerance, a time and a number of lights.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Session.h"
#include "TestCase.h"
#include "View.h"
#include "VolumeScene.h"
#include "Window.h"

#include <vtkAssembly.h>
#include <vtkDataArray.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPointData.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowCertificate.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoVolumeShade.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace testVolumeGrids
{
namespace
{
using namespace volumeScene;

// Opacities whose extinction is a ramp, and a ball whose extinction falls from its centre.
void TestSmooth()
{
  const auto toOpacity = [](double extinction) { return 1.0 - std::exp(-extinction); };
  Volume ramp(65, [&](const glm::dvec3& place) { return toOpacity(2.0 * place.z); });
  RELIEVO_CHECK_NEAR(
    ramp.GetDepth(Sun({ 0, 0, -1 }), { 0.5, 0.5, 0.5 }), 0.75, 2e-4, "a ramp, half of it");
  RELIEVO_CHECK_NEAR(ramp.GetDepth(Sun({ 1, 0, 0 }), { 3.0, 0.5, 0.3 }), 0.6, 2e-4, "across it");

  // A gradient of 1 per unit, which VTK expects to be at most a quarter of the range per sample.
  vtkNew<vtkPiecewiseFunction> gradients;
  gradients->AddPoint(0.0, 0.0);
  gradients->AddPoint(1.0 / 32.0, 1.0);
  Volume edges(65, [](const glm::dvec3& place) { return place.x; });
  edges.Opacity->AddPoint(0.0, 0.7);
  edges.Opacity->AddPoint(1.0, 0.7);
  edges.Prop->GetProperty()->SetGradientOpacity(gradients);
  RELIEVO_CHECK_NEAR(
    edges.GetDepth(Sun({ 0, 0, -1 }), { 0.5, 0.5, 0.0 }), 0.5 * Sigma, 1e-3, "gradient opacity");

  // Parabolic: the integral along a chord of half length h is 4 / 3 * h^3.
  Volume ball(
    65,
    [&](const glm::dvec3& place) {
      const glm::dvec3 off = 2.0 * place - 1.0;
      return toOpacity(std::max(0.0, 1.0 - glm::dot(off, off)));
    },
    2.0);
  double worst = 0.0;
  for (const glm::dvec3& direction :
    { glm::dvec3(0, 0, -1), glm::dvec3(1, -2, 0.5), glm::dvec3(-1, -1, -1) })
  {
    const Source sun = Sun(direction);
    const glm::dvec3 across = glm::normalize(glm::cross(sun.Direction, glm::dvec3(0.3, 0.2, 0.9)));
    for (double off = 0.0; off < 1.2; off += 0.1)
    {
      const double half = std::sqrt(std::max(0.0, 1.0 - off * off));
      const glm::dvec3 place = glm::dvec3(1.0) + off * across;
      const double whole = 4.0 / 3.0 * half * half * half;
      worst = relievoTest::Larger(
        worst, std::abs(ball.GetDepth(sun, place + 3.0 * sun.Direction) - whole));
      worst = relievoTest::Larger(worst, std::abs(ball.GetDepth(sun, place) - 0.5 * whole));
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 6e-3, "a ball: depth");
}

// Fourier series of rays whose first half has a constant extinction s: partial sums up to harmonic
// m are s t / 2 + the sum of s (1 - cos(2 pi m t)) / (pi m)^2 over odd m.
double GetSeries(int harmonics, double t)
{
  constexpr double Pi = 3.14159265358979;
  double depth = 0.5 * Sigma * t;
  for (int m = 1; m <= harmonics; m += 2)
  {
    depth += Sigma * (1.0 - std::cos(2.0 * Pi * m * t)) / (Pi * Pi * m * m);
  }
  return depth;
}

void TestSeries()
{
  ZenithStage stage;
  const relievoTest::GLCheck gl(stage.Window);
  Volume volume(81, Constant(0.7)); // along rays more nodes than twice the terms, rounded up
  volume.Mapper->CroppingOn();
  volume.Mapper->SetCroppingRegionFlagsToSubVolume();
  volume.Mapper->SetCroppingRegionPlanes(0.0, 1.0, 0.5, 1.0, 0.0, 1.0);
  std::string why;
  const auto fields = vtkRelievoVolumeExtinction::Collect(volume.Prop.Get(), why);
  for (const int harmonics : { 1, 4, 7 })
  {
    vtkRelievoOpticalDepths depths;
    depths.Make(fields, Sun({ 0, -1, 0 }), 256, harmonics);
    RELIEVO_CHECK_NEAR(depths.GetStored().z, 2 * harmonics + 1, 0, "terms");
    for (const double t : { 0.0, 0.1, 0.3, 0.5, 0.8, 1.0, 3.0 })
    {
      RELIEVO_CHECK_NEAR(depths.GetDepth({ 0.45, 1.0 - t, 0.55 }),
        GetSeries(harmonics, std::min(t, 1.0)), 1e-5,
        std::to_string(harmonics) + " harmonics at " + std::to_string(t));
    }
  }

  // Pictures: the ground, and a box within the volume, whose top is at t = 0.3.
  volume.Prop->SetPosition(-0.5, 0.5, -0.5);
  stage.Renderer->AddVolume(volume.Prop);
  stage.AddBox({ 0.0, 1.1, 0.0 }, { 0.3, 0.2, 0.3 });
  stage.Renderer->ResetCameraClippingRange();
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  const auto getShadow = [&](const glm::dvec3& place) {
    const relievoTest::Layers layer(relievoTest::CaptureShadow(stage, 0));
    glm::dvec2 pixel;
    RELIEVO_CHECK(relievoTest::View(stage.Renderer).Project(place, pixel));
    return layer.Value("shadow_0", static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  };
  const auto isSeries = [&]() {
    return shadows->GetReason().find(" terms for each light") != std::string::npos;
  };
  getShadow({ 0.0, 1.2, 0.0 });
  const vtkIdType bytes = shadows->GetBytesHeld();
  for (const int harmonics : { 7, 1 })
  {
    shadows->SetVolumeHarmonics(harmonics);
    const std::string what = std::to_string(harmonics) + " harmonics in the picture";
    RELIEVO_CHECK_NEAR(
      getShadow({ 0.0, 1.2, 0.0 }), std::exp(-GetSeries(harmonics, 0.3)), 2e-3, what);
    RELIEVO_CHECK_NEAR(
      getShadow({ 0.4, 0.0, 0.4 }), std::exp(-0.5 * Sigma), 2e-3, what + ", whole");
    RELIEVO_CHECK_THAT(isSeries(), shadows->GetReason());
  }
  RELIEVO_CHECK(shadows->GetBytesHeld() < bytes);
  shadows->SetTolerance(0.5);
  RELIEVO_CHECK_NEAR(getShadow({ 0.0, 1.2, 0.0 }), std::exp(-0.3 * Sigma), 0.02, "for a tolerance");
  RELIEVO_CHECK_THAT(!isSeries(), shadows->GetReason());
}

// Certificates trace rays through volumes: they find a coarse grid wrong, and a fine one right; and
// grids are chosen for a tolerance.
void TestCertified()
{
  ShadowStage stage;
  stage.AddGround();
  stage.AddBox({ 0.9, 0.2, 0.3 }, { 0.4, 0.4, 0.4 });
  stage.Renderer->GetActiveCamera()->SetPosition(0.0, 5.0, 5.0);
  stage.Renderer->ResetCameraClippingRange();
  Volume volume(
    33,
    [](const glm::dvec3& place) {
      const glm::dvec3 wave = glm::sin(12.0 * place);
      return 0.97 * std::max(0.0, wave.x * wave.y * wave.z);
    },
    1.6);
  volume.Prop->SetPosition(-0.8, 0.7, -0.8);
  volume.Prop->GetProperty()->SetScalarOpacityUnitDistance(0.5);
  stage.Renderer->AddVolume(volume.Prop);
  stage.AddSun(0.4, 1.0, 0.3);
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  shadows->EnabledOn();
  shadows->SetMethodToExact();
  const auto certify = [&]() {
    stage.Window->Render();
    vtkRelievoShadowCertificate* certificate = shadows->Certify(1500, 3);
    RELIEVO_CHECK(certificate && certificate->GetJudged() == 1500);
    return certificate ? certificate->GetWrongShare() : 1.0;
  };
  const double fine = certify();
  shadows->SetVolumeNodes(16);
  const double coarse = certify();
  RELIEVO_CHECK_AT_MOST(fine, 0.02, "a node a voxel: wrong share");
  RELIEVO_CHECK_AT_MOST(0.05, coarse, "16 nodes: wrong share");
  RELIEVO_CHECK_NEAR(shadows->GetFacts()["volume_nodes"].ToInt(), 16, 0, "nodes as set");
  shadows->SetVolumeNodes(256);
  shadows->SetTolerance(0.9);
  stage.Window->Render();
  RELIEVO_CHECK_NEAR(shadows->GetFacts()["volume_nodes"].ToInt(), 32, 0, "nodes for any error");
  shadows->SetTolerance(0.02);
  stage.Window->Render();
  const int chosen = shadows->GetFacts()["volume_nodes"].ToInt();
  const vtkVariant share = shadows->GetFacts()["volume_wrong_share"];
  RELIEVO_CHECK(share.IsValid());
  RELIEVO_CHECK_NEAR(chosen, 64, 0, "nodes, of which 32 are too few");
  RELIEVO_CHECK_AT_MOST(share.ToDouble(), 0.1, "expected with a node a voxel");
  shadows->SetTolerance(0.0);
  shadows->SetTimeBudget(0.01);
  stage.Window->Render();
  RELIEVO_CHECK_NEAR(shadows->GetFacts()["volume_nodes"].ToInt(), 32, 0, "nodes for no time");

  // With solid volumes, the certificate is one of the surfaces' shadows too.
  shadows->SetTimeBudget(0.0);
  volume.Prop->GetProperty()->SetScalarOpacityUnitDistance(0.05); // it has a depth
  const auto count = [&]() {
    vtkRelievoShadowCertificate* found = shadows->Certify(3000, 5);
    return found ? std::vector<double>{ static_cast<double>(found->GetJudged()),
      static_cast<double>(found->GetWrong()), static_cast<double>(found->GetUnknown()) }
                 : std::vector<double>();
  };
  stage.Window->Render();
  const std::vector<double> hollow = count();
  stage.GetFrame()->GetStage("volumes")->SetParameter("solid", "on");
  stage.Window->Render();
  RELIEVO_CHECK(count() == hollow && !hollow.empty());
  RELIEVO_CHECK(stage.GetFrame()->GetAmends());
  stage.GetFrame()->GetStage("volumes")->SetParameter("solid", "off");

  // A volume that is added after the last frame is drawn by Certify, and judged.
  stage.Renderer->RemoveVolume(volume.Prop);
  stage.Window->Render();
  stage.Renderer->AddVolume(volume.Prop);
  const std::vector<double> added = count();
  RELIEVO_CHECK(added == hollow);

  // Its shadow is missing: unknown where it might fall, also in an assembly.
  volume.Mapper->SetBlendModeToMaximumIntensity();
  stage.Window->Render();
  const std::vector<double> unknown = count();
  RELIEVO_CHECK(unknown.size() == 3 && unknown[2] > hollow[2]);
  stage.Renderer->RemoveVolume(volume.Prop);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(volume.Prop);
  assembly->SetPosition(volume.Prop->GetPosition());
  volume.Prop->SetPosition(0.0, 0.0, 0.0);
  stage.Renderer->AddActor(assembly);
  stage.Window->Render();
  RELIEVO_CHECK(count() == unknown);
}

// Grids fit into the memory, and one picture has one grid.
void TestGrids()
{
  ShadowStage stage;
  const relievoTest::GLCheck gl(stage.Window);
  stage.Window->Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(stage.Window);
  const Volume volume(129, [](const glm::dvec3& place) {
    const glm::dvec3 wave = glm::sin(40.0 * place);
    return 0.97 * std::max(0.0, wave.x * wave.y * wave.z);
  });
  const std::vector<vtkRelievoPlacedVolume> casters = { volume.Prop.Get() };
  const std::vector<Source> sources = { Sun({ 0, -1, 0 }), Sun({ -1, -0.4, -0.7 }) };
  const auto update = [&](vtkRelievoVolumeShade& shade, int nodes,
                        const vtkRelievoVolumeShade::Goal& goal, double most, int harmonics = 0) {
    shade.SetCasters(casters, false);
    shade.SetSpreads({ 0.0, 0.0 });
    shade.SetNodes(nodes, harmonics, goal);
    shade.SetMostBytes(most);
    return shade.Update(window, sources);
  };
  vtkRelievoVolumeShade shade;
  RELIEVO_CHECK(update(shade, 120, {}, 1e9).empty());
  const double bytes = static_cast<double>(shade.GetBytes());
  vtkRelievoVolumeShade other;
  RELIEVO_CHECK(update(other, 120, {}, bytes).empty());
  const std::string fault = update(other, 121, {}, bytes - 1.0);
  RELIEVO_CHECK_THAT(fault.find("lower volume_nodes, which is 121") != std::string::npos, fault);

  vtkRelievoVolumeShade::Goal goal;
  goal.Tolerance = 1e-6;
  RELIEVO_CHECK(update(shade, 120, goal, 1e9).empty());
  RELIEVO_CHECK(shade.GetNodesMade() >= 64);
  vtkRelievoVolumeShade small;
  const std::string fits = update(small, 120, goal, 0.6 * bytes);
  RELIEVO_CHECK_THAT(fits.empty(), fits + " of " + std::to_string(bytes));
  RELIEVO_CHECK(small.IsMade() && static_cast<double>(small.GetBytes()) <= 0.6 * bytes);
  const std::string none = update(other, 120, goal, 1000.0);
  RELIEVO_CHECK_THAT(!none.empty() && none.find("volume_nodes") == std::string::npos, none);

  // Just too little time and just enough, before the real time is known.
  std::string why;
  double nodes = 0.0;
  for (const Source& source : sources)
  {
    vtkRelievoOpticalDepths depths;
    depths.Lay(
      vtkRelievoOpticalDepths::GetExtent(vtkRelievoVolumeExtinction::Collect(casters[0], why)),
      source, 64);
    nodes += static_cast<double>(depths.GetSize().x) * depths.GetSize().y * depths.GetSize().z;
  }
  for (const double share : { 0.99, 1.01 })
  {
    goal.Tolerance = 0.0;
    goal.Milliseconds = 3e-5 * share * nodes;
    vtkRelievoVolumeShade timed;
    RELIEVO_CHECK(update(timed, 256, goal, 1e9).empty());
    const int first = timed.GetNodesMade();
    RELIEVO_CHECK(update(timed, 256, goal, 1e9).empty());
    RELIEVO_CHECK_NEAR(timed.GetNodesMade(), first, 0, "nodes of the next sample");
  }
  // The time that a series takes is none of nodes.
  vtkRelievoVolumeShade series;
  RELIEVO_CHECK(update(series, 256, {}, 1e9, 3).empty());
  RELIEVO_CHECK(update(series, 256, goal, 1e9).empty());
  RELIEVO_CHECK_NEAR(series.GetNodesMade(), 64, 0, "nodes for a time, after a series");
}

// Grids have room for all lights, also after a change of their number.
void TestManyLights()
{
  struct Lights : ZenithStage
  {
    Lights()
      : Cloud(2, Constant(0.7))
    {
      this->Cloud.Image->SetDimensions(2, 300, 2);
      this->Cloud.Image->SetSpacing(1.0, 1.0 / 299.0, 1.0);
      this->Cloud.Image->AllocateScalars(VTK_FLOAT, 1);
      this->Cloud.Image->GetPointData()->GetScalars()->Fill(0.5);
      this->Cloud.Prop->SetPosition(-0.5, 0.5, -0.5);
      this->Renderer->AddVolume(this->Cloud.Prop);
      this->GetShadows()->EnabledOn();
    }

    // The stage's report on its grids with so many lights.
    std::string GetReport(int lights)
    {
      vtkLightCollection* all = this->Renderer->GetLights();
      while (all->GetNumberOfItems() > lights)
      {
        this->Renderer->RemoveLight(vtkLight::SafeDownCast(all->GetItemAsObject(lights)));
      }
      while (all->GetNumberOfItems() < lights)
      {
        this->AddSun(0.0, 1.0, 0.0);
      }
      this->Window->Render();
      const std::string report = this->GetShadows()->GetReason();
      const std::size_t at = report.find("depths of volumes in ");
      return at == std::string::npos ? report : report.substr(at, report.find(" nodes") - at);
    }

    Volume Cloud;
  };
  // Two windows for both orders: a shader of nine lights takes seconds to compile.
  Lights few;
  Lights many;
  const std::string one = few.GetReport(1);
  const std::string nine = many.GetReport(9);
  RELIEVO_CHECK_THAT(one != nine, one);
  const std::string grown = few.GetReport(9);
  RELIEVO_CHECK_THAT(grown == nine, grown + ", a fresh stage " + nine);
  const std::string shrunk = many.GetReport(1);
  RELIEVO_CHECK_THAT(shrunk == one, shrunk + ", a fresh stage " + one);
}
}

RELIEVO_TEST_CASE(testVolumeGrids)
{
  relievoTest::Session session;
  TestGrids();
  TestSmooth();
  TestSeries();
  TestCertified();
  TestManyLights();
  return session.Result();
}
}
