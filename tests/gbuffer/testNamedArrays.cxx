// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Point and cell arrays by name: point values are linear over every triangle of any cell, cell
// values are the cell's own, to the last digit; missing values are NaN, errors are reported.
#include "AnalyticScene.h"
#include "Check.h"
#include "EmbreeScene.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoPass.h>
#include <vtkSphereSource.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <limits>

namespace testNamedArrays
{
namespace
{
using relievoTest::Layers;
using relievoTest::PixelTruth;
using relievoTest::Stage;
using relievoTest::TruthImage;
using relievoTest::View;
using relievoTest::Way;

const double Nan = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();

double Linear(const glm::dvec3& p)
{
  return 1. + 2. * p.x - 3. * p.y + 0.5 * p.z;
}

// An integer that a float cannot hold.
long long Whole(vtkIdType i)
{
  return (1LL << 45) + 3 * i;
}

template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, vtkIdType tuples, int components = 1)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

void AddArrays(vtkPolyData* mesh)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  const vtkIdType cells = mesh->GetNumberOfCells();
  const auto linear = NewArray<vtkDoubleArray>("linear", points);
  const auto both = NewArray<vtkDoubleArray>("both", points);
  const auto depth = NewArray<vtkDoubleArray>("depth", points);
  const auto place = NewArray<vtkFloatArray>("place", points, 3);
  for (vtkIdType i = 0; i < points; ++i)
  {
    glm::dvec3 p;
    mesh->GetPoint(i, &p[0]);
    linear->SetValue(i, Linear(p));
    both->SetValue(i, Linear(p));
    depth->SetValue(i, 100. + Linear(p));
    place->SetTuple(i, &p[0]);
  }
  const auto whole = NewArray<vtkTypeInt64Array>("whole", cells);
  const auto bothCells = NewArray<vtkDoubleArray>("both", cells);
  const auto byte = NewArray<vtkUnsignedCharArray>("byte", cells);
  const auto holes = NewArray<vtkDoubleArray>("holes", cells);
  const auto wide = NewArray<vtkDoubleArray>("16 wide", cells, 16);
  const auto wider = NewArray<vtkDoubleArray>("17 wide", cells, 17);
  for (vtkIdType i = 0; i < cells; ++i)
  {
    whole->SetValue(i, Whole(i));
    bothCells->SetValue(i, 1e100 + 1e90 * static_cast<double>(i));
    byte->SetValue(i, static_cast<unsigned char>(i % 256));
    holes->SetValue(i, i % 3 == 0 ? Nan : i % 3 == 1 ? -Infinity : static_cast<double>(i));
    for (int c = 0; c < 17; ++c)
    {
      wider->SetComponent(i, c, 0.);
      wide->SetComponent(i, c % 16, 1000. * (c % 16) + static_cast<double>(i));
    }
  }
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(linear), static_cast<vtkDataArray*>(both),
         static_cast<vtkDataArray*>(depth), static_cast<vtkDataArray*>(place) })
  {
    mesh->GetPointData()->AddArray(array);
  }
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(whole), static_cast<vtkDataArray*>(bothCells),
      static_cast<vtkDataArray*>(byte), static_cast<vtkDataArray*>(holes),
      static_cast<vtkDataArray*>(wide), static_cast<vtkDataArray*>(wider) })
  {
    mesh->GetCellData()->AddArray(array);
  }
}

