// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Embree's truth compared with closed forms, and its certainty about a pixel.
#include "AnalyticScene.h"
#include "Check.h"
#include "EmbreeScene.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>

namespace testEmbreeScene
{
namespace
{
using relievoTest::AnalyticScene;
using relievoTest::EmbreeScene;
using relievoTest::MakeBox;
using relievoTest::PixelTruth;
using relievoTest::Ray;
using relievoTest::Stage;
using relievoTest::SurfacePoint;
using relievoTest::TruthImage;
using relievoTest::View;

// Boxes are exact as triangles: depth, position, normal and coverage must equal the closed form.
void TestBoxes(const std::string& name, const glm::dvec3& origin, double depthLimit)
{
  Stage stage(401, 300, origin);
  EmbreeScene embree;
  AnalyticScene exact;
  const auto add = [&](const glm::dvec3& size, vtkTransform* place) {
    embree.AddActor(MakeBox(size.x, size.y, size.z), place->GetMatrix());
    exact.AddBox(0.5 * size, AnalyticScene::ToMatrix(place->GetMatrix()->GetData()));
  };
  vtkNew<vtkTransform> turned;
  turned->Translate(origin.x - 0.4, origin.y + 0.6, origin.z);
  turned->RotateWXYZ(33., 1., 2., 3.);
  add(glm::dvec3(1., 1.3, 0.8), turned);
  vtkNew<vtkTransform> mirrored;
  mirrored->Translate(origin.x + 0.9, origin.y + 0.5, origin.z + 0.3);
  mirrored->RotateY(20.);
  mirrored->Scale(-0.5, 1., 2.);
  add(glm::dvec3(1., 1., 1.), mirrored);
  vtkNew<vtkTransform> ground;
  ground->Translate(origin.x, origin.y - 0.5, origin.z);
  add(glm::dvec3(6., 1., 6.), ground);

  for (const bool parallel : { false, true })
  {
    stage.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    stage.Renderer->GetActiveCamera()->SetParallelScale(1.8);
    const View view(stage.Renderer);
    const TruthImage seen = embree.Trace(view);
    const TruthImage truth = exact.Trace(view);
    RELIEVO_CHECK(seen.Width == 401 && seen.Height == 300);
    double worstDepth = 0.;
    double worstAngle = 0.;
    double worstPlace = 0.;
    long long other = 0;
    long long otherInner = 0;
    long long wrongSide = 0;
    for (size_t i = 0; i < truth.Pixels.size(); ++i)
    {
      const PixelTruth& s = seen.Pixels[i];
      const PixelTruth& t = truth.Pixels[i];
      // Both tracers must hit the same actor and, if it has edges, the same face.
      if (s.Hit != t.Hit || s.Actor != t.Actor ||
        (s.Hit && relievoTest::AngleDegrees(s.Normal, t.Normal) > 1.))
      {
        ++other;
        otherInner += s.Inner || t.Inner ? 1 : 0;
        continue;
      }
      if (!s.Hit)
      {
        continue;
      }
      worstDepth = std::max(worstDepth, std::abs(s.Depth / t.Depth - 1.));
      worstAngle = std::max(worstAngle, relievoTest::AngleDegrees(s.Normal, t.Normal));
      worstPlace = std::max(worstPlace, glm::length(s.Position - t.Position));
      wrongSide += s.FrontFacing && t.FrontFacing ? 0 : 1;
    }
    const std::string what = name + (parallel ? ", parallel: " : ": ");
    std::cout << what << truth.NumberOfHits() << " pixels hit, " << truth.NumberOfInner()
              << " inner by closed form, " << seen.NumberOfInner() << " by Embree, " << other
              << " of another face\n";
    RELIEVO_CHECK(truth.NumberOfHits() > 30000);
    RELIEVO_CHECK(truth.NumberOfInner() > 0.95 * truth.NumberOfHits());
    RELIEVO_CHECK(seen.NumberOfInner() > 0.95 * truth.NumberOfHits());
    RELIEVO_CHECK(otherInner == 0 && wrongSide == 0);
    RELIEVO_CHECK_AT_MOST(static_cast<double>(other), 5., what + "pixels of another face");
    RELIEVO_CHECK_AT_MOST(worstDepth, depthLimit, what + "depth, relative");
    RELIEVO_CHECK_AT_MOST(worstAngle, 1e-6, what + "normal, degrees");
    RELIEVO_CHECK_AT_MOST(worstPlace, 20. * depthLimit, what + "position");
  }
}

// A tessellation touches its surface with its corners; the truth lies between.
void TestTessellations()
{
  Stage stage(300, 300);
  const View view(stage.Renderer);
  {
    const int around = 200;
    vtkNew<vtkSphereSource> sphere;
    sphere->SetThetaResolution(2 * around);
    sphere->SetPhiResolution(around + 1);
    sphere->SetRadius(1.);
    sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    sphere->Update();
    EmbreeScene embree;
    embree.AddActor(sphere->GetOutput());
    AnalyticScene exact;
    exact.AddSphere(1.);
    const TruthImage seen = embree.Trace(view);
    const TruthImage truth = exact.Trace(view);
    // A cell spans pi / around in both directions: its middle's depth is bounded by its half
    // diagonal.
    const double half = std::acos(-1.) / around / 2. * std::sqrt(2.);
    const double sag = 1. - std::cos(half);
    double deepest = 0.;
    double highest = 0.;
    double worstAngle = 0.;
    long long outside = 0;
    for (size_t i = 0; i < seen.Pixels.size(); ++i)
    {
      const PixelTruth& s = seen.Pixels[i];
      outside += s.Hit && !truth.Pixels[i].Hit ? 1 : 0;
      if (!s.Hit)
      {
        continue;
      }
      const double radius = glm::length(s.Position);
      deepest = std::max(deepest, 1. - radius);
      highest = std::max(highest, radius - 1.);
      worstAngle = std::max(worstAngle, relievoTest::AngleDegrees(s.Normal, s.Position));
      RELIEVO_CHECK(s.FrontFacing && s.Actor == 0);
    }
    std::cout << "sphere: " << seen.NumberOfHits() << " pixels hit, " << truth.NumberOfHits()
              << " by closed form\n";
    RELIEVO_CHECK(outside == 0 && seen.NumberOfHits() > 0.99 * truth.NumberOfHits());
    RELIEVO_CHECK_AT_MOST(deepest, sag, "sphere: deepest place below the surface");
    RELIEVO_CHECK_THAT(deepest > 0.3 * sag, "the bound must be near what is found");
    RELIEVO_CHECK_AT_MOST(highest, 1e-14, "sphere: highest place above the surface");
    RELIEVO_CHECK_AT_MOST(worstAngle, glm::degrees(half), "sphere: normal, degrees");
  }
  {
    vtkNew<vtkParametricTorus> function;
    function->SetRingRadius(1.);
    function->SetCrossSectionRadius(0.4);
    vtkNew<vtkParametricFunctionSource> source;
    source->SetParametricFunction(function);
    source->SetUResolution(400);
    source->SetVResolution(200);
    source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    source->Update();
    EmbreeScene embree;
    embree.AddActor(source->GetOutput());
    AnalyticScene exact;
    exact.AddTorus(1., 0.4);
    const TruthImage seen = embree.Trace(view);
    const TruthImage truth = exact.Trace(view);
    const double cell = std::acos(-1.) * std::hypot(1.4 * 2. / 400., 0.4 * 2. / 200.);
    double worst = 0.;
    long long other = 0;
    for (size_t i = 0; i < seen.Pixels.size(); ++i)
    {
      const PixelTruth& s = seen.Pixels[i];
      other += s.Hit != truth.Pixels[i].Hit ? 1 : 0;
      if (s.Hit && truth.Pixels[i].Inner)
      {
        const glm::dvec3& p = s.Position;
        worst = std::max(worst, std::abs(std::hypot(std::hypot(p.x, p.y) - 1., p.z) - 0.4));
      }
    }
    std::cout << "torus: " << truth.NumberOfHits() << " pixels hit, " << other << " differ\n";
    RELIEVO_CHECK(truth.NumberOfHits() > 3000 && other < 0.01 * truth.NumberOfHits());
    RELIEVO_CHECK_AT_MOST(worst, cell * cell / 8. / 0.4, "torus: off the surface");
  }
}

// In an inner pixel no ray may hit anything else; in others some must.
void TestInner()
{
  Stage stage(300, 200);
  const View view(stage.Renderer);
  EmbreeScene scene;
  vtkNew<vtkMatrix4x4> place;
  place->SetElement(1, 3, 0.5);
  scene.AddActor(MakeBox(1., 1., 1.), place);
  place->SetElement(1, 3, -0.5);
  scene.AddActor(MakeBox(6., 1., 6.), place);
  const TruthImage image = scene.Trace(view);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0., 1.);
  long long flips = 0;
  long long outerFlips = 0;
  long long wrongEdge = 0;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      const PixelTruth& pixel = image.At(x, y);
      if (!pixel.Hit)
      {
        continue;
      }
      bool same = true;
      for (int i = 0; i < 8; ++i)
      {
        const Ray ray = view.PixelRay(x + share(random), y + share(random));
        same = same && scene.Cast(ray, view.Near, view.Far).Actor == pixel.Actor;
      }
      flips += pixel.Inner && !same ? 1 : 0;
      outerFlips += !pixel.Inner && !same ? 1 : 0;
      // Nearer than the edge, the hit triangle does not change.
      const double angle = 6.28 * share(random);
      const double reach = std::min(0.99 * pixel.EdgeDistance, 50.);
      const Ray within =
        view.PixelRay(x + 0.5 + reach * std::cos(angle), y + 0.5 + reach * std::sin(angle));
      const SurfacePoint there = scene.Cast(within, view.Near, view.Far);
      wrongEdge += pixel.Actor == 0 && there.Triangle != pixel.Triangle ? 1 : 0;
      RELIEVO_CHECK(
        pixel.EdgeDistance >= 0. && pixel.TriangleWidth > 2. * pixel.EdgeDistance - 1e-9);
    }
  }
  std::cout << "jitter: " << image.NumberOfInner() << " inner pixels, " << flips << " flips; "
            << outerFlips << " flips of others\n";
  RELIEVO_CHECK(flips == 0 && outerFlips > 100 && wrongEdge == 0);
}

