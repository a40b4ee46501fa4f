// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights with a size: the share of them that is seen, against the closed form under an edge and
// against Embree's rays to all of the light, for every kind of light and method.
#include "Check.h"
#include "EmbreeScene.h"
#include "Layers.h"
#include "MadeMeshes.h"
#include "Props.h"
#include "Scenes.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "SoftShadowTruth.h"
#include "SrgbCurve.h"
#include "TestCase.h"
#include "View.h"
#include "Window.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRelievoAntialiasStage.h>
#include <vtkRelievoLightSamples.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoTextureBuffer.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace testShadowSoft
{
namespace
{
using relievoTest::Layers;
using relievoTest::SceneLight;
using relievoTest::ShadowStage;

constexpr int Samples = 64;
constexpr double Limit = 1. / 64.;
constexpr double Pi = 3.14159265358979323846;

const char* const Methods[] = { "map", "forward", "warped", "exact" };

const float* Visibility(vtkImageData* image)
{
  return vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"))->GetPointer(0);
}

// The area of the unit disc with x below h, as a share.
double DiscShare(double h)
{
  h = std::min(1., std::max(-1., h));
  return 0.5 + (h * std::sqrt(1. - h * h) + std::asin(h)) / Pi;
}

// The share of points of the samples with x below h, in a direction, against the disc's.
template <typename Point, typename Place>
double GetDiscrepancy(Point makePoint, Place along, int samples)
{
  std::vector<decltype(makePoint(0, samples))> points;
  for (int i = 0; i < samples; ++i)
  {
    points.push_back(makePoint(i, samples));
  }
  double sum = 0.;
  int count = 0;
  for (int turn = 0; turn < 36; ++turn)
  {
    for (double h = -0.95; h < 1.; h += 0.1)
    {
      int below = 0;
      for (int i = 0; i < samples; ++i)
      {
        below += along(points[i], turn * Pi / 18.) < h ? 1 : 0;
      }
      const double error = static_cast<double>(below) / samples - DiscShare(h);
      sum += error * error;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

void TestSamples()
{
  for (const int n : { 16, 64, 256 })
  {
    // For random points it is 0.4 / sqrt(n).
    const double disc = GetDiscrepancy(
      vtkRelievoLightSamples::OnDisc,
      [](const glm::dvec2& p, double t) { return p.x * std::cos(t) + p.y * std::sin(t); }, n);
    const double ball = GetDiscrepancy(
      vtkRelievoLightSamples::InBall,
      [](const glm::dvec3& p, double t) {
        const double z = std::sin(5. * t);
        return std::sqrt(1. - z * z) * (p.x * std::cos(t) + p.y * std::sin(t)) + p.z * z;
      },
      n);
    std::cout << n << " samples: discrepancy " << disc << " on a disc, " << ball << " in a ball\n";
    RELIEVO_CHECK_AT_MOST(disc, 0.9 / n + 0.002, "discrepancy on a disc");
    RELIEVO_CHECK_AT_MOST(ball, 1.2 / n + 0.003, "discrepancy in a ball");
  }
  for (const int n : { 2, 5, 16, Samples })
  {
    RELIEVO_CHECK(vtkRelievoLightSamples::OnDisc(0, n) == glm::dvec2(0.));
    RELIEVO_CHECK(vtkRelievoLightSamples::InBall(0, n) == glm::dvec3(0.));
    RELIEVO_CHECK_AT_MOST(glm::length(vtkRelievoLightSamples::OnSquare(0, n)), 1.001 / n,
      "first sample's distance from the middle of a square");
  }
  // The share of the square's samples in a corner's box, against its area.
  for (const int n : { 16, 64, 256 })
  {
    double worst = 0.;
    for (double right = -0.9; right <= 1.; right += 0.1)
    {
      for (double top = -0.9; top <= 1.; top += 0.1)
      {
        int within = 0;
        for (int i = 0; i < n; ++i)
        {
          const glm::dvec2 p = vtkRelievoLightSamples::OnSquare(i, n);
          within += p.x < right && p.y < top ? 1 : 0;
        }
        worst = std::max(
          worst, std::abs(static_cast<double>(within) / n - (right + 1.) * (top + 1.) / 4.));
      }
    }
    std::cout << n << " samples: largest discrepancy " << worst << " on a square\n";
    // A lattice's discrepancy is about log(n) / n; that of random points, 0.5 / sqrt(n).
    RELIEVO_CHECK_AT_MOST(worst, (1. + 0.5 * std::log2(n)) / n, "discrepancy on a square");
  }
}

std::string Describe(SceneLight kind, double size)
{
  const std::string number = std::to_string(size).substr(0, 4);
  return kind == SceneLight::Sun ? "sun of " + number + " degrees"
    : kind == SceneLight::Spot   ? "disc of radius " + number
                                 : "ball of radius " + number;
}

// A sheet whose edge is over the middle of the ground: the visible share of the light beside it.
// `size`: the sun's angle in degrees, or the lamp's radius.
void TestEdge(int method, SceneLight kind, double size, int pixels = 80)
{
  constexpr double Height = 4.;
  constexpr double Up = 9.; // of lamps
  ShadowStage stage(pixels, 3 * pixels / 4);
  stage.AddGround();
  const auto mesh = relievoTest::MakePolygons(
    { { 0., Height, 20. }, { 20., Height, 20. }, { 20., Height, -20. }, { 0., Height, -20. } });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  relievoTest::AddActor(stage.Renderer, mesh);
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  shadows->SetMethod(method);
  shadows->SetMapSize(256);
  shadows->SetSoftSamples(Samples);
  double radius = std::tan(0.5 * size * Pi / 180.);
  if (kind == SceneLight::Sun)
  {
    stage.AddSun(0., 5., 0.);
    shadows->SetSunAngle(size);
  }
  else
  {
    const auto lamp =
      stage.AddLamp({ 0., Up, 0. }, { 0., 0., 0. }, kind == SceneLight::Spot ? 40. : 90.);
    shadows->SetLightSize(lamp, radius = size);
  }
  const auto image = relievoTest::CaptureShadow(stage, 0);
  relievoTest::EmbreeScene ground;
  const auto square = relievoTest::MakePolygons(
    { { -3., 0., 3. }, { 3., 0., 3. }, { 3., 0., -3. }, { -3., 0., -3. } });
  square->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  ground.AddActor(square);
  const auto view = ground.Trace(relievoTest::View(stage.Renderer));
  double sum = 0.;
  double mean = 0.;
  int count = 0;
  for (std::size_t i = 0; i < view.Pixels.size(); ++i)
  {
    const double x = view.Pixels[i].Position.x;
    // How far the plane through the pixel's place and the edge passes by the light's middle.
    double by = -x / Height;
    if (kind == SceneLight::Spot)
    {
      by = -x * (Up - Height) / Height; // in the plane of its disc
    }
    if (kind == SceneLight::Point)
    {
      by = -x * (Up - Height) / std::hypot(Height, x);
    }
    const double share = DiscShare(by / radius);
    if (view.Pixels[i].Hit && share > 0. && share < 1.)
    {
      const double error = Visibility(image)[i] - share;
      sum += error * error;
      mean += error;
      ++count;
    }
  }
  const std::string what = std::string("edge, ") + Methods[method] + ", " + Describe(kind, size);
  const double rms = std::sqrt(sum / count);
  std::cout << what << ": rms error " << rms << ", mean " << mean / count << " of " << count
            << " pixels in the penumbra\n";
  RELIEVO_CHECK_THAT(count > 400, what + ": too little is in the penumbra");
  RELIEVO_CHECK_AT_MOST(
    rms, kind == SceneLight::Point ? 1.15 * Limit : Limit, what + ": rms error");
  RELIEVO_CHECK_AT_MOST(std::abs(mean / count), 0.5 * Limit, what + ": mean error");
}

// The picture of the same edge, whose samples are drawn at once and followed through few maps.
void TestFollowed(double angle, int maps, double limit)
{
  constexpr double Height = 4.;
  ShadowStage stage(160, 120);
  const auto ground = stage.AddGround();
  const auto mesh = relievoTest::MakePolygons(
    { { 0., Height, 20. }, { 20., Height, 20. }, { 20., Height, -20. }, { 0., Height, -20. } });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  relievoTest::AddActor(stage.Renderer, mesh);
  ground->GetProperty()->SetAmbient(0.);
  ground->GetProperty()->SetSpecular(0.);
  ground->GetProperty()->SetDiffuse(0.9);
  ground->GetProperty()->SetColor(1., 1., 1.);
  stage.AddSun(0., 5., 0.);
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  shadows->EnabledOn();
  shadows->SetMapSize(2048);
  shadows->SetSoftSamples(24);
  shadows->SetSunAngle(angle);
  shadows->SetSoftMaps(maps);
  vtkNew<vtkRelievoAntialiasStage> antialias;
  antialias->SetSamples(24);
  stage.GetFrame()->AddStage(antialias);
  stage.GetFrame()->WaitForSamplesOn();
  const auto picture = relievoTest::Picture(stage.Window);
  RELIEVO_CHECK(antialias->GetReason().find("41 samples in") != std::string::npos);
  RELIEVO_CHECK(shadows->GetNumberOfMapsDrawn() == maps);
  relievoTest::EmbreeScene truth;
  const auto square = relievoTest::MakePolygons(
    { { -3., 0., 3. }, { 3., 0., 3. }, { 3., 0., -3. }, { -3., 0., -3. } });
  square->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  truth.AddActor(square);
  const auto view = truth.Trace(relievoTest::View(stage.Renderer));
  const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
  const double radius = std::tan(0.5 * angle * Pi / 180.);
  const double white = relievoTest::LinearFromSrgb(std::round(0.9 * 255.) / 255.);
  double sum = 0.;
  double mean = 0.;
  int count = 0;
  for (std::size_t i = 1; i + 1 < view.Pixels.size(); ++i)
  {
    if (!view.Pixels[i - 1].Hit || !view.Pixels[i].Hit || !view.Pixels[i + 1].Hit)
    {
      continue;
    }
    double share = 0.; // the mean over the pixel
    for (int part = -3; part <= 3; ++part)
    {
      const double x = view.Pixels[i].Position.x +
        part / 14. * (view.Pixels[i + 1].Position.x - view.Pixels[i - 1].Position.x);
      share += DiscShare(-x / Height / radius) / 7.;
    }
    if (share > 1e-6 && share < 1. - 1e-6)
    {
      const double error = relievoTest::LinearFromSrgb(bytes[3 * i] / 255.) / white - share;
      sum += error * error;
      mean += error;
      ++count;
    }
  }
  const std::string what =
    "followed, " + std::to_string(maps) + " maps, " + Describe(SceneLight::Sun, angle);
  std::cout << what << ": rms error " << std::sqrt(sum / count) << ", mean " << mean / count
            << " of " << count << " pixels in the penumbra\n";
  RELIEVO_CHECK_THAT(count > 150, what + ": too little is in the penumbra");
  RELIEVO_CHECK_AT_MOST(std::sqrt(sum / count), limit, what + ": rms error");
  RELIEVO_CHECK_AT_MOST(std::abs(mean / count), Limit, what + ": mean error");
}

// Rays that end in front of all casters around them give the same picture as those that go on,
// which are traced where no texture has room for the nearest depths.
void TestNearest()
{
  ShadowStage stage(160, 120);
  stage.AddThings();
  stage.AddSun(-3., 4., -2.);
  // A caster that OpenGL draws over those of the processor.
  vtkNew<vtkPolyData> place;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1.3, 0.9, 1.2);
  place->SetPoints(points);
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(place);
  mapper->SetSourceConnection(cube->GetOutputPort());
  mapper->SetScaleFactor(0.4);
  vtkNew<vtkActor> glyph;
  glyph->SetMapper(mapper);
  stage.Renderer->AddActor(glyph);
  vtkRelievoShadowStage* shadows = stage.GetShadows();
  shadows->EnabledOn();
  shadows->SetMapSize(512);
  shadows->SetSoftSamples(24);
  shadows->SetSunAngle(8.);
  shadows->SetSoftMaps(4);
  vtkNew<vtkRelievoAntialiasStage> antialias;
  antialias->SetSamples(24);
  stage.GetFrame()->AddStage(antialias);
  stage.GetFrame()->WaitForSamplesOn();
  const auto shorter = relievoTest::Picture(stage.Window);
  const vtkIdType bytes = stage.GetFrame()->GetBytesHeld();
  constexpr int Blocks = 32 * 32 * 4; // of 256 / 8 a side
  vtkRelievoTextureBuffer::SetMostTexels(Blocks - 1);
  shadows->SetStrength(0.5);
  stage.Window->Render();
  shadows->SetStrength(1.);
  const auto whole = relievoTest::Picture(stage.Window);
  vtkRelievoTextureBuffer::SetMostTexels(0);
  RELIEVO_CHECK(bytes - stage.GetFrame()->GetBytesHeld() >= 4 * Blocks);
  relievoTest::SamePicture(shorter, whole, "rays to their ends");
}

void TestMesh(const std::string& name, SceneLight kind, double size, double limit,
  const std::vector<int>& methods = { vtkRelievoShadowStage::METHOD_EXACT })
{
  const auto scene = name == "arrows"
    ? relievoTest::MakeReferenceScene(relievoTest::MakeArrows(), kind)
    : relievoTest::MakeReferenceScene(name, kind);
  if (!scene.IsValid())
  {
    return;
  }
  auto window = relievoTest::MakeWindow(120, 90, scene.Renderer);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  vtkRelievoShadowStage* shadows = frame->GetShadowStage();
  shadows->SetSoftSamples(Samples);
  shadows->SetMapSize(1024);
  shadows->SetLightSize(scene.Light, size);
  const auto truth = scene.MakeTruth();
  relievoTest::SoftShadowTruth soft;
  for (const int method : methods)
  {
    shadows->SetMethod(method);
    const Layers layers(scene.Renderer, { "shadow_0" });
    if (soft.Shares.empty())
    {
      soft = relievoTest::TraceSoftShadow(
        *truth, truth->Trace(relievoTest::View(scene.Renderer)), scene.Light, size);
    }
    const auto errors = relievoTest::CompareSoftShadow(soft, Visibility(layers.Image));
    const std::string what = name + ", " + Methods[method] + ", " + Describe(kind, size);
    std::cout << what << ": " << errors.ToString() << std::endl;
    RELIEVO_CHECK_THAT(
      errors.Compared > 1000 && errors.Penumbra > 100, what + ": too little is compared");
    for (std::size_t i = 0; i < soft.Shares.size(); ++i)
    {
      const float drawn = Visibility(layers.Image)[i];
      if (soft.Shares[i] >= 0.f && std::abs(drawn - soft.Shares[i]) > 0.5f)
      {
        std::cout << "  pixel " << i % 120 << " " << i / 120 << ": " << drawn << ", not "
                  << soft.Shares[i] << std::endl;
      }
    }
    // A map keeps its own error at edges, however many samples there are.
    RELIEVO_CHECK_AT_MOST(
      errors.PenumbraRms, method == 0 ? 0.06 : limit, what + ": rms error in the penumbra");
    RELIEVO_CHECK_AT_MOST(errors.Rms, limit, what + ": rms error");
    RELIEVO_CHECK_AT_MOST(std::abs(errors.PenumbraMean), 0.5 * limit, what + ": mean error");
  }
  vtkRelievoPass::Detach(scene.Renderer);
}

// A square lamp is a square: under an edge the share is a straight line.
void TestEdges()
{
  ShadowStage stage(80, 60);
  stage.AddGround();
  const auto mesh = relievoTest::MakePolygons(
    { { 0., 2., 20. }, { 20., 2., 20. }, { 20., 2., -20. }, { 0., 2., -20. } });
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2, 3 });
  relievoTest::AddActor(stage.Renderer, mesh);
  const auto lamp = stage.AddLamp({ 0., 4., 0. }, { 0., 0., 0. }, 90.);
  const double first[3] = { 2., 0., 0. };
  const double second[3] = { 0., 0., 1. };
  stage.GetShadows()->SetMethodToExact();
  stage.GetShadows()->SetSoftSamples(Samples);
  stage.GetShadows()->SetLightEdges(lamp, first, second);
  const auto image = relievoTest::CaptureShadow(stage, 0);
  relievoTest::EmbreeScene scene;
  scene.AddActors(stage.Renderer);
  const auto view = scene.Trace(relievoTest::View(stage.Renderer));
  double worst = 0.;
  int count = 0;
  for (std::size_t i = 0; i < view.Pixels.size(); ++i)
  {
    const glm::dvec3& p = view.Pixels[i].Position;
    if (view.Pixels[i].Hit && std::abs(p.y) < 1e-6 && std::abs(p.x) < 0.99)
    {
      worst = std::max(worst, std::abs(Visibility(image)[i] - 0.5 * (1. - p.x)));
      ++count;
    }
  }
  RELIEVO_CHECK_THAT(count > 400, "square lamp: too little is in the penumbra");
  RELIEVO_CHECK_AT_MOST(worst, 1. / Samples, "square lamp: largest error");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowSoft)
{
  relievoTest::Session session;
  TestSamples();
  TestEdge(vtkRelievoShadowStage::METHOD_MAP, SceneLight::Spot, 0.8);
  TestEdge(vtkRelievoShadowStage::METHOD_WARPED, SceneLight::Sun, 20.);
  TestEdge(vtkRelievoShadowStage::METHOD_EXACT, SceneLight::Sun, 0.53, 400);
  for (const double radius : { 0.2, 0.5, 1., 2. })
  {
    TestEdge(vtkRelievoShadowStage::METHOD_EXACT, SceneLight::Point, radius, 160);
  }
  const bool all = relievoTest::IsLong(argc, argv); // each mesh with each radius
  for (const double radius : { 0.2, 0.5, 1., 2. })
  {
    const bool isMiddle = radius == 0.5 || radius == 1.;
    if (all || !isMiddle)
    {
      TestMesh("bunny", SceneLight::Point, radius, 1.5 * Limit);
    }
    if (all || isMiddle)
    {
      TestMesh("arrows", SceneLight::Point, radius, 3. * Limit);
    }
  }
  TestEdges();
  TestFollowed(2., 8, 0.05);  // three pixels of penumbra
  TestFollowed(10., 8, 0.03); // a map for each of 24 samples: 0.031
  TestFollowed(10., 1, 0.06);
  TestNearest();
  TestMesh("bunny", SceneLight::Sun, 6., Limit,
    { vtkRelievoShadowStage::METHOD_MAP, vtkRelievoShadowStage::METHOD_EXACT });
  return session.Result();
}
}
