// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The normals of surfaces: mirrored and stretched actors, point, cell and no normals, all
// interpolations, both sides, with and without light; in both ways of making the layers.
#include "AnalyticScene.h"
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>
#include <vtkSphereSource.h>

#include <functional>
#include <iostream>

namespace testLayersNormals
{
namespace
{
using relievoTest::AddActor;
using relievoTest::AngleDegrees;
using relievoTest::Layers;
using relievoTest::PixelTruth;
using relievoTest::Stage;
using relievoTest::TruthImage;
using relievoTest::View;
using relievoTest::Way;

const std::vector<std::string> Names = { "depth", "normal", "geometric_normal" };

void WholeFloats(vtkRelievoLayersStage* gbuffer)
{
  gbuffer->SetNormalFormat(vtkRelievoLayersStage::NORMAL_FLOAT32);
}

struct Placing
{
  const char* Name;
  double Scale[3];
  double Turn[3];
};

const Placing Placings[] = {
  { "as it is", { 1., 1., 1. }, { 0., 0., 0. } },
  { "mirrored", { -1., 1., 1. }, { 20., 30., 40. } },
  { "stretched", { 0.4, 1.5, 0.9 }, { 15., -50., 25. } },
  { "stretched and mirrored", { 0.5, 0.8, -1.6 }, { 15., -50., 25. } },
};

void Place(vtkActor* actor, const Placing& placing)
{
  actor->SetScale(placing.Scale[0], placing.Scale[1], placing.Scale[2]);
  actor->SetOrientation(placing.Turn[0], placing.Turn[1], placing.Turn[2]);
  actor->SetPosition(0.1, 0.4, -0.2);
}

// The normals that the points or the cells carry, or none.
vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* mesh, bool points, bool cells)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SetComputePointNormals(points);
  normals->SetComputeCellNormals(cells);
  normals->SplittingOn();
  normals->SetFeatureAngle(1.);
  normals->Update();
  vtkSmartPointer<vtkPolyData> result = normals->GetOutput();
  if (!points)
  {
    result->GetPointData()->SetNormals(nullptr);
  }
  return result;
}

// Whether the pixel and all around it show one face: where two meet, either may be drawn.
bool IsWithinFace(const TruthImage& truth, int x, int y)
{
  const PixelTruth& pixel = truth.At(x, y);
  bool within = pixel.Inner && pixel.Hit;
  for (int j = std::max(0, y - 1); j <= std::min(truth.Height - 1, y + 1) && within; ++j)
  {
    for (int i = std::max(0, x - 1); i <= std::min(truth.Width - 1, x + 1) && within; ++i)
    {
      within = AngleDegrees(truth.At(i, j).Normal, pixel.Normal) < 1e-3;
    }
  }
  return within;
}

// Flat faces: both normals are the face's, and the depth is the closed form's.
void CheckFaces(const std::string& what, const Layers& layers, const TruthImage& truth,
  double normalLimit = 0.01, double coverageLimit = 0.001)
{
  double depth = 0.;
  double face = 0.;
  double normal = 0.;
  long long inner = 0;
  long long other = 0;
  for (int y = 0; y < truth.Height; ++y)
  {
    for (int x = 0; x < truth.Width; ++x)
    {
      const PixelTruth& pixel = truth.At(x, y);
      const double drawn = layers.Value("depth", x, y);
      other += std::isfinite(drawn) != pixel.Hit ? 1 : 0;
      if (!IsWithinFace(truth, x, y))
      {
        continue;
      }
      ++inner;
      depth = std::max(depth, std::abs(drawn - pixel.Depth) / pixel.Depth);
      face = std::max(face, AngleDegrees(layers.Vector("geometric_normal", x, y), pixel.Normal));
      normal = std::max(normal, AngleDegrees(layers.Vector("normal", x, y), pixel.Normal));
    }
  }
  RELIEVO_CHECK_THAT(inner > 500, what + ": the shape is not in the picture");
  RELIEVO_CHECK_AT_MOST(
    static_cast<double>(other) / (static_cast<double>(truth.Width) * truth.Height), coverageLimit,
    what + ": share of other coverage");
  RELIEVO_CHECK_AT_MOST(depth, 1e-6, what + ": depth");
  RELIEVO_CHECK_AT_MOST(face, 0.1, what + ": geometric normal, degrees");
  RELIEVO_CHECK_AT_MOST(normal, normalLimit, what + ": normal, degrees");
}

struct Look
{
  const char* Name;
  bool PointNormals;
  bool CellNormals;
  double NormalLimit;
  std::function<void(vtkProperty*)> Set;
};