// Shadows of a box and a rotated box on a ground compared with closed form.
void TestShadows()
{
  Stage stage(300, 300);
  const View view(stage.Renderer);
  EmbreeScene embree;
  AnalyticScene exact;
  vtkNew<vtkTransform> place;
  place->Translate(-0.3, 0.9, 0.2);
  place->RotateWXYZ(40., 1., 0.3, 0.2);
  embree.AddActor(MakeBox(1., 0.6, 0.8), place->GetMatrix());
  exact.AddBox({ 0.5, 0.3, 0.4 }, AnalyticScene::ToMatrix(place->GetMatrix()->GetData()));
  place->Identity();
  place->Translate(0.9, 0.25, 0.6);
  embree.AddActor(MakeBox(0.5, 0.5, 0.5), place->GetMatrix());
  exact.AddBox(glm::dvec3(0.25), AnalyticScene::ToMatrix(place->GetMatrix()->GetData()));
  place->Identity();
  place->RotateX(-90.);
  vtkNew<vtkPlaneSource> ground;
  ground->SetOrigin(-3., -3., 0.);
  ground->SetPoint1(3., -3., 0.);
  ground->SetPoint2(-3., 3., 0.);
  ground->Update();
  embree.AddActor(ground->GetOutput(), place->GetMatrix());
  exact.AddPlane(3., 3., AnalyticScene::ToMatrix(place->GetMatrix()->GetData()));

  const TruthImage image = embree.Trace(view);
  const glm::dvec3 light(3., 5., 2.);
  for (const bool sun : { true, false })
  {
    long long dark = 0;
    long long lit = 0;
    long long unstable = 0;
    long long mismatches = 0;
    for (const PixelTruth& pixel : image.Pixels)
    {
      const glm::dvec3 way = sun ? light : light - pixel.Position;
      if (!pixel.Hit || glm::dot(pixel.Normal, glm::normalize(way)) < 0.05)
      {
        continue;
      }
      const double far = sun ? std::numeric_limits<double>::infinity() : 1.;
      const relievoTest::ShadowVerdict verdict = embree.Shadow(pixel, way, far, 1e-3);
      if (!verdict.Stable)
      {
        ++unstable;
        continue;
      }
      const bool truth = exact.Occluded(Ray{ pixel.Position, way }, 1e-7, far);
      (truth ? dark : lit) += 1;
      mismatches += truth != verdict.Occluded ? 1 : 0;
    }
    std::cout << (sun ? "sun: " : "point light: ") << lit << " lit, " << dark << " dark, "
              << unstable << " left out, " << mismatches << " wrong\n";
    RELIEVO_CHECK(lit > 10000 && dark > 1000 && mismatches == 0);
    RELIEVO_CHECK(unstable > 0 && unstable < 0.02 * (lit + dark));
  }
}

}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testEmbreeScene)
{
  relievoTest::Session session;
  TestBoxes("boxes", glm::dvec3(0.), 1e-14);
  TestBoxes("boxes at (5e5, 5e6, 0)", glm::dvec3(5e5, 5e6, 0.), 2e-9);
  TestTessellations();
  TestInner();
  TestShadows();
  return session.Result();
}
}
