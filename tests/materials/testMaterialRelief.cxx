// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth and normals of relief against rays marched in double precision through the height fields.
#include "Check.h"
#include "GLCheck.h"
#include "Props.h"
#include "ReliefTruth.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoMaterial.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace testMaterialRelief
{
namespace
{
using namespace relievoTest;

constexpr double Scale = 0.2; // a tenth of a tile
constexpr int Texels = 512;

ReliefErrors Measure(vtkRenderer* renderer, const HeightField& field)
{
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(renderer);
  source->AddLayer("depth");
  source->AddLayer("normal");
  source->Update();
  return CompareRelief(source->GetOutput(), renderer, field, Scale);
}

struct Scene
{
  relievoTest::Stage Stage{ 400, 300 };
  vtkSmartPointer<vtkActor> Actor = AddActor(this->Stage.Renderer, ReliefPlane(4));
  vtkNew<vtkRelievoMaterial> Material;
  GLCheck Watch{ this->Stage.Window };

  explicit Scene(const HeightField& field)
  {
    // Heights above a sea: their range starts at 2.
    const vtkSmartPointer<vtkImageData> heights = HeightImage(field, Texels);
    vtkDataArray* values = heights->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      values->SetComponent(i, 0, 2. + 3. * values->GetComponent(i, 0));
    }
    this->Material->SetHeightMap(heights);
    this->Material->SetHeightRange(2., 5.);
    this->Material->SetHeightScale(Scale);
    this->Material->DepthCorrectionOn();
    this->Material->Attach(this->Actor);
  }
  ~Scene() { this->Material->Detach(this->Actor); }
};

void TestWaves()
{
  Scene scene(Waves);
  vtkRenderer* renderer = scene.Stage.Renderer;
  for (const bool parallel : { false, true })
  {
    for (const double angle : { 0., 45., 60., 75., 80. })
    {
      LookAtRelief(renderer, angle, parallel);
      const std::string what =
        "waves at " + std::to_string(static_cast<int>(angle)) + (parallel ? ", parallel" : "");
      const ReliefErrors errors = Measure(renderer, Waves);
      RELIEVO_CHECK_THAT(errors.Rays > 500, what + ": rays");
      RELIEVO_CHECK_AT_MOST(
        errors.Depth, angle <= 60. ? 0.001 : 0.002, what + ": mean depth error");
      RELIEVO_CHECK_AT_MOST(errors.Missed, angle <= 75. ? 0.002 : 0.015, what + ": missed");
      RELIEVO_CHECK_AT_MOST(errors.Normal, 1.0, what + ": mean normal error, degrees");
    }
  }
}

// The published order of the methods, and errors of methods that are too simple.
void TestMethods()
{
  Scene scene(Waves);
  vtkRenderer* renderer = scene.Stage.Renderer;
  LookAtRelief(renderer, 60.);
  double before = 1.;
  for (int method = vtkRelievoMaterial::METHOD_PARALLAX;
       method <= vtkRelievoMaterial::METHOD_RELIEF; ++method)
  {
    scene.Material->SetReliefMethod(method);
    const ReliefErrors errors = Measure(renderer, Waves);
    const double error = errors.Depth * (1. - errors.Missed) + 0.05 * errors.Missed;
    std::cout << "method " << method << ": mean " << errors.Depth << ", missed " << errors.Missed
              << "\n";
    RELIEVO_CHECK_THAT(error < before, "method " + std::to_string(method) + " is better");
    before = error;
  }
}

void TestPosts()
{
  // Four texels thin, in a tile of 512.
  const HeightField field = Posts(4. / Texels);
  Scene scene(field);
  vtkRenderer* renderer = scene.Stage.Renderer;
  const HeightField seen = Sampled(field, Texels);
  for (const double angle : { 45., 60., 75. })
  {
    LookAtRelief(renderer, angle);
    renderer->GetActiveCamera()->SetViewAngle(8.);
    const std::string what = "posts at " + std::to_string(static_cast<int>(angle));
    RELIEVO_CHECK_AT_MOST(
      Measure(renderer, seen).Missed, 0.01, what + ": missed at the default steps");
  }
  // The fixed steps of the simple methods must be seen to miss posts.
  scene.Material->SetMaximumSteps(16);
  RELIEVO_CHECK_THAT(Measure(renderer, seen).Missed > 0.02, "16 steps miss posts at 75");
}

// Self-shadowing of the relief in a sun, by the picture: dark or not.
void TestSelfShadow()
{
  Scene scene(Waves);
  vtkRenderer* renderer = scene.Stage.Renderer;
  LookAtRelief(renderer, 45.);
  renderer->RemoveAllLights();
  vtkNew<vtkLight> sun;
  const glm::dvec3 towards = glm::normalize(glm::dvec3(1., 0.3, 0.45));
  sun->SetPosition(towards.x, towards.y, towards.z);
  sun->SetFocalPoint(0., 0., 0.);
  renderer->AddLight(sun);
  scene.Actor->GetProperty()->SetAmbient(0.);
  scene.Material->SelfShadowOn();
  scene.Stage.Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  scene.Stage.Window->GetPixelData(0, 0, 399, 299, 0, pixels);
  auto isBlocked = [&](const glm::dvec2& uv, double depth) {
    const glm::dvec2 through = glm::dvec2(towards) / towards.z * depth * Scale / 2.;
    for (double way = 0.002; way < 1.; way += 0.002)
    {
      if (Waves(uv + way * through) > 1. - depth * (1. - way) + 1e-4)
      {
        return true;
      }
    }
    return false;
  };
  int mismatches = 0;
  int counted = 0;
  int dark = 0;
  for (int y = 2; y < 300; y += 5)
  {
    for (int x = 2; x < 400; x += 5)
    {
      const ReliefRay ray = RayOf(renderer, x, y);
      if (!ray.HitsPlane)
      {
        continue;
      }
      const double depth = MeetRelief(Waves, ray, Scale);
      const glm::dvec2 uv = ReliefTCoord(ray, Scale, depth);
      const glm::dvec3 normal = glm::normalize(glm::dvec3(-SlopeOf(Waves, uv) * Scale / 2., 1.));
      const bool blocked = isBlocked(uv, depth);
      bool edge = glm::dot(normal, towards) < 0.05;
      for (const double j : { -0.004, 0.004 })
      {
        for (const glm::dvec2& by : { glm::dvec2(j, 0.), glm::dvec2(0., j) })
        {
          edge = edge || isBlocked(uv + by, 1. - Waves(uv + by)) != blocked;
        }
      }
      if (edge)
      {
        continue;
      }
      ++counted;
      dark += blocked ? 1 : 0;
      mismatches += (pixels->GetComponent(y * 400 + x, 0) < 3.) != blocked ? 1 : 0;
    }
  }
  std::cout << "self-shadow: " << counted << " rays, " << dark << " dark, " << mismatches
            << " wrong\n";
  RELIEVO_CHECK_THAT(counted > 500 && dark > counted / 20, "self-shadow: there is some");
  RELIEVO_CHECK_AT_MOST(static_cast<double>(mismatches) / counted, 0.01, "self-shadow: wrong");
  scene.Material->SelfShadowOff();
  scene.Stage.Window->Render();
  vtkNew<vtkUnsignedCharArray> without;
  scene.Stage.Window->GetPixelData(0, 0, 399, 299, 0, without);
  int darker = 0;
  for (vtkIdType i = 0; i < without->GetNumberOfTuples(); ++i)
  {
    darker += without->GetComponent(i, 0) > pixels->GetComponent(i, 0) + 2. ? 1 : 0;
  }
  RELIEVO_CHECK_THAT(darker > 1000, "without self-shadow more is lit");
}
}

RELIEVO_TEST_CASE(testMaterialRelief)
{
  relievoTest::Session session;
  TestWaves();
  TestMethods();
  TestPosts();
  TestSelfShadow();
  return session.Result();
}
}