// Normals from derivatives of float positions are as good as the geometric ones; VTK stores cell
// normals in bytes.
const Look Looks[] = {
  { "point normals", true, false, 0.01, [](vtkProperty*) {} },
  { "flat", true, false, 0.1, [](vtkProperty* p) { p->SetInterpolationToFlat(); } },
  { "no normals", false, false, 0.1, [](vtkProperty*) {} },
  { "cell normals", false, true, 0.01, [](vtkProperty*) {} },
  { "PBR", true, false, 0.01, [](vtkProperty* p) { p->SetInterpolationToPBR(); } },
  { "no light", true, false, 0.1, [](vtkProperty* p) { p->LightingOff(); } },
  { "edges shown", true, false, 0.01, [](vtkProperty* p) { p->EdgeVisibilityOn(); } },
};

void TestBoxes()
{
  const auto box = relievoTest::MakeBox(2.2, 1.4, 1.8);
  for (const Look& look : Looks)
  {
    for (const Placing& placing : Placings)
    {
      const Stage stage(160, 120);
      const auto actor =
        AddActor(stage.Renderer, WithNormals(box, look.PointNormals, look.CellNormals));
      Place(actor, placing);
      look.Set(actor->GetProperty());
      const relievoTest::GLCheck gl(stage.Window);
      for (const Way way : relievoTest::BothWays)
      {
        stage.Renderer->GetActiveCamera()->SetParallelProjection(way == Way::Own);
        stage.Renderer->GetActiveCamera()->SetParallelScale(1.8);
        const Layers layers(stage.Renderer, Names, way, WholeFloats);
        relievoTest::AnalyticScene scene;
        scene.AddBox(
          { 1.1, 0.7, 0.9 }, relievoTest::AnalyticScene::ToMatrix(actor->GetMatrix()->GetData()));
        CheckFaces(std::string(look.Name) + ", " + placing.Name + ", " + relievoTest::ToString(way),
          layers, scene.Trace(View(stage.Renderer)), look.NormalLimit,
          // VTK widens faces by half the width of the edges that it shows.
          actor->GetProperty()->GetEdgeVisibility() ? 0.01 : 0.001);
      }
    }
  }
}

// The view with front faces culled: the box from inside.
void TestInside()
{
  const Stage stage(160, 120);
  const auto actor =
    AddActor(stage.Renderer, WithNormals(relievoTest::MakeBox(2.2, 1.4, 1.8), true, false));
  Place(actor, Placings[2]);
  actor->GetProperty()->FrontfaceCullingOn();
  relievoTest::AnalyticScene scene;
  scene.AddBox(
    { 1.1, 0.7, 0.9 }, relievoTest::AnalyticScene::ToMatrix(actor->GetMatrix()->GetData()));
  const View view(stage.Renderer);
  const TruthImage truth =
    relievoTest::TraceView(view, [&](const relievoTest::Ray& ray, double from, double to) {
      const auto first = scene.Cast(ray, from, to);
      return first.Hit ? scene.Cast(ray, first.Depth * (1. + 1e-9), to) : first;
    });
  for (const Way way : relievoTest::BothWays)
  {
    CheckFaces("inside, " + relievoTest::ToString(way),
      Layers(stage.Renderer, Names, way, WholeFloats), truth);
  }
}

// A sheet shows its normal to the eye from either side, whatever side its normals point to.
void TestSheet()
{
  for (const double side : { 1., -1. })
  {
    const Stage stage(160, 120);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-1., -1., 0.);
    plane->SetPoint1(side, -1. + (side < 0 ? 2. : 0.), 0.);
    plane->SetPoint2(side < 0 ? 1. : -1., side < 0 ? -1. : 1., 0.);
    plane->Update();
    const auto actor = AddActor(stage.Renderer, plane->GetOutput());
    actor->SetOrientation(10., 20., 0.);
    relievoTest::AnalyticScene scene;
    scene.AddPlane(1., 1., relievoTest::AnalyticScene::ToMatrix(actor->GetMatrix()->GetData()));
    for (const Way way : relievoTest::BothWays)
    {
      CheckFaces(
        std::string(side < 0 ? "sheet from behind, " : "sheet, ") + relievoTest::ToString(way),
        Layers(stage.Renderer, Names, way, WholeFloats), scene.Trace(View(stage.Renderer)));
    }
  }
}

