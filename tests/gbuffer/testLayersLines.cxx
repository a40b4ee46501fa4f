// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Points and lines, thin and wide, on their own and as a surface's wireframe or points: every pixel
// is near the primitive that it names, at that place's depth and with that place's value.
#include "Check.h"
#include "GLCheck.h"
#include "Layers.h"
#include "Props.h"
#include "Session.h"
#include "Stage.h"
#include "TestCase.h"
#include "View.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoPass.h>

#include <algorithm>

namespace testLayersLines
{
namespace
{
using relievoTest::Layers;
using relievoTest::Stage;
using relievoTest::View;

// A point (A is B) or a line, in the world.
struct Primitive
{
  vtkIdType Cell;
  glm::dvec3 A;
  glm::dvec3 B;
};

double Value(const glm::dvec3& p)
{
  return 1. + 2. * p.x - 3. * p.y + 0.5 * p.z;
}

// Three single points and a cell of two, a line of three pieces and a single one, and surfaces: a
// triangle, a quad of which the first triangle has no area, a bent polygon, a strip.
vtkSmartPointer<vtkPolyData> MakeMesh(bool withSurfaces, bool withLines)
{
  auto mesh = relievoTest::MakePolygons({ { -1.9, 0.1, 0. }, { -1.6, 0.5, 0.3 }, { -1.9, 1., 0. },
    { -1.5, 1.3, -0.2 }, { -1.6, 0.1, 0.9 }, { -1.2, 0., 0.6 }, { -1., 1., 0. }, { -0.9, 0.2, 0.2 },
    { -0.6, 1.3, 0.3 }, { -1.2, 1.4, 0. }, { -0.7, 1.6, -0.4 }, { -0.4, 0., 0. }, { 0.2, 0.1, 0.3 },
    { -0.2, 0.7, -0.2 }, { 0.4, 0., 0. }, { 0.4, 0., 0. }, { 1., 0., 0.2 }, { 0.9, 0.6, 0. },
    { 0.1, 0.9, 0. }, { 0.8, 0.9, 0.1 }, { 0.7, 1.2, 0.1 }, { 0.9, 1.6, 0. }, { 0.1, 1.5, 0.2 },
    { 1.2, 0., 0. }, { 1.5, 0.2, 0.2 }, { 1.2, 0.6, 0. }, { 1.6, 0.8, 0.1 }, { 1.3, 1.2, 0.2 } });
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> strips;
  verts->InsertNextCell({ 0 });
  verts->InsertNextCell({ 1 });
  verts->InsertNextCell({ 2, 3 });
  verts->InsertNextCell({ 4 });
  lines->InsertNextCell({ 5, 6, 7, 8 });
  lines->InsertNextCell({ 9, 10 });
  strips->InsertNextCell({ 23, 24, 25, 26, 27 });
  if (withSurfaces)
  {
    mesh->GetPolys()->InsertNextCell({ 11, 12, 13 });
    mesh->GetPolys()->InsertNextCell({ 14, 15, 16, 17 });
    mesh->GetPolys()->InsertNextCell({ 18, 19, 20, 21, 22 });
    mesh->SetStrips(strips);
  }
  if (withLines)
  {
    mesh->SetVerts(verts);
    mesh->SetLines(lines);
  }
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    mesh->GetPoint(i, &p[0]);
    values->InsertNextValue(Value(p));
  }
  mesh->GetPointData()->AddArray(values);
  return mesh;
}

// The primitives drawn for the mesh's cells.
std::vector<Primitive> MakePrimitives(vtkPolyData* mesh, int representation)
{
  std::vector<Primitive> primitives;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    const vtkIdType count = ids->GetNumberOfIds();
    auto add = [&](vtkIdType a, vtkIdType b) {
      Primitive p{ cell, {}, {} };
      mesh->GetPoint(ids->GetId(a % count), &p.A[0]);
      mesh->GetPoint(ids->GetId(b % count), &p.B[0]);
      // An edge without length draws nothing, a point upon another is hidden.
      const bool hidden = !primitives.empty() && a == b && primitives.back().A == p.A;
      if (!hidden && (a == b || p.A != p.B))
      {
        primitives.push_back(p);
      }
    };
    const int type = mesh->GetCellType(cell);
    const bool points =
      representation == VTK_POINTS || type == VTK_VERTEX || type == VTK_POLY_VERTEX;
    const bool open = type == VTK_LINE || type == VTK_POLY_LINE || type == VTK_TRIANGLE_STRIP;
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (points)
      {
        add(i, i);
      }
      else if (i + 1 < count || !open)
      {
        add(i, i + 1);
      }
      if (!points && type == VTK_TRIANGLE_STRIP && i + 2 < count)
      {
        add(i, i + 2);
      }
    }
  }
  return primitives;
}

