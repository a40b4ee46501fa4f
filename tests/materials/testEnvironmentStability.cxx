// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Mirrors where they fail: a sun in one texel, edges and corners of the cube, no normals, lights
// and texture coordinates, blocks, windows; and off, bit for bit.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "ReliefTruth.h"
#include "Session.h"
#include "Stage.h"
#include "Surroundings.h"
#include "TestCase.h"
#include "View.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoCompositeMapper.h>
#include <vtkRelievoEnvironment.h>
#include <vtkRelievoEnvironmentPrefilter.h>
#include <vtkRelievoMaterial.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoSkybox.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>

namespace testEnvironmentStability
{
namespace
{
using namespace relievoTest;

vtkSmartPointer<vtkPolyData> FineBall(bool normals)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1.);
  ball->SetThetaResolution(192);
  ball->SetPhiResolution(192);
  ball->SetGenerateNormals(normals);
  ball->Update();
  return ball->GetOutput();
}

struct Scene
{
  relievoTest::Stage Stage{ 161, 161 };
  vtkRenderer* Renderer = this->Stage.Renderer;
  vtkNew<vtkLight> Lamp;
  vtkNew<vtkRelievoEnvironment> Environment;
  vtkNew<vtkRelievoMaterial> Material;
  vtkSmartPointer<vtkActor> Actor;
  GLCheck Watch{ this->Stage.Window };

  Scene(vtkPolyData* mesh, const Light& light, int n)
    : Actor(AddActor(this->Renderer, mesh))
  {
    this->Lamp->SetLightTypeToSceneLight();
    this->Lamp->SetPosition(1., 2., 3.);
    this->Renderer->AddLight(this->Lamp);
    this->Actor->GetProperty()->SetInterpolationToPhong();
    this->Environment->SetImage(MakeEnvironment(light, Cube, n));
    this->Material->SetEnvironment(this->Environment);
    this->Material->SetReflectivity(1.);
    LookAlong(this->Renderer, { 0., 0., 6. }, { 0., 0., -1. }, 24.);
  }
  ~Scene() { this->Material->Detach(this->Actor); }
  std::vector<unsigned char> Picture() { return Photo(this->Stage.Window).Bytes; }
};

// One texel is a sun of 1e5. Only pixels that may see it are bright: those whose reflected ray,
// with the pixel's footprint, comes within two texels. All others equal the rest of the
// environment.
void TestSun()
{
  constexpr int Texels = 64;
  const glm::dvec3 sun = glm::normalize(glm::dvec3(1., 33. / 64., 23. / 64.)); // a texel's middle
  const Light light = [&](const glm::dvec3& d) {
    return glm::dvec3(glm::length(d - sun) < 1e-3 ? 1e5 : 0.1);
  };
  Scene scene(FineBall(true), light, Texels);
  double most = 0.;
  vtkDataArray* values = scene.Environment->GetImage()->GetPointData()->GetScalars();
  int suns = 0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    most = std::max(most, values->GetComponent(i, 0));
    suns += values->GetComponent(i, 0) > 1. ? 1 : 0;
  }
  RELIEVO_CHECK(most > 9e4 && suns == 1);
  scene.Material->Attach(scene.Actor);
  const Photo photo(scene.Stage.Window);
  const View view(scene.Renderer);
  const auto mirrored = [&](double x, double y, glm::dvec3& r) {
    const Ray ray = view.PixelRay(x, y);
    const glm::dvec3 d = glm::normalize(ray.Direction);
    const double b = glm::dot(ray.Origin, d);
    const double root = b * b - glm::dot(ray.Origin, ray.Origin) + 1.;
    if (root < 0.02) // the rim, where one pixel sees half of all
    {
      return false;
    }
    r = glm::reflect(d, ray.Origin + (-b - std::sqrt(root)) * d);
    return true;
  };
  int bright = 0;
  int dark = 0;
  int mismatches = 0;
  for (int y = 0; y < photo.Height; ++y)
  {
    for (int x = 0; x < photo.Width; ++x)
    {
      glm::dvec3 r;
      glm::dvec3 beside[2];
      if (!mirrored(x + 0.5, y + 0.5, r) || !mirrored(x + 1.5, y + 0.5, beside[0]) ||
        !mirrored(x + 0.5, y + 1.5, beside[1]))
      {
        continue;
      }
      const double width = std::max(glm::length(r - beside[0]), glm::length(r - beside[1]));
      const double level = std::max(0., std::ceil(std::log2(width * Texels / 2.)));
      const double reach = 2.5 * 2. / Texels * std::exp2(level);
      const double away = glm::length(r - sun);
      const double value = 255. * photo.At(x, y).x;
      const bool plain = value > 24.5 && value < 26.5;
      bright += plain ? 0 : 1;
      dark += value < 24.5 ? 1 : 0;
      mismatches += !plain && away > reach ? 1 : 0;
    }
  }
  RELIEVO_CHECK_THAT(bright > 3 && bright < 600, "the sun is seen: " + std::to_string(bright));
  RELIEVO_CHECK_THAT(dark == 0, "NaN would be dark: " + std::to_string(dark));
  RELIEVO_CHECK_THAT(mismatches == 0, "fireflies: " + std::to_string(mismatches));

  vtkNew<vtkRelievoEnvironmentPrefilter> levels;
  levels->SetInputData(scene.Environment->GetImage());
  levels->SetSize(32);
  levels->Update();
  scene.Environment->SetLevels(levels->GetOutput());
  for (int i = 0; i <= 10; ++i)
  {
    scene.Material->SetRoughness(i / 10.);
    const Photo rough(scene.Stage.Window);
    int black = 0;
    for (int y = 40; y < 121; ++y)
    {
      for (int x = 40; x < 121; ++x)
      {
        black += rough.At(x, y).x < 0.09 ? 1 : 0;
      }
    }
    RELIEVO_CHECK_THAT(black == 0, "rough sun: dark pixels " + std::to_string(black));
  }
}