// Smooth normals: those of the corners, turned by the inverse transpose, mixed by their weights.
void TestSmooth(const Placing& placing, bool open, Way way)
{
  const Stage stage(200, 160);
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.);
  source->SetThetaResolution(24);
  source->SetPhiResolution(16);
  source->SetStartTheta(open ? 180. : 0.);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkPolyData* mesh = source->GetOutput();
  const auto actor = AddActor(stage.Renderer, mesh);
  Place(actor, placing);
  const Layers layers(stage.Renderer, Names, way, WholeFloats);
  relievoTest::EmbreeScene scene;
  scene.AddActors(stage.Renderer);
  const TruthImage truth = scene.Trace(View(stage.Renderer));
  const glm::dmat3 toWorld = glm::transpose(
    glm::inverse(glm::dmat3(relievoTest::AnalyticScene::ToMatrix(actor->GetMatrix()->GetData()))));
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  double worst = 0.;
  long long seen[2] = { 0, 0 };
  for (int y = 0; y < truth.Height; ++y)
  {
    for (int x = 0; x < truth.Width; ++x)
    {
      const PixelTruth& pixel = truth.At(x, y);
      if (!pixel.Inner || !pixel.Hit || pixel.EdgeDistance < 0.01)
      {
        continue;
      }
      const glm::dvec3 weights = scene.Weights(pixel.Triangle, pixel.Position);
      glm::dvec3 normal(0.);
      for (int i = 0; i < 3; ++i)
      {
        glm::dvec3 n;
        normals->GetTuple(scene.PointIds(pixel.Triangle)[i], &n[0]);
        normal += weights[i] * n;
      }
      normal = toWorld * normal;
      const bool outside = glm::dot(normal, pixel.Normal) > 0.;
      ++seen[outside ? 0 : 1];
      worst =
        std::max(worst, AngleDegrees(layers.Vector("normal", x, y), outside ? normal : -normal));
    }
  }
  const std::string what = std::string("smooth ") + (open ? "open " : "") + "sphere, " +
    placing.Name + ", " + relievoTest::ToString(way);
  RELIEVO_CHECK_THAT(seen[0] > 400 && (!open || seen[1] > 100),
    what + ": too little is seen: " + std::to_string(seen[0]) + ", " + std::to_string(seen[1]));
  RELIEVO_CHECK_AT_MOST(worst, 0.02, what + ": normal, degrees");
}

// The eye's axes instead of the world's.
void TestViewSpace()
{
  const Stage stage(100, 80);
  AddActor(stage.Renderer, relievoTest::MakeBox(2.2, 1.4, 1.8));
  const Layers world(stage.Renderer, Names, Way::Own, WholeFloats);
  const Layers view(stage.Renderer, Names, Way::Own, [](vtkRelievoLayersStage* gbuffer) {
    WholeFloats(gbuffer);
    gbuffer->SetNormalSpace(vtkRelievoLayersStage::VIEW);
  });
  vtkMatrix4x4* matrix = stage.Renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  const glm::dmat3 turn(relievoTest::AnalyticScene::ToMatrix(matrix->GetData()));
  double worst = 0.;
  for (int y = 0; y < world.Height; ++y)
  {
    for (int x = 0; x < world.Width; ++x)
    {
      for (const char* name : { "normal", "geometric_normal" })
      {
        worst =
          std::max(worst, glm::length(turn * world.Vector(name, x, y) - view.Vector(name, x, y)));
      }
    }
  }
  RELIEVO_CHECK(world.Covered() > 1000);
  RELIEVO_CHECK_AT_MOST(worst, 1e-5, "view space against world space");
}

// Points far from the origin in the mesh itself, which VTK shifts before it draws.
void TestFarAway()
{
  const glm::dvec3 origin(5e5, 5e6, 0.);
  const Stage stage(160, 120, origin);
  vtkSmartPointer<vtkPolyData> box = WithNormals(relievoTest::MakeBox(2.2, 1.4, 1.8), true, false);
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    box->GetPoint(i, &p[0]);
    p += origin;
    box->GetPoints()->SetPoint(i, &p[0]);
  }
  AddActor(stage.Renderer, box);
  relievoTest::AnalyticScene scene;
  scene.AddBox({ 1.1, 0.7, 0.9 }, glm::translate(glm::dmat4(1.), origin));
  for (const Way way : relievoTest::BothWays)
  {
    CheckFaces("mesh at (5e5, 5e6, 0), " + relievoTest::ToString(way),
      Layers(stage.Renderer, Names, way, WholeFloats), scene.Trace(View(stage.Renderer)));
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersNormals)
{
  relievoTest::Session session;
  TestBoxes();
  TestInside();
  TestSheet();
  for (const Placing& placing : Placings)
  {
    for (const Way way : relievoTest::BothWays)
    {
      TestSmooth(placing, false, way);
      TestSmooth(placing, true, way);
    }
  }
  TestViewSpace();
  TestFarAway();
  return session.Result();
}
}