// How far the pixel is from a primitive as drawn, and the place there.
double GetDistance(const View& view, const Primitive& p, const glm::dvec2& pixel, glm::dvec3& place)
{
  glm::dvec2 a(0.);
  glm::dvec2 b(0.);
  RELIEVO_CHECK(view.Project(p.A, a) && view.Project(p.B, b));
  const glm::dvec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t =
    length2 > 0. ? std::min(1., std::max(0., glm::dot(pixel - a, along) / length2)) : 0.;
  // From the share of the way on the screen to that in space.
  const double s = t * view.Depth(p.A) / (t * view.Depth(p.A) + (1. - t) * view.Depth(p.B));
  place = p.A + s * (p.B - p.A);
  return glm::length(a + t * along - pixel);
}

// Reach: how far, in pixels, a primitive's pixels may be from it.
void CheckPrimitives(const std::string& what, const Stage& stage,
  const std::vector<Primitive>& primitives, double pointReach, double lineReach)
{
  const View view(stage.Renderer);
  for (const relievoTest::Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, { "depth", "normal", "actor", "cell", "value" }, way);
    std::vector<long long> seen(primitives.size(), 0);
    long long far = 0;
    double depth = 0.;
    double value = 0.;
    long long mismatches = 0;
    for (int y = 0; y < layers.Height; ++y)
    {
      for (int x = 0; x < layers.Width; ++x)
      {
        const int cell = layers.Id("cell", x, y);
        const double drawn = layers.Value("depth", x, y);
        const glm::dvec3 normal = layers.Vector("normal", x, y);
        const double length = glm::length(normal);
        mismatches +=
          (cell >= 0) != std::isfinite(drawn) || layers.Id("actor", x, y) != (cell < 0 ? -1 : 0)
          ? 1
          : 0;
        // A line has no normal, unless it is lit.
        mismatches += length == 0. || std::abs(length - 1.) < 1e-3 ? 0 : 1;
        if (cell < 0)
        {
          continue;
        }
        // Pixels at a joint may show either line.
        bool near = false;
        double depthOff = 1e9;
        double valueOff = 1e9;
        for (std::size_t i = 0; i < primitives.size(); ++i)
        {
          const Primitive& p = primitives[i];
          const bool point = p.A == p.B;
          glm::dvec3 place;
          if (p.Cell == cell &&
            GetDistance(view, p, { x + 0.5, y + 0.5 }, place) < (point ? pointReach : lineReach))
          {
            near = true;
            const double off = std::abs(drawn - view.Depth(place)) / (point ? 1e-5 : 0.03);
            seen[i] += off <= 1. ? 1 : 0;
            depthOff = std::min(depthOff, off);
            valueOff = std::min(valueOff,
              std::abs(layers.Value("value", x, y) - Value(place)) / (point ? 1e-6 : 0.15));
          }
        }
        far += near ? 0 : 1;
        depth = std::max(depth, depthOff);
        value = std::max(value, valueOff);
      }
    }
    const std::string name = what + ", " + relievoTest::ToString(way);
    for (std::size_t i = 0; i < primitives.size(); ++i)
    {
      RELIEVO_CHECK_THAT(seen[i] > 0,
        name + ": primitive " + std::to_string(i) + " of cell " +
          std::to_string(primitives[i].Cell) + " is not seen");
    }
    RELIEVO_CHECK_AT_MOST(mismatches, 0, name + ": pixels of which layers contradict one another");
    RELIEVO_CHECK_AT_MOST(far, 0, name + ": pixels that are not near what they name");
    RELIEVO_CHECK_AT_MOST(depth, 1., name + ": depth, of what is allowed");
    RELIEVO_CHECK_AT_MOST(value, 1., name + ": value, of what is allowed");
  }
}