// Mirrored directions exactly on edges and corners, in the middle pixel of a plane.
void TestEdges()
{
  const Light uneven = [](const glm::dvec3& d) {
    const double noise = std::sin(317. * d.x + 211. * d.y + 97. * d.z);
    return glm::dvec3(0.5 + 0.15 * noise, 0.5 - 0.15 * noise, 0.5);
  };
  Scene scene(ReliefPlane(1), uneven, 4);
  scene.Material->Attach(scene.Actor);
  scene.Actor->GetProperty()->LightingOn();
  int ramps = 0;
  for (int corner = 0; corner < 9; ++corner)
  {
    const glm::dvec3 mirrored(corner % 3 - 1., corner / 3 - 1., 1.);
    if (glm::dot(mirrored, mirrored) < 1.5)
    {
      continue;
    }
    const glm::dvec3 forward(mirrored.x, mirrored.y, -mirrored.z);
    LookAlong(scene.Renderer, -2. * forward, forward, 10.);
    const Photo photo(scene.Stage.Window);
    int step = 0;
    int least = 255;
    int most = 0;
    for (int y = 1; y < photo.Height; ++y)
    {
      for (int x = 1; x < photo.Width; ++x)
      {
        const int here = photo.Bytes[3 * (static_cast<std::size_t>(y) * photo.Width + x)];
        const int left = photo.Bytes[3 * (static_cast<std::size_t>(y) * photo.Width + x - 1)];
        const int below = photo.Bytes[3 * (static_cast<std::size_t>(y - 1) * photo.Width + x)];
        step = std::max({ step, std::abs(here - left), std::abs(here - below) });
        least = std::min(least, here);
        most = std::max(most, here);
      }
    }
    ramps += most - least > 3 ? 1 : 0;
    RELIEVO_CHECK_AT_MOST(step, 1., "a pixel to the next about an edge or corner, 255ths");
  }
  RELIEVO_CHECK_THAT(ramps > 3, "the edges' sides differ: " + std::to_string(ramps));
}

void TestOff()
{
  for (const int shading : { VTK_FLAT, VTK_GOURAUD, VTK_PHONG, VTK_PBR })
  {
    Scene scene(FineBall(true), Smooth, 32);
    scene.Actor->GetProperty()->SetInterpolation(shading);
    const auto plain = scene.Picture();
    scene.Material->Attach(scene.Actor);
    const auto with = scene.Picture();
    RELIEVO_CHECK_THAT(with != plain, "the environment is seen");
    scene.Material->EnabledOff();
    RELIEVO_CHECK_THAT(scene.Picture() == plain, "disabled: bit for bit");
    scene.Material->EnabledOn();
    scene.Material->SetEnvironment(nullptr);
    RELIEVO_CHECK_THAT(scene.Picture() == plain, "no environment: bit for bit");
    scene.Material->SetEnvironment(scene.Environment);
    RELIEVO_CHECK_THAT(scene.Picture() == with, "and on again");
    scene.Material->Detach(scene.Actor);
    RELIEVO_CHECK_THAT(scene.Picture() == plain, "detached: bit for bit");
    scene.Material->Attach(scene.Actor);
    ExpectMessage expect("No environment");
    vtkNew<vtkImageData> empty;
    scene.Environment->SetImage(empty);
    RELIEVO_CHECK_THAT(scene.Picture() == plain, "an empty image: bit for bit");
    scene.Environment->SetImage(MakeEnvironment(Smooth, Cube, 32));
    RELIEVO_CHECK_THAT(scene.Picture() == with, "an image again");
    scene.Renderer->RemoveLight(scene.Lamp);
    scene.Renderer->AutomaticLightCreationOff();
    const auto unlit = scene.Picture();
    scene.Material->EnabledOff();
    RELIEVO_CHECK_THAT(scene.Picture() == unlit, "without lights: none");
  }
}

