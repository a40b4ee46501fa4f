// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Draw calls that are easily taken for one another: actors and renderers that share a mapper and
// draw its mesh in different representations, a mesh drawn in pieces, an actor drawn twice in a row
// at different places; and meshes that change between the frame and the read.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkConeSource.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropAssembly.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>
#include <vtkSphereSource.h>

#include <cmath>
#include <iostream>

namespace testLayersDraws
{
namespace
{
using relievoTest::BothWays;
using relievoTest::EmbreeScene;
using relievoTest::Layers;
using relievoTest::PixelTruth;
using relievoTest::Stage;
using relievoTest::TruthImage;
using relievoTest::View;
using relievoTest::Way;

const std::vector<std::string> Names = { "depth", "actor", "cell" };

// The layers against the truth: depth everywhere inside, and the cell away from edges.
void CheckSurface(const std::string& what, const Layers& layers, const TruthImage& truth)
{
  long long seen = 0;
  long long mismatches = 0;
  double worst = 0.;
  for (int y = 0; y < truth.Height; ++y)
  {
    for (int x = 0; x < truth.Width; ++x)
    {
      const PixelTruth& pixel = truth.At(x, y);
      if (!pixel.Inner || !pixel.Hit || pixel.EdgeDistance < 0.1)
      {
        continue;
      }
      ++seen;
      mismatches += layers.Id("cell", x, y) != pixel.Cell;
      worst = std::max(worst, std::abs(layers.Value("depth", x, y) - pixel.Depth) / pixel.Depth);
    }
  }
  std::cout << what << ": " << seen << " pixels, depth off by " << worst << ", " << mismatches
            << " wrong cells\n";
  RELIEVO_CHECK_THAT(seen > 500, what + ": the scene is not in the picture");
  RELIEVO_CHECK_AT_MOST(worst, 1e-7, what + ": relative error of the depth");
  RELIEVO_CHECK_AT_MOST(mismatches, 0, what + ": pixels with the wrong cell");
}

// A ball of quads and triangles, so that primitives and cells count differently.
vtkSmartPointer<vtkPolyData> MakeQuadBall()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.);
  source->SetThetaResolution(14);
  source->SetPhiResolution(11);
  source->LatLongTessellationOn();
  source->GenerateNormalsOff();
  source->Update();
  return source->GetOutput();
}

struct Pair
{
  vtkSmartPointer<vtkActor> Surface;
  vtkSmartPointer<vtkActor> Wires;
};

Pair AddPair(Stage& stage, vtkPolyData* mesh, bool shared, bool wiresFirst)
{
  Pair pair;
  auto add = [&]() { return relievoTest::AddActor(stage.Renderer, mesh); };
  (wiresFirst ? pair.Wires : pair.Surface) = add();
  (wiresFirst ? pair.Surface : pair.Wires) = add();
  pair.Surface->SetPosition(-1., 1., 0.);
  pair.Wires->SetPosition(1.1, 1., 0.);
  pair.Wires->GetProperty()->SetRepresentationToWireframe();
  if (shared)
  {
    pair.Wires->SetMapper(pair.Surface->GetMapper());
  }
  return pair;
}

// Two actors, one mapper: as with a mapper each, and right where the surface is.
void TestSharedMapper()
{
  const auto mesh = MakeQuadBall();
  for (const bool wiresFirst : { false, true })
  {
    for (const Way way : BothWays)
    {
      const std::string what = std::string("shared mapper, ") +
        (wiresFirst ? "wires first, " : "surface first, ") + relievoTest::ToString(way);
      Stage own(400, 300);
      AddPair(own, mesh, false, wiresFirst);
      const Layers expected(own.Renderer, Names, way);
      Stage stage(400, 300);
      const Pair pair = AddPair(stage, mesh, true, wiresFirst);
      EmbreeScene truth;
      truth.AddActor(mesh, pair.Surface->GetMatrix());
      // Both kinds of buffers are built anew in every frame: the second differs from the first.
      for (int frame = 0; frame < 2; ++frame)
      {
        const Layers layers(stage.Renderer, Names, way);
        for (const std::string& name : Names)
        {
          RELIEVO_CHECK_AT_MOST(
            relievoTest::CountDifferent(layers, expected, name), 0, what + ": " + name);
        }
        CheckSurface(what, layers, truth.Trace(View(stage.Renderer)));
      }
    }
  }
}

// Two renderers of a window share a mapper; both are drawn before one is read.
void TestSharedByRenderers()
{
  const auto mesh = MakeQuadBall();
  Stage stage(500, 300);
  auto surface = relievoTest::AddActor(stage.Renderer, mesh);
  surface->SetPosition(0., 1., 0.);
  vtkNew<vtkRenderer> right;
  right->SetActiveCamera(stage.Renderer->GetActiveCamera());
  auto wires = relievoTest::AddActor(right, mesh);
  wires->SetMapper(surface->GetMapper());
  wires->GetProperty()->SetRepresentationToWireframe();
  stage.Renderer->SetViewport(0., 0., 0.5, 1.);
  right->SetViewport(0.5, 0., 1., 1.);
  stage.Window->AddRenderer(right);
  EmbreeScene truth;
  truth.AddActor(mesh, surface->GetMatrix());
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  for (const std::string& name : Names)
  {
    frame->RequestLayer(name);
  }
  for (int i = 0; i < 3; ++i)
  {
    stage.Window->Render();
    vtkNew<vtkImageData> image;
    for (const std::string& name : Names)
    {
      frame->ReadLayer(name, image);
    }
    CheckSurface("mapper shared by renderers", Layers(image), truth.Trace(View(stage.Renderer)));
  }
  vtkRelievoPass::Detach(stage.Renderer);
}

