// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Spheres and tubes that VTK draws on flat pieces: depth and normal are the shape's, the ids are
// those of its point or line.
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
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>
#if __has_include(<vtkOpenGLSphereMapper.h>)
#include <vtkOpenGLSphereMapper.h>
#endif
#if __has_include(<vtkOpenGLStickMapper.h>)
#include <vtkOpenGLStickMapper.h>
#endif

#include <algorithm>

namespace testLayersImpostors
{
namespace
{
using relievoTest::AngleDegrees;
using relievoTest::Layers;
using relievoTest::PixelTruth;
using relievoTest::Ray;
using relievoTest::Stage;
using relievoTest::SurfacePoint;
using relievoTest::TruthImage;
using relievoTest::View;
using relievoTest::Way;

struct Limits
{
  double Depth;    // of the shape's radius
  double Normal;   // degrees
  double Coverage; // share of the pixels covered
};

void SetParallel(const Stage& stage, bool parallel)
{
  stage.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
  stage.Renderer->GetActiveCamera()->SetParallelScale(1.6);
}

// The actor of the truth is the cell, and the value of the array `weight` where it is asked.
void CheckShapes(const std::string& what, const Stage& stage, const TruthImage& truth,
  double radius, const Limits& limits, bool weights)
{
  std::vector<std::string> names = { "depth", "normal", "geometric_normal", "actor", "cell" };
  if (weights)
  {
    names.emplace_back("weight");
  }
  for (const Way way : relievoTest::BothWays)
  {
    const Layers layers(stage.Renderer, names, way);
    double depth = 0.;
    double normal = 0.;
    long long inner = 0;
    long long hits = 0;
    long long other = 0;
    long long mismatches = 0;
    for (int y = 0; y < truth.Height; ++y)
    {
      for (int x = 0; x < truth.Width; ++x)
      {
        const PixelTruth& pixel = truth.At(x, y);
        const double drawn = layers.Value("depth", x, y);
        hits += pixel.Hit ? 1 : 0;
        other += pixel.Hit != std::isfinite(drawn) ? 1 : 0;
        if (!pixel.Inner || !pixel.Hit || !std::isfinite(drawn))
        {
          continue;
        }
        ++inner;
        depth = std::max(depth, std::abs(drawn - pixel.Depth) / radius);
        for (const char* name : { "normal", "geometric_normal" })
        {
          normal = std::max(normal, AngleDegrees(layers.Vector(name, x, y), pixel.Normal));
        }
        mismatches +=
          layers.Id("actor", x, y) != 0 || layers.Id("cell", x, y) != pixel.Actor ? 1 : 0;
        mismatches += weights && layers.Value("weight", x, y) != 0.5 + pixel.Actor ? 1 : 0;
      }
    }
    const std::string name = what + ", " + relievoTest::ToString(way);
    RELIEVO_CHECK_THAT(inner > 1000, name + ": too little is seen");
    RELIEVO_CHECK_AT_MOST(static_cast<double>(other) / static_cast<double>(hits), limits.Coverage,
      name + ": share of other coverage");
    RELIEVO_CHECK_AT_MOST(depth, limits.Depth, name + ": depth, in radii");
    RELIEVO_CHECK_AT_MOST(normal, limits.Normal, name + ": normal, degrees");
    RELIEVO_CHECK_AT_MOST(mismatches, 0, name + ": pixels with another id");
  }
}

// Six points in a row, in space, with their number as an array.
vtkSmartPointer<vtkPolyData> MakePoints()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> weight;
  weight->SetName("weight");
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(0.6 * i - 1.5, 0.1 + 0.2 * (i % 3), 0.4 * (i % 2));
    weight->InsertNextValue(0.5 + i);
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->AddArray(weight);
  return mesh;
}

// All points in one cell, without which VTK draws nothing.
[[maybe_unused]] void AddOneCell(vtkPolyData* mesh)
{
  const vtkIdType ids[6] = { 0, 1, 2, 3, 4, 5 };
  mesh->SetVerts(vtkNew<vtkCellArray>());
  mesh->GetVerts()->InsertNextCell(6, ids);
}

glm::dmat4 Place(vtkActor* actor)
{
  return relievoTest::AnalyticScene::ToMatrix(actor->GetMatrix()->GetData());
}

glm::dvec3 PointAt(vtkPolyData* mesh, vtkIdType i, vtkActor* actor)
{
  glm::dvec4 p(0., 0., 0., 1.);
  mesh->GetPoint(i, &p[0]);
  return glm::dvec3(Place(actor) * p);
}

#if __has_include(<vtkOpenGLSphereMapper.h>)
void TestSphereMapper(bool parallel, bool withCells)
{
  const Stage stage(240, 160);
  SetParallel(stage, parallel);
  const auto mesh = MakePoints();
  // The mapper draws the points, whatever cells there are.
  AddOneCell(mesh);
  if (withCells)
  {
    mesh->SetPolys(vtkNew<vtkCellArray>());
    mesh->GetPolys()->InsertNextCell({ 0, 1, 2 });
    mesh->GetPolys()->InsertNextCell({ 3, 4, 5 });
  }
  vtkNew<vtkFloatArray> radii;
  radii->SetName("radius");
  for (int i = 0; i < 6; ++i)
  {
    radii->InsertNextValue(0.2f + 0.03f * static_cast<float>(i));
  }
  mesh->GetPointData()->AddArray(radii);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->SetScaleArray("radius");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(0.1, 0.2, -0.1);
  actor->RotateY(20.);
  stage.Renderer->AddActor(actor);
  const relievoTest::GLCheck gl(stage.Window);
  relievoTest::AnalyticScene scene;
  for (int i = 0; i < 6; ++i)
  {
    scene.AddSphere(radii->GetValue(i), glm::translate(glm::dmat4(1.), PointAt(mesh, i, actor)));
  }
  CheckShapes(std::string("sphere mapper, ") + (parallel ? "parallel" : "perspective") +
      (withCells ? ", with cells" : ""),
    stage, scene.Trace(View(stage.Renderer)), 0.2, { 2e-4, 0.1, 0.01 }, true);
}
#endif

// A round rod from -half to +half about an axis; ends are flat, and there are none if half is huge.
struct Rod
{
  glm::dvec3 Middle;
  glm::dvec3 Axis;
  double Half;
  double Radius;