void TestMeshes()
{
  // Without normals at the points and texture coordinates: about the faces' normals.
  Scene scene(FineBall(false), Smooth, 64);
  scene.Material->Attach(scene.Actor);
  const auto one = scene.Picture();
  Scene smooth(FineBall(true), Smooth, 64);
  smooth.Material->Attach(smooth.Actor);
  const auto other = smooth.Picture();
  double mean = 0.;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    mean += std::abs(double(one[i]) - double(other[i]));
  }
  RELIEVO_CHECK_AT_MOST(mean / one.size(), 2., "by faces against by points, mean, 255ths");

  // Blocks, glyphs, layers and shadows.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, FineBall(true));
  vtkNew<vtkRelievoCompositeMapper> composite;
  composite->SetInputDataObject(blocks);
  smooth.Actor->SetMapper(composite);
  const auto differing = [&other](const std::vector<unsigned char>& picture) {
    int count = 0;
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      count += std::abs(int(picture[i]) - int(other[i])) > 2 ? 1 : 0;
    }
    return count;
  };
  RELIEVO_CHECK_THAT(differing(smooth.Picture()) == 0, "blocks: as one mesh");
  vtkNew<vtkPolyData> point;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0., 0., 0.);
  point->SetPoints(points);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(point);
  glyphs->SetSourceData(FineBall(true));
  smooth.Actor->SetMapper(glyphs);
  RELIEVO_CHECK_THAT(differing(smooth.Picture()) < 50, "glyphs: as one mesh");
  const Layers layers(scene.Renderer, { "depth", "normal", "albedo" });
  RELIEVO_CHECK_NEAR(layers.Value("depth", 80, 80), 5., 0.01, "depth");
  vtkRelievoPass* frame = vtkRelievoPass::Attach(scene.Renderer);
  RELIEVO_CHECK_THAT(scene.Picture() == one, "in a frame with nothing on");
  frame->ShadowsOn();
  scene.Picture();
  vtkRelievoPass::Detach(scene.Renderer);
  RELIEVO_CHECK_THAT(scene.Picture() == one, "after the frame");
}

void TestTogether()
{
  // One environment, two materials with maps of their own, a sky, two windows.
  Scene scene(FineBall(true), Smooth, 64);
  scene.Material->Attach(scene.Actor);
  vtkNew<vtkRelievoMaterial> second;
  second->SetEnvironment(scene.Environment);
  second->SetHeightMap(HeightImage(Waves, 32));
  auto plane = AddActor(scene.Renderer, ReliefPlane(4));
  plane->SetPosition(0., 0., -1.5);
  second->Attach(plane);
  vtkNew<vtkRelievoSkybox> sky;
  sky->SetEnvironment(scene.Environment);
  scene.Renderer->AddViewProp(sky);
  const auto picture = scene.Picture();
  Scene other(FineBall(true), Smooth, 16);
  other.Material->SetEnvironment(scene.Environment);
  other.Material->Attach(other.Actor);
  other.Picture();
  RELIEVO_CHECK_THAT(scene.Picture() == picture, "after another window");
  for (int i = 0; i < 100; ++i)
  {
    // More than there are texture units, if one were lost each time.
    scene.Material->SetEnabled(i % 2 == 0);
    second->SetEnvironment(i % 3 == 0 ? nullptr : scene.Environment.GetPointer());
    sky->SetVisibility(i % 5 != 0);
    scene.Environment->SetRotation(i);
    scene.Picture();
  }
  scene.Material->EnabledOn();
  second->SetEnvironment(scene.Environment);
  sky->VisibilityOn();
  scene.Environment->SetRotation(0.);
  RELIEVO_CHECK_THAT(scene.Picture() == picture, "after 100 toggles");
  const vtkIdType texture = 6 * 64 * 64 * 3 * 2 * 4 / 3;
  RELIEVO_CHECK(scene.Environment->GetBytesHeld() == 2 * texture); // in each window once
  scene.Environment->ReleaseGraphicsResources(other.Stage.Window);
  RELIEVO_CHECK(scene.Environment->GetBytesHeld() == texture);
  scene.Environment->ReleaseGraphicsResources(nullptr);
  RELIEVO_CHECK(scene.Environment->GetBytesHeld() == 0);
  RELIEVO_CHECK_THAT(scene.Picture() == picture, "after a release");
  second->Detach(plane);
}
}

RELIEVO_TEST_CASE(testEnvironmentStability)
{
  relievoTest::Session session;
  TestSun();
  TestEdges();
  TestOff();
  TestMeshes();
  TestTogether();
  return session.Result();
}
}
