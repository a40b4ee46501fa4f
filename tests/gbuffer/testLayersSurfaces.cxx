// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Partial surfaces: holes of cut-out textures, clipping planes, coincident surfaces.
#include "AnalyticScene.h"
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

namespace testLayersSurfaces
{
namespace
{
using relievoTest::AddActor;
using relievoTest::Layers;
using relievoTest::PixelTruth;
using relievoTest::Stage;
using relievoTest::SurfacePoint;
using relievoTest::TruthImage;
using relievoTest::View;
using relievoTest::Way;

glm::dmat4 Place(vtkActor* actor)
{
  return relievoTest::AnalyticScene::ToMatrix(actor->GetMatrix()->GetData());
}

void CompareActors(
  const std::string& what, const Stage& stage, const TruthImage& truth, int leastPerActor)
{
  for (const Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, { "depth", "actor" }, way);
    long long seen[2] = { 0, 0 };
    long long mismatches = 0;
    double depth = 0.;
    for (int y = 0; y < truth.Height; ++y)
    {
      for (int x = 0; x < truth.Width; ++x)
      {
        const PixelTruth& pixel = truth.At(x, y);
        if (!pixel.Inner)
        {
          continue;
        }
        mismatches += layers.Id("actor", x, y) != pixel.Actor ? 1 : 0;
        if (pixel.Hit && layers.Id("actor", x, y) == pixel.Actor)
        {
          ++seen[pixel.Actor];
          depth =
            std::max(depth, std::abs(layers.Value("depth", x, y) - pixel.Depth) / pixel.Depth);
        }
      }
    }
    const std::string name = what + ", " + relievoTest::ToString(way);
    RELIEVO_CHECK_THAT(
      seen[0] >= leastPerActor && seen[1] >= leastPerActor, name + ": too little is seen");
    RELIEVO_CHECK_AT_MOST(mismatches, 0, name + ": pixels with another actor");
    RELIEVO_CHECK_AT_MOST(depth, 1e-6, name + ": depth");
  }
}

// A cut-out square before a box: where the texture is transparent, the box or nothing is seen.
void TestCutOut()
{
  const Stage stage(200, 160);
  const auto square = AddActor(stage.Renderer, relievoTest::MakeSquare());
  const auto texture = relievoTest::MakeChecker(true);
  square->SetTexture(texture);
  square->SetPosition(0.3, 0.6, 0.8);
  square->RotateY(20.);
  const auto box = AddActor(stage.Renderer, relievoTest::MakeBox(1.4, 1.2, 0.6));
  box->SetPosition(-0.2, 0.4, -0.3);
  relievoTest::AnalyticScene front;
  front.AddPlane(1., 1., Place(square));
  relievoTest::AnalyticScene back;
  back.AddBox({ 0.7, 0.6, 0.3 }, Place(box));
  const glm::dmat4 toSquare = glm::inverse(Place(square));
  const TruthImage truth = relievoTest::TraceView(
    View(stage.Renderer), [&](const relievoTest::Ray& ray, double from, double to) {
      SurfacePoint near = front.Cast(ray, from, to);
      SurfacePoint far = back.Cast(ray, from, to);
      far.Actor = far.Hit ? 1 : -1;
      const int parity = near.Hit
        ? relievoTest::GetCheckerParity(glm::dvec3(toSquare * glm::dvec4(near.Position, 1.)))
        : 1;
      // A neighbour of another kind keeps the borders of texels out of the inner pixels.
      near.Actor = parity < 0 ? 7 : 0;
      return near.Hit && parity != 1 && near.Depth < far.Depth ? near : far;
    });
  TruthImage known = truth;
  for (PixelTruth& pixel : known.Pixels)
  {
    pixel.Inner = pixel.Inner && pixel.Actor != 7;
  }
  const relievoTest::GLCheck gl(stage.Window);
  CompareActors("cut-out texture", stage, known, 300);
}

// Two planes on a mapper: the inside of the box is visible through the removed parts.
void TestClipping()
{
  const Stage stage(200, 160);
  const auto box = AddActor(stage.Renderer, relievoTest::MakeBox(2., 1.4, 1.6));
  box->SetPosition(0.1, 0.5, 0.);
  box->RotateY(-15.);
  const auto ball = AddActor(stage.Renderer, relievoTest::MakeBox(0.7, 0.3, 0.3));
  ball->SetPosition(0.1, 0.6, 0.);
  const glm::dvec3 origins[2] = { { 0., 0.8, 0. }, { 0.6, 0., 0. } };
  const glm::dvec3 normals[2] = { { 0., -1., -0.3 }, { -1., 0.2, 0. } };
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origins[i].x, origins[i].y, origins[i].z);
    plane->SetNormal(normals[i].x, normals[i].y, normals[i].z);
    box->GetMapper()->AddClippingPlane(plane);
  }
  relievoTest::AnalyticScene shell;
  shell.AddBox({ 1., 0.7, 0.8 }, Place(box));
  relievoTest::AnalyticScene core;
  core.AddBox({ 0.35, 0.15, 0.15 }, Place(ball));
  const TruthImage truth = relievoTest::TraceView(
    View(stage.Renderer), [&](const relievoTest::Ray& ray, double from, double to) {
      SurfacePoint inside = core.Cast(ray, from, to);
      inside.Actor = inside.Hit ? 1 : -1;
      for (SurfacePoint wall = shell.Cast(ray, from, to); wall.Hit;
           wall = shell.Cast(ray, wall.Depth * (1. + 1e-9), to))
      {
        bool kept = true;
        for (int i = 0; i < 2; ++i)
        {
          kept = kept && glm::dot(wall.Position - origins[i], normals[i]) >= 0.;
        }
        if (kept)
        {
          return wall.Depth < inside.Depth ? wall : inside;
        }
      }
      return inside;
    });
  const relievoTest::GLCheck gl(stage.Window);
  CompareActors("clipping planes", stage, truth, 200);
  const std::vector<std::string> names = { "depth", "cell", "actor" };
  const Layers plain(stage.Renderer, names);
  box->GetProperty()->EdgeVisibilityOn();
  for (const float width : { 1.f, 7.f })
  {
    box->GetProperty()->SetLineWidth(width);
    CompareActors("clipping planes, edges shown", stage, truth, 200);
    // VTK widens faces by the edges' width, and layers are of the faces.
    for (const Way way : relievoTest::BothWays)
    {
      const Layers edges(stage.Renderer, names, way);
      for (const std::string& name : names)
      {
        RELIEVO_CHECK_AT_MOST(relievoTest::CountDifferent(plain, edges, name), 0,
          "edges shown, " + relievoTest::ToString(way) + ": pixels of the layer " + name);
      }
    }
  }
}

