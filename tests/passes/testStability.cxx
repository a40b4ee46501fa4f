// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Broken data: NaN and infinite points, triangles without area, normals of length zero or NaN,
// arrays of NaN and infinities. Valid data beside them are drawn as without them, and OpenGL
// reports no error.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRelievoLayerSource.h>
#include <vtkRelievoLayersStage.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace testStability
{
namespace
{
using relievoTest::Layers;
using relievoTest::Way;

const double NaN = std::numeric_limits<double>::quiet_NaN();
const double Infinity = std::numeric_limits<double>::infinity();
const std::vector<std::string> All = { "depth", "normal", "geometric_normal", "position", "cell" };

void AddTriangle(vtkPolyData* mesh, vtkIdType a, vtkIdType b, vtkIdType c)
{
  const vtkIdType ids[3] = { a, b, c };
  mesh->GetPolys()->InsertNextCell(3, ids);
}

// A square of two triangles in z = 0, cells 0 and 1, with points 0 to 3.
vtkSmartPointer<vtkPolyData> MakeSquare(const std::vector<glm::dvec3>& more = {})
{
  std::vector<glm::dvec3> points = { { -1., -1., 0. }, { 1., -1., 0. }, { 1., 1., 0. },
    { -1., 1., 0. } };
  points.insert(points.end(), more.begin(), more.end());
  auto mesh = relievoTest::MakePolygons(points);
  AddTriangle(mesh, 0, 1, 2);
  AddTriangle(mesh, 0, 2, 3);
  return mesh;
}

long CompareWith(const Layers& a, const Layers& whole, const std::string& what)
{
  long seen = 0;
  for (int y = 0; y < whole.Height; ++y)
  {
    for (int x = 0; x < whole.Width; ++x)
    {
      if (whole.Id("cell", x, y) < 0)
      {
        continue;
      }
      ++seen;
      const bool same = a.Value("depth", x, y) == whole.Value("depth", x, y) &&
        a.Id("cell", x, y) == whole.Id("cell", x, y) &&
        a.Vector("normal", x, y) == whole.Vector("normal", x, y) &&
        a.Vector("geometric_normal", x, y) == whole.Vector("geometric_normal", x, y);
      if (!RELIEVO_CHECK_THAT(same, what + ": a pixel of the whole cells differs"))
      {
        return seen;
      }
    }
  }
  return seen;
}

void TestPoints()
{
  relievoTest::Stage stage(120, 90);
  relievoTest::GLCheck gl(stage.Window);
  auto actor = relievoTest::AddActor(stage.Renderer, MakeSquare());
  const Layers whole(stage.Renderer, All, Way::Own);
  stage.Renderer->RemoveActor(actor);
  auto mesh = MakeSquare({ { NaN, 0., 0. }, { 0., Infinity, 0. }, { 0.5, 0.5, -3. } });
  AddTriangle(mesh, 0, 1, 4); // a NaN point
  AddTriangle(mesh, 1, 2, 5); // an infinite one
  AddTriangle(mesh, 0, 0, 2); // one point twice
  AddTriangle(mesh, 1, 1, 1); // no extent at all
  AddTriangle(mesh, 0, 2, 6); // behind
  actor = relievoTest::AddActor(stage.Renderer, mesh);
  // VTK shifts and scales by the bounds, which an infinite point spoils: nothing is drawn then.
  for (const Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, { "depth", "cell" }, way);
    long finite = 0;
    for (int y = 0; y < layers.Height; ++y)
    {
      for (int x = 0; x < layers.Width; ++x)
      {
        const double depth = layers.Value("depth", x, y);
        RELIEVO_CHECK(!std::isnan(depth));
        RELIEVO_CHECK(std::isinf(depth) || layers.Id("cell", x, y) >= 0);
        finite += std::isfinite(depth);
      }
    }
    std::cout << relievoTest::ToString(way) << ": " << finite << " pixels seen\n";
  }
  stage.Renderer->RemoveActor(actor);
  // Without area, yet finite: nothing else may change.
  mesh = MakeSquare({ { 0.5, 0.5, -3. } });
  AddTriangle(mesh, 0, 0, 2);
  AddTriangle(mesh, 1, 1, 1);
  AddTriangle(mesh, 0, 2, 2);
  AddTriangle(mesh, 0, 2, 4);
  relievoTest::AddActor(stage.Renderer, mesh);
  for (const Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, All, way,
      [](vtkRelievoLayersStage* g) { g->SetNormalFormat(vtkRelievoLayersStage::NORMAL_OCT16); });
    const Layers again(stage.Renderer, All, way,
      [](vtkRelievoLayersStage* g) { g->SetNormalFormat(vtkRelievoLayersStage::NORMAL_OCT16); });
    RELIEVO_CHECK(CompareWith(layers, again, "drawn twice") > 500);
    long cells[2] = { 0, 0 };
    for (int y = 0; y < layers.Height; ++y)
    {
      for (int x = 0; x < layers.Width; ++x)
      {
        const int cell = whole.Id("cell", x, y);
        if (cell >= 0)
        {
          ++cells[cell];
          RELIEVO_CHECK(layers.Id("cell", x, y) == cell);
          RELIEVO_CHECK_NEAR(
            layers.Value("depth", x, y), whole.Value("depth", x, y), 1e-6, "depth");
        }
      }
    }
    RELIEVO_CHECK(cells[0] > 200 && cells[1] > 200);
  }
  gl.Poll("points");
}

