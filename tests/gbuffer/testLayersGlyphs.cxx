// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Glyphs: which input point is seen, with masks, several sources and composite input; depth and
// normals of stretched, turned and mirrored glyphs; arrays of the input's points.
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkBitArray.h>
#include <vtkCamera.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkIntArray.h>
#include <vtkMatrix4x4.h>
#include <vtkMinimalStandardRandomSequence.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoLayersStage.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>

namespace testLayersGlyphs
{
namespace
{
using relievoTest::AngleDegrees;
using relievoTest::EmbreeScene;
using relievoTest::Layers;
using relievoTest::PixelTruth;
using relievoTest::Stage;
using relievoTest::TruthImage;
using relievoTest::View;
using relievoTest::Way;

const std::vector<std::string> Names = { "depth", "geometric_normal", "normal", "actor", "block",
  "cell", "weight" };

// The expected values where the truth's actor of this number is visible.
struct Glyph
{
  int Block;
  int Point;
};

struct Scene
{
  EmbreeScene Truth;
  std::vector<Glyph> Glyphs;

  void Add(vtkPolyData* source, vtkPolyData* input, int point, int block, const double scale[3],
    vtkActor* actor)
  {
    vtkNew<vtkTransform> place;
    place->SetMatrix(actor->GetMatrix());
    place->Translate(input->GetPoint(point));
    place->Scale(scale);
    this->Truth.AddActor(source, place->GetMatrix());
    this->Glyphs.push_back({ block, point });
  }
};

// A 5 x 3 grid with arrays: mask, which source, weight, scales.
vtkSmartPointer<vtkPolyData> MakeInput(double y, bool mirrored = false)
{
  auto input = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkBitArray> mask;
  vtkNew<vtkIntArray> source;
  vtkNew<vtkDoubleArray> weight;
  vtkNew<vtkFloatArray> scale;
  mask->SetName("mask");
  source->SetName("source");
  weight->SetName("weight");
  scale->SetName("scale");
  scale->SetNumberOfComponents(3);
  for (int i = 0; i < 15; ++i)
  {
    points->InsertNextPoint(0.7 * (i % 5) - 1.4, y, 0.7 * (i / 5) - 0.7);
    mask->InsertNextValue(i % 4 != 1);
    source->InsertNextValue(i % 3 == 0);
    weight->InsertNextValue(0.1 + 1e9 * i);
    scale->InsertNextTuple3(
      mirrored && i % 2 ? -0.2 : 0.3, 0.1 + 0.02 * i, mirrored && i % 3 ? -0.15 : 0.25);
  }
  input->SetPoints(points);
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(mask), static_cast<vtkDataArray*>(source),
         static_cast<vtkDataArray*>(weight), static_cast<vtkDataArray*>(scale) })
  {
    input->GetPointData()->AddArray(array);
  }
  return input;
}

double Weight(int point)
{
  return 0.1 + 1e9 * point;
}

void CheckGlyphs(const std::string& what, const Stage& stage, const Scene& scene, bool flat)
{
  const TruthImage truth = scene.Truth.Trace(View(stage.Renderer));
  for (const Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, Names, way);
    long long seen = 0;
    long long mismatches[4] = { 0, 0, 0, 0 };
    double depth = 0.;
    double angle[2] = { 0., 0. };
    for (int y = 0; y < truth.Height; ++y)
    {
      for (int x = 0; x < truth.Width; ++x)
      {
        const PixelTruth& pixel = truth.At(x, y);
        if (!pixel.Inner || (pixel.Hit && pixel.EdgeDistance < 0.1))
        {
          continue;
        }
        const Glyph glyph = pixel.Hit ? scene.Glyphs[pixel.Actor] : Glyph{ -1, -1 };
        mismatches[0] += layers.Id("actor", x, y) != (pixel.Hit ? 0 : -1) ? 1 : 0;
        mismatches[1] += layers.Id("block", x, y) != glyph.Block ? 1 : 0;
        mismatches[2] += layers.Id("cell", x, y) != glyph.Point ? 1 : 0;
        const double weight = layers.Value("weight", x, y);
        mismatches[3] += (pixel.Hit ? weight != Weight(glyph.Point) : !std::isnan(weight)) ? 1 : 0;
        if (!pixel.Hit)
        {
          continue;
        }
        ++seen;
        depth = std::max(depth, std::abs(layers.Value("depth", x, y) - pixel.Depth) / pixel.Depth);
        angle[0] =
          std::max(angle[0], AngleDegrees(layers.Vector("geometric_normal", x, y), pixel.Normal));
        angle[1] = std::max(angle[1], AngleDegrees(layers.Vector("normal", x, y), pixel.Normal));
      }
    }
    const std::string name = what + ", " + relievoTest::ToString(way);
    RELIEVO_CHECK_THAT(seen > 1000, name + ": too little is seen");
    // Glyphs have no meshes to refine the depth from.
    RELIEVO_CHECK_AT_MOST(depth, 2e-5, name + ": depth");
    RELIEVO_CHECK_AT_MOST(angle[0], 0.1, name + ": geometric normal, degrees");
    // The normals of a ball are up to half its facets' angles off its facets.
    RELIEVO_CHECK_AT_MOST(angle[1], flat ? 0.1 : 60., name + ": normal, degrees");
    RELIEVO_CHECK_AT_MOST(mismatches[0], 0, name + ": pixels with another actor");
    RELIEVO_CHECK_AT_MOST(mismatches[1], 0, name + ": pixels with another block");
    RELIEVO_CHECK_AT_MOST(mismatches[2], 0, name + ": pixels with another point");
    RELIEVO_CHECK_AT_MOST(mismatches[3], 0, name + ": pixels with another weight");
  }
}