// Triangles, a quad with a triangle of no area, a bent polygon, a strip.
vtkSmartPointer<vtkPolyData> MakeMesh()
{
  auto mesh = relievoTest::MakePolygons({ { -1.8, 0., 0. }, { -0.9, 0.1, 0.4 }, { -1.5, 1.2, -0.2 },
    { -0.8, 0., 0. }, { -0.8, 0., 0. }, { 0.1, 0., 0.3 }, { -0.2, 1.1, 0. }, { 0.2, 0., -0.2 },
    { 0.6, 0.4, 0.2 }, { 1., 0.1, 0.2 }, { 0.9, 1.2, 0. }, { 0.2, 1., 0.3 }, { 1.1, 0., 0. },
    { 1.6, 0.2, 0.3 }, { 1.1, 0.6, 0. }, { 1.7, 0.8, 0.2 }, { 1.2, 1.3, 0.1 } });
  mesh->SetStrips(vtkNew<vtkCellArray>());
  mesh->GetPolys()->InsertNextCell({ 0, 1, 2 });
  mesh->GetPolys()->InsertNextCell({ 3, 4, 5, 6 });
  mesh->GetPolys()->InsertNextCell({ 8, 9, 10, 11, 7 });
  mesh->GetStrips()->InsertNextCell({ 12, 13, 14, 15, 16 });
  return mesh;
}

// A ball of triangles smaller than pixels, and before them many cells of another kind, which draw
// nothing.
vtkSmartPointer<vtkPolyData> MakeLoadedBall()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.);
  source->SetThetaResolution(160);
  source->SetPhiResolution(160);
  source->Update();
  vtkNew<vtkCellArray> lines;
  for (int i = 0; i < 1000000; ++i)
  {
    lines->InsertNextCell({ 0, 0 });
  }
  source->GetOutput()->SetLines(lines);
  return source->GetOutput();
}

// NaN equals NaN.
bool Same(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

// Actor 0 carries the arrays, actor 1 has none of them.
void CheckValues(
  const std::string& what, vtkPolyData* mesh, const glm::dvec3& offset, bool parallel)
{
  const Stage stage(240, 160, offset);
  stage.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
  stage.Renderer->GetActiveCamera()->SetParallelScale(1.6);
  AddArrays(mesh);
  const auto actor = relievoTest::AddActor(stage.Renderer, mesh);
  actor->SetPosition(offset.x, offset.y + 0.1, offset.z);
  actor->SetScale(0.9, -1.1, 1.2);
  actor->RotateX(170.);
  const auto bare = relievoTest::AddActor(stage.Renderer, relievoTest::MakeBox(3., 0.1, 2.));
  bare->SetPosition(offset.x, offset.y - 0.9, offset.z);
  relievoTest::EmbreeScene scene;
  scene.AddActors(stage.Renderer);
  const TruthImage truth = scene.Trace(View(stage.Renderer));
  const glm::dmat4 toModel =
    glm::inverse(relievoTest::AnalyticScene::ToMatrix(actor->GetMatrix()->GetData()));
  const std::vector<std::string> names = { "linear", "both", "point:both", "cell:both", "depth",
    "point:depth", "place", "whole", "byte", "holes", "16 wide" };
  const relievoTest::GLCheck gl(stage.Window);
  for (const Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, names, way);
    long long seen[2] = { 0, 0 };
    double linear = 0.;
    double place = 0.;
    double depth = 0.;
    long long mismatches = 0;
    long long present = 0;
    for (int y = 0; y < truth.Height; ++y)
    {
      for (int x = 0; x < truth.Width; ++x)
      {
        const PixelTruth& pixel = truth.At(x, y);
        if (!pixel.Inner || (pixel.Hit && pixel.EdgeDistance < 0.01))
        {
          continue;
        }
        if (pixel.Actor != 0)
        {
          seen[1] += pixel.Hit ? 1 : 0;
          for (const std::string& name : names)
          {
            present += name == "depth" || std::isnan(layers.Value(name, x, y)) ? 0 : 1;
          }
          continue;
        }
        ++seen[0];
        const glm::dvec3 p(toModel * glm::dvec4(pixel.Position, 1.));
        for (const char* name : { "linear", "both", "point:both" })
        {
          linear = std::max(linear, std::abs(layers.Value(name, x, y) - Linear(p)));
        }
        linear = std::max(linear, std::abs(layers.Value("point:depth", x, y) - 100. - Linear(p)));
        depth = std::max(depth, std::abs(layers.Value("depth", x, y) - pixel.Depth) / pixel.Depth);
        place = std::max(place, glm::length(layers.Vector("place", x, y) - p));
        const double cell = static_cast<double>(pixel.Cell);
        const double hole = pixel.Cell % 3 == 0 ? Nan : pixel.Cell % 3 == 1 ? -Infinity : cell;
        bool same = layers.Value("whole", x, y) == static_cast<double>(Whole(pixel.Cell)) &&
          layers.Value("cell:both", x, y) == 1e100 + 1e90 * cell &&
          layers.Value("byte", x, y) == std::fmod(cell, 256.) &&
          Same(layers.Value("holes", x, y), hole);
        for (int c = 0; c < 16; ++c)
        {
          same = same && layers.Value("16 wide", x, y, c) == 1000. * c + cell;
        }
        mismatches += same ? 0 : 1;
      }
    }
    const std::string name = what + ", " + relievoTest::ToString(way);
    // At 5e6 a double has 9 digits left behind the point, and the ray passes through there.
    const double slack = glm::length(offset) > 0. ? 2e-7 : 0.;
    RELIEVO_CHECK_THAT(seen[0] > 800 && seen[1] > 800, name + ": too little is seen");
    RELIEVO_CHECK_AT_MOST(linear, 1e-9 + slack, name + ": linear values");
    RELIEVO_CHECK_AT_MOST(place, 1e-6 + slack, name + ": vectors in float");
    RELIEVO_CHECK_AT_MOST(depth, 1e-6, name + ": the layer depth beside an array of that name");
    RELIEVO_CHECK_AT_MOST(mismatches, 0, name + ": pixels with other cell values");
    RELIEVO_CHECK_AT_MOST(present, 0, name + ": values where the array is missing");
    vtkPointData* data = layers.Image->GetPointData();
    for (const char* kept : { "linear", "whole", "cell:both", "holes" })
    {
      RELIEVO_CHECK(data->GetArray(kept)->GetDataType() == VTK_DOUBLE);
    }
    for (const char* single : { "place", "byte", "depth" })
    {
      RELIEVO_CHECK(data->GetArray(single)->GetDataType() == VTK_FLOAT);
    }
  }
}