void TestNormals()
{
  for (const bool zero : { true, false })
  {
    relievoTest::Stage stage(120, 90);
    relievoTest::GLCheck gl(stage.Window);
    auto mesh = MakeSquare();
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(4);
    for (int i = 0; i < 4; ++i)
    {
      const double n = zero ? 0. : NaN;
      normals->SetTuple3(i, n, n, n);
    }
    mesh->GetPointData()->SetNormals(normals);
    relievoTest::AddActor(stage.Renderer, mesh);
    for (const Way way : relievoTest::BothWays)
    {
      const Layers layers(stage.Renderer, All, way);
      long seen = 0;
      for (int y = 0; y < layers.Height; ++y)
      {
        for (int x = 0; x < layers.Width; ++x)
        {
          // No direction: zero, as the page of the layers says; never NaN.
          RELIEVO_CHECK(layers.Vector("normal", x, y) == glm::dvec3(0.));
          if (std::isfinite(layers.Value("depth", x, y)))
          {
            ++seen;
            RELIEVO_CHECK(
              glm::length(layers.Vector("geometric_normal", x, y) - glm::dvec3(0., 0., 1.)) < 1e-4);
          }
        }
      }
      RELIEVO_CHECK(seen > 500);
    }
    gl.Poll("normals");
  }
}

void TestArrays()
{
  relievoTest::Stage stage(120, 90);
  auto mesh = MakeSquare();
  vtkNew<vtkDoubleArray> points;
  points->SetName("atPoints");
  for (double value : { 1., 1., NaN, Infinity })
  {
    points->InsertNextValue(value);
  }
  mesh->GetPointData()->AddArray(points);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("atCells");
  cells->InsertNextValue(Infinity);
  cells->InsertNextValue(1e300);
  mesh->GetCellData()->AddArray(cells);
  relievoTest::AddActor(stage.Renderer, mesh);
  const Layers layers(stage.Renderer, { "cell", "atPoints", "atCells" }, Way::Own);
  long seen = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const int cell = layers.Id("cell", x, y);
      const double value = layers.Value("atCells", x, y);
      RELIEVO_CHECK(cell < 0 ? std::isnan(value) : value == (cell == 0 ? Infinity : 1e300));
      // Inside, every corner has a share: NaN and infinity show.
      RELIEVO_CHECK(!std::isfinite(layers.Value("atPoints", x, y)));
      seen += cell >= 0;
    }
  }
  RELIEVO_CHECK(seen > 500);
}

void TestEmptyMeshes()
{
  relievoTest::Stage stage(60, 40);
  vtkNew<vtkPolyData> nothing;
  relievoTest::AddActor(stage.Renderer, nothing);
  relievoTest::AddActor(stage.Renderer, relievoTest::MakePolygons({ { 0., 0., 0. } }));
  for (const Way way : { Way::Own })
  {
    const Layers layers(stage.Renderer, All, way);
    RELIEVO_CHECK(layers.Id("cell", 30, 20) == -1);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testStability)
{
  relievoTest::Session session;
  TestPoints();
  TestNormals();
  TestArrays();
  TestEmptyMeshes();
  return session.Result();
}
}