// Two squares in one plane: the one drawn nearer is visible, at the plane's own depth.
void TestCoincident(double zNear, double zFar)
{
  const Stage stage(160, 120);
  stage.Renderer->GetActiveCamera()->SetClippingRange(zNear, zFar);
  const auto low = AddActor(stage.Renderer, relievoTest::MakeSquare());
  const auto high = AddActor(stage.Renderer, relievoTest::MakeSquare());
  low->RotateX(-70.);
  high->RotateX(-70.);
  low->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0., 8.);
  high->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(0., -8.);
  const int before = vtkMapper::GetResolveCoincidentTopology();
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  relievoTest::AnalyticScene scene;
  scene.AddPlane(1., 1., Place(high));
  const TruthImage truth = scene.Trace(View(stage.Renderer));
  for (const bool swapped : { false, true })
  {
    if (swapped)
    {
      stage.Renderer->RemoveActor(low);
      stage.Renderer->AddActor(low);
    }
    const Layers layers(stage.Renderer, { "depth", "actor" });
    long long mismatches = 0;
    double depth = 0.;
    for (int y = 0; y < truth.Height; ++y)
    {
      for (int x = 0; x < truth.Width; ++x)
      {
        const PixelTruth& pixel = truth.At(x, y);
        if (pixel.Inner && pixel.Hit)
        {
          mismatches += layers.Id("actor", x, y) != (swapped ? 0 : 1) ? 1 : 0;
          depth =
            std::max(depth, std::abs(layers.Value("depth", x, y) - pixel.Depth) / pixel.Depth);
        }
      }
    }
    const std::string name = "coincident squares, far " + std::to_string(zFar);
    RELIEVO_CHECK(layers.Covered() > 1000);
    RELIEVO_CHECK_AT_MOST(mismatches, 0, name + ": pixels of the square below");
    RELIEVO_CHECK_AT_MOST(depth, 1e-6, name + ": depth");
  }
  vtkMapper::SetResolveCoincidentTopology(before);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersSurfaces)
{
  relievoTest::Session session;
  TestCutOut();
  TestClipping();
  TestCoincident(2., 14.);
  TestCoincident(1e-3, 1e4);
  return session.Result();
}
}