void TestScales(bool mirrored, bool lit)
{
  const Stage stage(240, 160);
  const relievoTest::GLCheck gl(stage.Window);
  const auto box = relievoTest::MakeBox(1., 1., 1.);
  const auto input = MakeInput(0.3, mirrored);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(input);
  mapper->SetSourceData(box);
  mapper->SetScaleArray("scale");
  mapper->SetScaleModeToScaleByVectorComponents();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetScale(1.1, 1.6, 0.9);
  actor->RotateY(20.);
  actor->GetProperty()->SetLighting(lit);
  stage.Renderer->AddActor(actor);
  Scene scene;
  for (int i = 0; i < 15; ++i)
  {
    scene.Add(box, input, i, 0, input->GetPointData()->GetArray("scale")->GetTuple3(i), actor);
  }
  CheckGlyphs(
    std::string(mirrored ? "mirrored" : "stretched") + (lit ? " glyphs" : " unlit glyphs"), stage,
    scene, true);
}

void TestMaskAndSources()
{
  const Stage stage(240, 160);
  const auto box = relievoTest::MakeBox(1., 1., 1.);
  const auto ball = relievoTest::MakeBall(0.5);
  const auto input = MakeInput(0.3);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(input);
  mapper->SetSourceData(0, box);
  mapper->SetSourceData(1, ball);
  mapper->MaskingOn();
  mapper->SetMaskArray("mask");
  mapper->SourceIndexingOn();
  mapper->SetSourceIndexArray("source");
  mapper->SetScaleFactor(0.4);
  mapper->SetScaleModeToNoDataScaling();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  const double scale[3] = { 0.4, 0.4, 0.4 };
  Scene scene;
  for (int i = 0; i < 15; ++i)
  {
    if (i % 4 != 1)
    {
      scene.Add(i % 3 == 0 ? ball : box, input, i, 0, scale, actor);
    }
  }
  CheckGlyphs("masked glyphs of two sources", stage, scene, false);
}

// Two visible blocks and a hidden one before them, another actor before all.
void TestComposite()
{
  const Stage stage(240, 160);
  const auto box = relievoTest::MakeBox(1., 1., 1.);
  const auto low = MakeInput(0.1);
  const auto high = MakeInput(1.);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, nullptr);
  inner->SetBlock(1, high);
  vtkNew<vtkMultiBlockDataSet> root;
  root->SetBlock(0, MakeInput(0.5));
  root->SetBlock(1, low);
  root->SetBlock(2, inner);
  // Flat indices: root 0, hidden 1, low 2, inner 3, nothing 4, high 5.
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputDataObject(root);
  mapper->SetSourceData(box);
  mapper->SetScaleFactor(0.3);
  mapper->SetScaleModeToNoDataScaling();
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  attributes->SetBlockVisibility(root->GetBlock(0), false);
  mapper->SetBlockAttributes(attributes);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  const double scale[3] = { 0.3, 0.3, 0.3 };
  Scene scene;
  for (int i = 0; i < 15; ++i)
  {
    scene.Add(box, low, i, 2, scale, actor);
    scene.Add(box, high, i, 5, scale, actor);
  }
  CheckGlyphs("glyphs of blocks", stage, scene, true);
}

