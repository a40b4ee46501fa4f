// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth and normals of relief against rays marched in double precision through the height fields.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "ReliefTruth.h"
#include "Session.h"
#include "Stage.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkProperty.h>
#include <vtkRelievoMaterial.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace relievoTest;

constexpr double Scale = 0.2; // a tenth of a tile
constexpr int Texels = 512;

void Look(vtkCamera* camera, double degrees, bool parallel)
{
  const double angle = degrees * 3.14159265358979 / 180.;
  camera->SetPosition(0.3 * std::sin(angle), -4. * std::sin(angle), 4. * std::cos(angle));
  camera->SetFocalPoint(0., 0., 0.);
  camera->SetViewUp(0., 1., 0.);
  camera->SetViewAngle(20.);
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(0.7);
  camera->SetClippingRange(0.5, 9.);
}

struct Errors
{
  double Mean = 0.;   // of the depth below the plane, as a share of the relief's height
  double Missed = 0.; // share of rays that are off by more than 5 %
  double Normal = 0.; // degrees, mean over rays that are not missed
  double Depth = 0.;  // of the layer, relative, mean
  int Rays = 0;
};

Errors Measure(vtkRenderer* renderer, const HeightField& field, bool normals)
{
  Layers layers(renderer, { "depth", "normal" });
  Errors errors;
  int kept = 0;
  for (int y = 2; y < layers.Height; y += 5)
  {
    for (int x = 2; x < layers.Width; x += 5)
    {
      const ReliefRay ray = RayOf(renderer, x, y);
      if (!ray.MeetsPlane || !std::isfinite(layers.Value("depth", x, y)))
      {
        continue;
      }
      ++errors.Rays;
      const double truth = MeetRelief(field, ray, Scale);
      const double length = layers.Value("depth", x, y) / ray.AxisPerLength;
      const double below = -(ray.Origin + length * ray.Direction).z / Scale;
      const double wrong = std::abs(below - truth);
      if (wrong > 0.05)
      {
        errors.Missed += 1.;
        continue;
      }
      ++kept;
      errors.Mean += wrong;
      if (normals)
      {
        const glm::dvec2 uv = ReliefTCoord(ray, Scale, truth);
        const glm::dvec2 slope = SlopeOf(field, uv) * Scale / 2.; // a tile is 2 long
        const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope, 1.));
        const glm::dvec3 seen = layers.Vector("normal", x, y);
        errors.Normal += std::atan2(glm::length(glm::cross(normal, seen)), glm::dot(normal, seen)) *
          180. / 3.14159265358979;
      }
    }
  }
  errors.Missed /= errors.Rays;
  errors.Mean /= kept;
  errors.Normal /= kept;
  return errors;
}

struct Scene
{
  relievoTest::Stage Stage{ 400, 300 };
  vtkSmartPointer<vtkActor> Actor = AddActor(this->Stage.Renderer, ReliefPlane(4));
  vtkNew<vtkRelievoMaterial> Material;
  GLCheck Watch{ this->Stage.Window };

  explicit Scene(const HeightField& field)
  {
    this->Material->SetHeightMap(HeightImage(field, Texels));
    this->Material->SetHeightRange(0., 1.);
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
      Look(renderer->GetActiveCamera(), angle, parallel);
      const std::string what =
        "waves at " + std::to_string(static_cast<int>(angle)) + (parallel ? ", parallel" : "");
      const Errors errors = Measure(renderer, Waves, true);
      RELIEVO_CHECK_THAT(errors.Rays > 500, what + ": rays");
      RELIEVO_CHECK_AT_MOST(errors.Mean, angle <= 60. ? 0.001 : 0.002, what + ": mean depth error");
      RELIEVO_CHECK_AT_MOST(errors.Missed, angle <= 75. ? 0.002 : 0.01, what + ": missed");
      RELIEVO_CHECK_AT_MOST(errors.Normal, 1.0, what + ": mean normal error, degrees");
    }
  }
}

// The published order of the methods, and what a method that is too simple does.
void TestMethods()
{
  Scene scene(Waves);
  vtkRenderer* renderer = scene.Stage.Renderer;
  Look(renderer->GetActiveCamera(), 60., false);
  double before = 1.;
  for (int method = vtkRelievoMaterial::METHOD_PARALLAX;
       method <= vtkRelievoMaterial::METHOD_RELIEF; ++method)
  {
    scene.Material->SetMethod(method);
    const Errors errors = Measure(renderer, Waves, false);
    const double wrong = errors.Mean * (1. - errors.Missed) + 0.05 * errors.Missed;
    std::cout << "method " << method << ": mean " << errors.Mean << ", missed " << errors.Missed
              << "\n";
    RELIEVO_CHECK_THAT(wrong < before, "method " + std::to_string(method) + " is better");
    before = wrong;
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
    Look(renderer->GetActiveCamera(), angle, false);
    renderer->GetActiveCamera()->SetViewAngle(8.);
    const std::string what = "posts at " + std::to_string(static_cast<int>(angle));
    RELIEVO_CHECK_AT_MOST(
      Measure(renderer, seen, false).Missed, 0.01, what + ": missed at the default steps");
  }
  // The same with the fixed steps of the simple methods: they must be seen to miss.
  scene.Material->SetMaximumSteps(16);
  RELIEVO_CHECK_THAT(Measure(renderer, seen, false).Missed > 0.02, "16 steps miss posts at 75");
}

// What the relief itself blocks of a sun, seen in the picture: dark or not.
void TestSelfShadow()
{
  Scene scene(Waves);
  vtkRenderer* renderer = scene.Stage.Renderer;
  Look(renderer->GetActiveCamera(), 45., false);
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
  int wrong = 0;
  int counted = 0;
  int dark = 0;
  for (int y = 2; y < 300; y += 5)
  {
    for (int x = 2; x < 400; x += 5)
    {
      const ReliefRay ray = RayOf(renderer, x, y);
      if (!ray.MeetsPlane)
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
      wrong += (pixels->GetComponent(y * 400 + x, 0) < 3.) != blocked ? 1 : 0;
    }
  }
  std::cout << "self-shadow: " << counted << " rays, " << dark << " dark, " << wrong << " wrong\n";
  RELIEVO_CHECK_THAT(counted > 500 && dark > counted / 20, "self-shadow: there is some");
  RELIEVO_CHECK_AT_MOST(static_cast<double>(wrong) / counted, 0.01, "self-shadow: wrong");
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

int main()
{
  relievoTest::Session session;
  TestWaves();
  TestMethods();
  TestPosts();
  TestSelfShadow();
  return session.Result();
}