// A value that is no number spoils the triangles at its point, and no others.
void TestBadPointValues()
{
  const Stage stage(200, 160);
  const auto square = relievoTest::MakeSquare();
  const auto values = NewArray<vtkDoubleArray>("values", 4);
  values->Fill(2.);
  values->SetValue(1, Nan);
  const auto infinite = NewArray<vtkDoubleArray>("infinite", 4);
  infinite->Fill(2.);
  infinite->SetValue(1, Infinity);
  square->GetPointData()->AddArray(values);
  square->GetPointData()->AddArray(infinite);
  relievoTest::AddActor(stage.Renderer, square);
  relievoTest::EmbreeScene scene;
  scene.AddActors(stage.Renderer);
  const TruthImage truth = scene.Trace(View(stage.Renderer));
  const Layers layers(stage.Renderer, { "values", "infinite" });
  long long mismatches = 0;
  long long spoiled[2] = { 0, 0 };
  for (int y = 0; y < truth.Height; ++y)
  {
    for (int x = 0; x < truth.Width; ++x)
    {
      const PixelTruth& pixel = truth.At(x, y);
      if (!pixel.Inner || !pixel.Hit || pixel.EdgeDistance < 0.1)
      {
        continue;
      }
      const auto corners = scene.PointIds(pixel.Triangle);
      const bool bad = corners[0] == 1 || corners[1] == 1 || corners[2] == 1;
      ++spoiled[bad ? 1 : 0];
      mismatches += Same(layers.Value("values", x, y), bad ? Nan : 2.) ? 0 : 1;
      mismatches += bad == std::isinf(layers.Value("infinite", x, y)) ? 0 : 1;
    }
  }
  RELIEVO_CHECK(spoiled[0] > 500 && spoiled[1] > 500);
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "pixels of triangles with a NaN or an infinity");
}

