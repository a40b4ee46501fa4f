// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact shadows of spheres and of poles to the horizon, under every kind of light and in three
// shapes of windows, against rays in double precision that try all triangles: this truth shares no
// code with the tested one, nor with Embree.
#include "BruteScene.h"
#include "Check.h"
#include "Props.h"
#include "Session.h"
#include "ShadowScenes.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRenderer.h>
#include <vtkSMPTools.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace testShadowExactDouble
{
namespace
{
using relievoTest::BruteScene;
using relievoTest::Ray;
using relievoTest::ShadowStage;

constexpr double Limit = 2e-5;

// Nine spheres, every other one off the ground.
void AddSpheres(ShadowStage& stage)
{
  stage.AddGround();
  for (int i = 0; i < 9; ++i)
  {
    const double radius = 0.08 + 0.03 * i;
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(-1.5 + 1.5 * (i % 3), radius + 0.3 * (i % 2), -1.5 + 1.5 * (i / 3));
    sphere->SetRadius(radius);
    sphere->SetThetaResolution(60);
    sphere->SetPhiResolution(30);
    sphere->Update();
    relievoTest::AddActor(stage.Renderer, sphere->GetOutput());
  }
}

// The light as seen by a ray.
struct Source
{
  glm::dvec3 Position{ 0. };
  glm::dvec3 Axis{ 0. };
  bool Positional = false;
  double Cosine = -1.; // of the cone

  explicit Source(vtkLight* light)
  {
    glm::dvec3 focus;
    light->GetPosition(&this->Position.x);
    light->GetFocalPoint(&focus.x);
    this->Axis = glm::normalize(focus - this->Position);
    this->Positional = light->GetPositional() != 0;
    if (this->Positional && light->GetConeAngle() < 90.)
    {
      this->Cosine = std::cos(glm::radians(light->GetConeAngle()));
    }
  }

  glm::dvec3 From(const glm::dvec3& place) const
  {
    return this->Positional ? this->Position - place : -this->Axis;
  }
};

enum Verdict
{
  Unjudged,
  Lit,
  Dark
};

Verdict Judge(
  const BruteScene& scene, const Source& source, const Ray& eye, const BruteScene::Hit& hit)
{
  const glm::dvec3 place = eye.At(hit.T);
  const glm::dvec3 toLight = source.From(place);
  const glm::dvec3 unit = glm::normalize(toLight);
  if (glm::dot(hit.Normal, unit) <= 0.05 || glm::dot(-unit, source.Axis) < source.Cosine + 1e-3)
  {
    return Unjudged;
  }
  const double end = source.Positional ? 1. : std::numeric_limits<double>::infinity();
  return scene.Occluded({ place, toLight }, end, hit.Triangle) ? Dark : Lit;
}

Verdict Judge(
  const BruteScene& scene, const Source& source, const Ray& eye, const relievoTest::View& view)
{
  const BruteScene::Hit hit = scene.Cast(eye, view.Near, view.Far);
  return hit.IsThere() ? Judge(scene, source, eye, hit) : Unjudged;
}

// OpenGL places corners in steps of 1/256 of a pixel, which moves the depth of surfaces seen nearly
// edge-on: where triangles meet, it may show any of them. Whether one has another verdict.
bool IsTie(const BruteScene& scene, const Source& source, const relievoTest::View& view, double x,
  double y, Verdict truth)
{
  for (int i = 0; i < 9; ++i)
  {
    const double off = 1. / 256.;
    const Ray eye = view.PixelRay(x + off * (i % 3 - 1), y + off * (i / 3 - 1));
    const auto hits = scene.CastNear(eye, view.Near, view.Far, 5e-4);
    const bool same = std::all_of(hits.begin(), hits.end(),
      [&](const BruteScene::Hit& hit) { return Judge(scene, source, eye, hit) == truth; });
    if (hits.empty() || !same)
    {
      return true;
    }
  }
  return false;
}

void Test(ShadowStage& stage, const std::string& what)
{
  stage.GetShadows()->SetMethodToExact();
  const auto image = relievoTest::CaptureShadow(stage, 0);
  const float* drawn =
    vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("shadow_0"))->GetPointer(0);
  BruteScene scene;
  vtkActorCollection* actors = stage.Renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    scene.Add(vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput());
  }
  const relievoTest::View view(stage.Renderer);
  const Source source(vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0)));
  std::atomic<long long> judged(0);
  std::atomic<long long> dark(0);
  std::atomic<long long> mismatches(0);
  std::atomic<long long> ties(0);
  vtkSMPTools::For(0, view.Height, 1, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType row = from; row < to; ++row)
    {
      for (int column = 0; column < view.Width; ++column)
      {
        const double x = column + 0.5;
        const double y = static_cast<double>(row) + 0.5;
        const Verdict truth = Judge(scene, source, view.PixelRay(x, y), view);
        const Verdict shown = drawn[row * view.Width + column] < 0.5f ? Dark : Lit;
        if (truth == Unjudged)
        {
          continue;
        }
        ++judged;
        dark += truth == Dark ? 1 : 0;
        if (shown == truth)
        {
          continue;
        }
        ++(IsTie(scene, source, view, x, y, truth) ? ties : mismatches);
      }
    }
  });
  const auto all = static_cast<double>(judged);
  std::cout << what << ": " << mismatches << " wrong of " << judged << " ("
            << 100. * mismatches / all << " %), " << dark << " dark, " << ties << " ties left out, "
            << scene.GetNumberOfTriangles() << " triangles\n";
  RELIEVO_CHECK_THAT(judged > 20000 && dark > judged / 500, what + ": too little is judged");
  RELIEVO_CHECK_AT_MOST(
    static_cast<double>(mismatches) / all, Limit, what + ": share of wrong verdicts");
  RELIEVO_CHECK_AT_MOST(static_cast<double>(ties) / all, 1e-3, what + ": ties left out");
}

void AddLight(ShadowStage& stage, int kind)
{
  switch (kind)
  {
    case 0:
      stage.AddSun(3., 5., 2.);
      break;
    case 1:
      stage.AddSun(3., 0.64, 2.); // 10 degrees
      break;
    case 2:
      stage.AddLamp({ 3., 5., 2. }, { 0., 0., 0. }, 60.);
      break;
    default:
      stage.AddLamp({ -1.2, 2., 1.1 }, { 0., 0., 0. }, 90.);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testShadowExactDouble)
{
  relievoTest::Session session;
  const std::array<std::array<int, 2>, 3> windows = { { { 360, 300 }, { 480, 225 },
    { 210, 520 } } };
  const char* names[] = { "sun", "sun at 10 degrees", "spot", "point light" };
  for (int kind = 0; kind < 4; ++kind)
  {
    for (const bool horizon : { false, true })
    {
      const auto& size = windows[(kind + (horizon ? 1 : 0)) % windows.size()];
      ShadowStage stage(size[0], size[1]);
      if (horizon)
      {
        stage.AddPolesToHorizon();
        stage.Renderer->RemoveAllLights();
      }
      else
      {
        AddSpheres(stage);
      }
      AddLight(stage, kind);
      Test(stage, std::string(horizon ? "poles" : "spheres") + ", " + names[kind]);
    }
  }
  return session.Result();
}
}