// 25 000 balls of about a pixel: no pixel's depth leaves the ball that it names, though
// the triangles are narrower than the rasteriser's grid.
void TestSmall()
{
  const Stage stage(800, 600);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(5);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 25000; ++i)
  {
    double p[3];
    for (double& x : p)
    {
      x = random->GetNextRangeValue(-250., 250.);
    }
    points->InsertNextPoint(p);
  }
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.3);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(input);
  mapper->SetSourceConnection(ball->GetOutputPort());
  mapper->ScalingOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0., 0., 0.);
  for (const double distance : { 600., 850. })
  {
    camera->SetPosition(0.5 * distance, 0.2 * distance, distance);
    stage.Renderer->ResetCameraClippingRange();
    const View view(stage.Renderer);
    const Layers layers(stage.Renderer, { "depth", "cell" });
    double worst = 0.;
    for (int y = 0; y < layers.Height; ++y)
    {
      for (int x = 0; x < layers.Width; ++x)
      {
        const int id = layers.Id("cell", x, y);
        if (id >= 0)
        {
          glm::dvec3 centre;
          points->GetPoint(id, &centre[0]);
          worst = std::max(worst, std::abs(layers.Value("depth", x, y) - view.Depth(centre)));
        }
      }
    }
    RELIEVO_CHECK_THAT(layers.Covered() > 5000, "the balls are not in the picture");
    // At a depth of 1000, half a float's step is 3e-5.
    RELIEVO_CHECK_AT_MOST(worst, 0.303, "depth, from the centre of the ball of radius 0.3");
    const Layers alone(stage.Renderer, { "depth" }, Way::Own, [](auto* g) { g->RefineDepthOff(); });
    RELIEVO_CHECK(relievoTest::CountDifferent(alone, layers, "depth") == 0);
  }
}

// Culling hands instances out in an order of its own: the point is not known, and said not to be.
void TestCulling()
{
  const Stage stage(120, 80);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(MakeInput(0.3));
  mapper->SetSourceData(relievoTest::MakeBox(1., 1., 1.));
  mapper->SetScaleFactor(0.4);
  mapper->SetScaleModeToNoDataScaling();
  mapper->SetCullingAndLOD(true);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  const Layers layers(stage.Renderer, { "depth", "actor", "cell" });
  RELIEVO_CHECK(layers.Covered() > 500 && layers.CountId("actor", 0) == layers.Covered());
  RELIEVO_CHECK(layers.CountId("cell", -1) == 120 * 80);
}

// Every block is a draw of its own: as many words as the points of all blocks for each of them
// would be more than there are.
void TestManyBlocks()
{
  constexpr int Columns = 100;
  constexpr int Rows = 60;
  const Stage stage(400, 240);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0.5 * Columns, 0.5 * Rows, 100.);
  camera->SetFocalPoint(0.5 * Columns, 0.5 * Rows, 0.);
  camera->SetViewUp(0., 1., 0.);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * Rows);
  camera->SetClippingRange(90., 110.);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int i = 0; i < Rows * Columns; ++i)
  {
    const std::vector<glm::dvec3> places(
      120, glm::dvec3(i % Columns + 0.5, static_cast<int>(i / Columns) + 0.5, 0.));
    blocks->SetBlock(i, relievoTest::MakePolygons(places));
  }
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SetSourceData(relievoTest::MakeSquare());
  mapper->SetScaleModeToNoDataScaling();
  mapper->SetScaleFactor(0.45);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  const Layers layers(stage.Renderer, { "actor", "block" });
  int mismatches = 0;
  for (int i = 0; i < Rows * Columns; ++i)
  {
    const int x = 4 * (i % Columns) + 2;
    const int y = 4 * (i / Columns) + 2;
    mismatches += layers.Id("actor", x, y) == 0 && layers.Id("block", x, y) == i + 1 ? 0 : 1;
  }
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "6000 blocks of glyphs: those that are taken for another");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersGlyphs)
{
  relievoTest::Session session;
  TestScales(false, true);
  TestScales(true, true);
  TestScales(true, false);
  TestMaskAndSources();
  TestComposite();
  TestSmall();
  TestCulling();
  TestManyBlocks();
  return session.Result();
}
}