// Asks for a layer that cannot be; returns the messages.
std::vector<std::string> Refuse(vtkRenderer* renderer, const std::string& name)
{
  const relievoTest::ExpectMessage expected("'" + name + "'");
  vtkNew<vtkRelievoLayerSource> source;
  source->SetRenderer(renderer);
  source->AddLayer("depth");
  source->AddLayer(name);
  {
    // VTK's pipeline tells that the source failed, too.
    const relievoTest::ExpectMessage pipeline("Algorithm vtkRelievoLayerSource");
    source->Update();
  }
  RELIEVO_CHECK_THAT(source->GetOutput()->GetNumberOfPoints() == 0,
    "a half-made image came out beside the error about " + name);
  RELIEVO_CHECK(!vtkRelievoPass::Detach(renderer));
  return expected.Messages();
}

// Props that fade out or are hidden still have their arrays: without values anywhere.
void TestHidden()
{
  const Stage stage(60, 40);
  const auto mesh = relievoTest::MakeBall(0.5);
  AddArrays(mesh);
  const auto hidden = relievoTest::AddActor(stage.Renderer, mesh);
  relievoTest::AddActor(stage.Renderer, relievoTest::MakeSquare());
  stage.Renderer->ResetCamera();
  const auto count = [&stage] {
    const Layers layers(stage.Renderer, { "linear" });
    int values = 0;
    for (int i = 0; i < layers.Width * layers.Height; ++i)
    {
      values += std::isnan(layers.Value("linear", i % layers.Width, i / layers.Width)) ? 0 : 1;
    }
    return values;
  };
  RELIEVO_CHECK(count() > 100);
  hidden->GetProperty()->SetOpacity(0.5);
  RELIEVO_CHECK(count() == 0);
  hidden->VisibilityOff();
  RELIEVO_CHECK(count() == 0);
}

void TestErrors()
{
  const Stage stage(60, 40);
  const auto mesh = MakeMesh();
  AddArrays(mesh);
  // Fewer values than points: no array of this mesh.
  const auto broken = NewArray<vtkDoubleArray>("too short", 3);
  broken->Fill(1.);
  mesh->GetPointData()->AddArray(broken);
  relievoTest::AddActor(stage.Renderer, mesh);
  for (const char* name : { "detph", "point:whole", "cell:linear", "17 wide", "too short" })
  {
    const std::vector<std::string> messages = Refuse(stage.Renderer, name);
    if (!RELIEVO_CHECK_THAT(messages.size() == 1, std::string("not one message about ") + name))
    {
      continue;
    }
    const bool tooWide = std::string(name) == "17 wide";
    for (const char* word : { "depth", "range", "normal", "geometric_normal", "position", "albedo",
           "actor", "block", "cell" })
    {
      RELIEVO_CHECK_THAT(tooWide || messages[0].find(word) != std::string::npos,
        messages[0] + " does not name the layer " + word);
    }
    RELIEVO_CHECK_THAT(!tooWide || messages[0].find("16") != std::string::npos,
      messages[0] + " does not name the limit");
  }
  // After all that, a good name works.
  const Layers layers(stage.Renderer, { "linear" });
  RELIEVO_CHECK(layers.Width == 60);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testNamedArrays)
{
  relievoTest::Session session;
  CheckValues("ball", relievoTest::MakeBall(1.), {}, false);
  CheckValues("ball, parallel", relievoTest::MakeBall(1.), {}, true);
  CheckValues("ball at (5e5, 5e6, 0)", relievoTest::MakeBall(1.), { 5e5, 5e6, 0. }, false);
  CheckValues("ball behind many lines", MakeLoadedBall(), {}, false);
  CheckValues("polygons and a strip", MakeMesh(), {}, false);
  CheckValues("box", relievoTest::MakeBox(2., 1.2, 1.), {}, false);
  TestBadPointValues();
  TestHidden();
  TestErrors();
  return session.Result();
}
}