void TestRepresentation(const char* what, int representation, double pointSize, double lineWidth,
  bool surfaces, bool linesToo)
{
  const Stage stage(300, 200);
  const relievoTest::GLCheck gl(stage.Window);
  const auto mesh = MakeMesh(surfaces, linesToo);
  const auto actor = relievoTest::AddActor(stage.Renderer, mesh);
  actor->GetProperty()->SetRepresentation(representation);
  actor->GetProperty()->SetPointSize(static_cast<float>(pointSize));
  actor->GetProperty()->SetLineWidth(static_cast<float>(lineWidth));
  // A point is a square.
  CheckPrimitives(what, stage, MakePrimitives(mesh, representation), 0.71 * pointSize + 0.8,
    0.5 * lineWidth + 1.);
}

// Points shown over a surface belong to no cell; the surface beside them does.
void TestVertices()
{
  const Stage stage(200, 150);
  const auto actor = relievoTest::AddActor(stage.Renderer, relievoTest::MakeBox(1.2, 1.2, 1.2));
  actor->GetProperty()->VertexVisibilityOn();
  actor->GetProperty()->EdgeVisibilityOn();
  actor->GetProperty()->SetPointSize(9.);
  for (const relievoTest::Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, { "depth", "actor", "cell" }, way);
    const long long covered = layers.Covered();
    const long long points = layers.CountId("cell", -1) - (200 * 150 - covered);
    RELIEVO_CHECK(covered > 2000 && layers.CountId("actor", 0) == covered);
    RELIEVO_CHECK(points > 7 * 30 && points < 8 * 150);
  }
}

// Splats have no surface, and VTK's shader for them no place for layers: that is said, once, by the
// mapper's name, and the layers of all else are whole.
void TestSplats()
{
  const Stage stage(200, 150);
  const relievoTest::GLCheck gl(stage.Window);
  vtkNew<vtkPointGaussianMapper> mapper;
  const auto mesh = MakeMesh(false, true);
  // All points: with fewer verts than points VTK 9.7 writes behind its own array.
  mesh->SetVerts(vtkNew<vtkCellArray>());
  mapper->SetInputData(mesh);
  mapper->SetScaleFactor(0.1);
  mapper->EmissiveOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  const auto box = relievoTest::AddActor(stage.Renderer, relievoTest::MakeBox(0.6, 0.6, 0.6));
  box->SetPosition(0.6, 0.4, 0.);
  const Layers alone(stage.Renderer, { "depth", "cell" });
  stage.Renderer->AddActor(actor);
  vtkRelievoPass* frame = vtkRelievoPass::Attach(stage.Renderer);
  const relievoTest::ExpectMessage expected("vtkOpenGLPointGaussianMapperHelper");
  for (const relievoTest::Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, { "depth", "cell" }, way);
    RELIEVO_CHECK_AT_MOST(
      relievoTest::CountDifferent(alone, layers, "depth"), 0, "splats: pixels of the depth");
    RELIEVO_CHECK_AT_MOST(
      relievoTest::CountDifferent(alone, layers, "cell"), 0, "splats: pixels of the cells");
  }
  RELIEVO_CHECK(expected.Count() == 1 && frame);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersLines)
{
  relievoTest::Session session;
  TestRepresentation("points and lines", VTK_SURFACE, 1., 1., false, true);
  TestRepresentation("thick points and lines", VTK_SURFACE, 7., 5., false, true);
  TestRepresentation("wireframe", VTK_WIREFRAME, 3., 1., true, true);
  TestRepresentation("thick wireframe", VTK_WIREFRAME, 3., 4., true, true);
  TestRepresentation("all as points", VTK_POINTS, 5., 1., true, true);
  TestVertices();
  TestSplats();
  return session.Result();
}
}