  bool Cast(const Ray& ray, double from, double& depth, glm::dvec3& normal) const
  {
    const glm::dvec3 o = ray.Origin - this->Middle;
    const glm::dvec3 across = ray.Direction - glm::dot(ray.Direction, this->Axis) * this->Axis;
    const glm::dvec3 off = o - glm::dot(o, this->Axis) * this->Axis;
    const double a = glm::dot(across, across);
    const double b = glm::dot(off, across);
    const double d = b * b - a * (glm::dot(off, off) - this->Radius * this->Radius);
    if (d < 0. || a == 0.)
    {
      return false;
    }
    depth = (-b - std::sqrt(d)) / a;
    const double height = glm::dot(o + depth * ray.Direction, this->Axis);
    if (std::abs(height) <= this->Half)
    {
      normal = off + depth * across;
      return depth >= from;
    }
    const double leave = (-b + std::sqrt(d)) / a;
    const double along = glm::dot(ray.Direction, this->Axis);
    depth = (std::copysign(this->Half, height) - glm::dot(o, this->Axis)) / along;
    normal = std::copysign(1., height) * this->Axis;
    return along * height < 0. && depth < leave && depth >= from;
  }
};

TruthImage TraceRods(const View& view, const std::vector<Rod>& rods)
{
  return relievoTest::TraceView(view, [&](const Ray& ray, double from, double to) {
    SurfacePoint best;
    for (std::size_t i = 0; i < rods.size(); ++i)
    {
      double depth = 0.;
      glm::dvec3 normal;
      if (rods[i].Cast(ray, from, depth, normal) && depth <= to && depth < best.Depth)
      {
        best.Hit = true;
        best.Depth = depth;
        best.Position = ray.At(depth);
        best.Normal = glm::normalize(normal);
        best.Actor = static_cast<int>(i);
      }
    }
    return best;
  });
}

#if __has_include(<vtkOpenGLStickMapper.h>)
void TestStickMapper(bool parallel)
{
  const Stage stage(240, 160);
  SetParallel(stage, parallel);
  const auto mesh = MakePoints();
  vtkNew<vtkFloatArray> sizes;
  vtkNew<vtkFloatArray> axes;
  vtkNew<vtkUnsignedCharArray> colors;
  sizes->SetName("size");
  sizes->SetNumberOfComponents(3);
  axes->SetName("axis");
  axes->SetNumberOfComponents(3);
  colors->SetNumberOfComponents(3);
  std::vector<Rod> rods;
  vtkNew<vtkOpenGLStickMapper> mapper;
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(0.1, 0.3, 0.);
  actor->RotateZ(15.);
  for (int i = 0; i < 6; ++i)
  {
    const double length = 0.5 + 0.05 * i;
    const double radius = 0.2 - 0.01 * i;
    const glm::dvec3 axis =
      glm::normalize(glm::dvec3(0.3 * i - 0.7, 1. - 0.3 * i, 0.2 + 0.1 * (i % 3)));
    sizes->InsertNextTuple3(length, radius, 0.);
    axes->InsertNextTuple3(axis.x, axis.y, axis.z);
    colors->InsertNextTuple3(255, 40 * i, 0);
    rods.push_back(
      { PointAt(mesh, i, actor), glm::dmat3(Place(actor)) * axis, 0.5 * length, radius });
  }
  AddOneCell(mesh);
  mesh->GetPointData()->AddArray(sizes);
  mesh->GetPointData()->AddArray(axes);
  mesh->GetPointData()->SetScalars(colors);
  mapper->SetInputData(mesh);
  mapper->SetScaleArray("size");
  mapper->SetOrientationArray("axis");
  stage.Renderer->AddActor(actor);
  const relievoTest::GLCheck gl(stage.Window);
  CheckShapes(std::string("stick mapper, ") + (parallel ? "parallel" : "perspective"), stage,
    TraceRods(View(stage.Renderer), rods), 0.2, { 2e-4, 0.1, 0.02 }, true);
}
#endif

// Sprites and tubes are balls and rods in parallel projection (where VTK's own depth buffer has
// them protrude twice as far as they should). In perspective they are compared with VTK's depth
// buffer.
void CheckAgainstDepthBuffer(const std::string& what, const Stage& stage)
{
  const Layers layers(stage.Renderer, { "depth" }, Way::Shared);
  vtkNew<vtkFloatArray> buffer;
  stage.Window->Render();
  stage.Window->GetZbufferData(0, 0, layers.Width - 1, layers.Height - 1, buffer);
  double range[2];
  stage.Renderer->GetActiveCamera()->GetClippingRange(range);
  double worst = 0.;
  long long other = 0;
  for (int y = 0; y < layers.Height; ++y)
  {
    for (int x = 0; x < layers.Width; ++x)
    {
      const double z = buffer->GetValue(y * layers.Width + x);
      const double depth = layers.Value("depth", x, y);
      other += (z < 1.) != std::isfinite(depth) ? 1 : 0;
      if (z < 1. && std::isfinite(depth))
      {
        const double there = range[0] * range[1] / (range[1] - z * (range[1] - range[0]));
        worst = std::max(worst, std::abs(depth - there) / there);
      }
    }
  }
  RELIEVO_CHECK(layers.Covered() > 1000);
  RELIEVO_CHECK_AT_MOST(other, 0, what + ": pixels not covered as in VTK's depth buffer");
  RELIEVO_CHECK_AT_MOST(worst, 1e-5, what + ": against VTK's depth buffer");
}

void TestPointsAsSpheres(bool parallel)
{
  const Stage stage(240, 160);
  SetParallel(stage, parallel);
  const auto mesh = MakePoints();
  mesh->SetVerts(vtkNew<vtkCellArray>());
  for (vtkIdType i = 0; i < 6; ++i)
  {
    mesh->GetVerts()->InsertNextCell(1, &i);
  }
  const auto actor = relievoTest::AddActor(stage.Renderer, mesh);
  actor->GetProperty()->SetPointSize(30.);
  actor->GetProperty()->RenderPointsAsSpheresOn();
  actor->SetPosition(0., 0.2, 0.);
  const View view(stage.Renderer);
  relievoTest::AnalyticScene scene;
  for (int i = 0; i < 6; ++i)
  {
    const glm::dvec3 p = PointAt(mesh, i, actor);
    const double depth = view.Depth(p);
    const double pixel =
      glm::length(view.PixelRay(120.5, 80.).At(depth) - view.PixelRay(119.5, 80.).At(depth));
    scene.AddSphere(15. * pixel, glm::translate(glm::dmat4(1.), p));
  }
  if (parallel)
  {
    CheckShapes("points as spheres", stage, scene.Trace(view), 0.3, { 1e-4, 0.1, 0.01 }, true);
  }
  else
  {
    CheckAgainstDepthBuffer("points as spheres, perspective", stage);
  }
}

void TestLinesAsTubes(bool parallel, bool slanted)
{
  const Stage stage(240, 160);
  SetParallel(stage, parallel);
  // Beyond the picture, so that no ends are seen; across the view if not slanted.
  const glm::dvec3 right = View(stage.Renderer).Right;
  const glm::dvec3 lean = slanted ? glm::dvec3(0., -0.1, 0.9) : glm::dvec3(0.);
  const glm::dvec3 high(0.1, 1., 0.);
  const auto mesh = relievoTest::MakePolygons({ high - 6. * (right + 0.1 * lean),
    high + 6. * (right + 0.1 * lean), -6. * (right + 0.2 * lean), 6. * (right + 0.2 * lean) });
  mesh->SetLines(vtkNew<vtkCellArray>());
  mesh->GetLines()->InsertNextCell({ 0, 1 });
  mesh->GetLines()->InsertNextCell({ 2, 3 });
  const auto actor = relievoTest::AddActor(stage.Renderer, mesh);
  actor->GetProperty()->SetLineWidth(24.);
  actor->GetProperty()->RenderLinesAsTubesOn();
  const View view(stage.Renderer);
  std::vector<Rod> rods;
  for (int i = 0; i < 2; ++i)
  {
    const glm::dvec3 a = PointAt(mesh, 2 * i, actor);
    const glm::dvec3 b = PointAt(mesh, 2 * i + 1, actor);
    const double depth = view.Depth(0.5 * (a + b));
    const double pixel =
      glm::length(view.PixelRay(120.5, 80.).At(depth) - view.PixelRay(119.5, 80.).At(depth));
    rods.push_back({ 0.5 * (a + b), glm::normalize(b - a), 1e9, 12. * pixel });
  }
  if (parallel)
  {
    // VTK's tubes are a little off where they lean towards the eye.
    CheckShapes(slanted ? "slanted lines as tubes" : "lines as tubes", stage, TraceRods(view, rods),
      0.25, slanted ? Limits{ 0.1, 8., 0.02 } : Limits{ 1e-3, 0.5, 0.02 }, false);
  }
  else
  {
    CheckAgainstDepthBuffer("lines as tubes, perspective", stage);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testLayersImpostors)
{
  relievoTest::Session session;
  TestLinesAsTubes(true, false);
  for (const bool parallel : { true, false })
  {
#if __has_include(<vtkOpenGLSphereMapper.h>)
    TestSphereMapper(parallel, false);
    TestSphereMapper(parallel, true);
#endif
#if __has_include(<vtkOpenGLStickMapper.h>)
    TestStickMapper(parallel);
#endif
    TestPointsAsSpheres(parallel);
    TestLinesAsTubes(parallel, true);
  }
  return session.Result();
}
}