// A mapper that draws its input in pieces: all of them in their places, with their own cells.
void TestPieces()
{
  for (const int pieces : { 2, 5 })
  {
    vtkNew<vtkSphereSource> source;
    source->SetRadius(1.2);
    source->SetCenter(0., 1., 0.);
    source->SetThetaResolution(40);
    source->SetPhiResolution(20);
    EmbreeScene truth;
    for (int i = 0; i < pieces; ++i)
    {
      source->UpdatePiece(i, pieces, 0);
      truth.AddActor(source->GetOutput());
    }
    Stage stage(300, 300);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    mapper->SetNumberOfSubPieces(pieces);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    stage.Renderer->AddActor(actor);
    for (const Way way : BothWays)
    {
      const Layers layers(stage.Renderer, { "depth", "actor", "cell", "Normals" }, way);
      CheckSurface(std::to_string(pieces) + " pieces, " + relievoTest::ToString(way), layers,
        truth.Trace(View(stage.Renderer)));
      RELIEVO_CHECK(layers.CountId("actor", 0) == layers.Covered());
      // For the point array, which differs between pieces: the sphere's own normals.
      double worst = 0.;
      const glm::dvec3 centre(0., 1., 0.);
      const View view(stage.Renderer);
      for (int y = 0; y < layers.Height; ++y)
      {
        for (int x = 0; x < layers.Width; ++x)
        {
          const double depth = layers.Value("depth", x, y);
          if (std::isfinite(depth))
          {
            const glm::dvec3 place = view.PixelRay(x + 0.5, y + 0.5).At(depth);
            worst = std::max(
              worst, relievoTest::AngleDegrees(layers.Vector("Normals", x, y), place - centre));
          }
        }
      }
      RELIEVO_CHECK_AT_MOST(worst, 2., "degrees between the array and the sphere's normal");
    }
  }
}

// An assembly's last part, drawn once more on its own behind it (VTK's propAssembly.py).
void TestDrawnTwice()
{
  vtkNew<vtkConeSource> source;
  source->SetResolution(9);
  source->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(source->GetOutput());
  vtkNew<vtkActor> cone;
  cone->SetMapper(mapper);
  cone->SetPosition(-1., 1., 0.);
  vtkNew<vtkAssembly> inner;
  inner->AddPart(cone);
  inner->SetPosition(2., 0.3, 0.8);
  inner->RotateZ(30.);
  vtkNew<vtkPropAssembly> outer;
  outer->AddPart(inner);
  outer->AddPart(cone);
  Stage stage(400, 300);
  stage.Renderer->AddViewProp(outer);
  vtkNew<vtkMatrix4x4> moved;
  vtkMatrix4x4::Multiply4x4(inner->GetMatrix(), cone->GetMatrix(), moved);
  EmbreeScene truth;
  truth.AddActor(source->GetOutput(), moved);
  truth.AddActor(source->GetOutput(), cone->GetMatrix());
  for (const Way way : BothWays)
  {
    CheckSurface("drawn twice, " + relievoTest::ToString(way), Layers(stage.Renderer, Names, way),
      truth.Trace(View(stage.Renderer)));
  }
}

// The mesh loses cells and points between the frame and the read: the frame's ids and the depths
// that were drawn, no crash, and no values of points that are gone.
void TestChangedMesh()
{
  const auto mesh = MakeQuadBall();
  Stage stage(500, 400);
  relievoTest::AddActor(stage.Renderer, mesh)->SetPosition(0., 1., 0.);
  EmbreeScene truth;
  truth.AddActors(stage.Renderer);
  const TruthImage expected = truth.Trace(View(stage.Renderer));
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  frame->RequestLayer("depth");
  frame->RequestLayer("cell");
  stage.Window->Render();
  const auto square = relievoTest::MakeSquare();
  mesh->SetPoints(square->GetPoints());
  mesh->SetPolys(square->GetPolys());
  vtkNew<vtkImageData> image;
  RELIEVO_CHECK(frame->ReadLayer("cell", image) && frame->ReadLayer("depth", image));
  const Layers layers(image);
  long long mismatches = 0;
  double worst = 0.;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const PixelTruth& pixel = expected.At(x, y);
      if (pixel.Inner && pixel.Hit && pixel.EdgeDistance > 0.1)
      {
        mismatches += layers.Id("cell", x, y) != pixel.Cell;
        worst = std::max(worst, std::abs(layers.Value("depth", x, y) - pixel.Depth) / pixel.Depth);
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "cells of the frame, after the mesh has changed");
  RELIEVO_CHECK_AT_MOST(worst, 1e-3, "depths of the frame, after the mesh has changed");
  vtkRelievoPass::Detach(stage.Renderer);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersDraws)
{
  relievoTest::Session session;
  TestSharedMapper();
  TestSharedByRenderers();
  TestPieces();
  TestDrawnTwice();
  TestChangedMesh();
  return session.Result();
}
}
