// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hits of rays, against all triangles in extended precision, and against Embree: meshes, soups,
// slivers, glyphs, far from the origin, moved points and matrices.
#include "AddressLimit.h"
#include "BruteRays.h"
#include "Check.h"
#include "EmbreeScene.h"
#include "Scenes.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCubeSource.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkLineSource.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRelievoMeshTexels.h>
#include <vtkRelievoRayScene.h>
#include <vtkRelievoWideTree.h>
#include <vtkRenderer.h>
#include <vtkSkybox.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>
#include <vtkTable.h>
#include <vtkTransform.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iostream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace testRays
{
namespace
{
using relievoTest::BruteAnswer;
using relievoTest::BruteRays;

std::mt19937_64 Lots(7);

double Draw(double low, double high)
{
  return low + (high - low) * std::uniform_real_distribution<double>()(Lots);
}

glm::dvec3 DrawBetween(const glm::dvec3& low, const glm::dvec3& high)
{
  return glm::dvec3(Draw(low.x, high.x), Draw(low.y, high.y), Draw(low.z, high.z));
}

struct Rays
{
  vtkNew<vtkDoubleArray> Origins;
  vtkNew<vtkDoubleArray> Directions;

  Rays()
  {
    this->Origins->SetNumberOfComponents(3);
    this->Directions->SetNumberOfComponents(3);
  }
  void Add(const glm::dvec3& origin, const glm::dvec3& direction)
  {
    this->Origins->InsertNextTuple(&origin.x);
    this->Directions->InsertNextTuple(&direction.x);
  }
  glm::dvec3 GetOrigin(vtkIdType i) const
  {
    glm::dvec3 v;
    this->Origins->GetTuple(i, &v.x);
    return v;
  }
  glm::dvec3 GetDirection(vtkIdType i) const
  {
    glm::dvec3 v;
    this->Directions->GetTuple(i, &v.x);
    return v;
  }
  vtkIdType GetCount() const { return this->Directions->GetNumberOfTuples(); }

  // From outside and inside of a box to places in it, of all lengths; some along axes.
  void AddThrough(const glm::dvec3& low, const glm::dvec3& high, int count)
  {
    const glm::dvec3 half = 0.5 * (high - low);
    for (int i = 0; i < count; ++i)
    {
      const glm::dvec3 to = DrawBetween(low, high);
      const double out = i % 4 == 0 ? 0. : i % 4 == 1 ? 100. : 2.;
      const glm::dvec3 from = DrawBetween(low - out * half, high + out * half);
      glm::dvec3 way = std::pow(10., Draw(-6., 6.)) * (to - from);
      if (i % 8 == 7)
      {
        way = glm::dvec3(0.);
        way[i / 8 % 3] = i % 16 < 8 ? 1. : -3.;
      }
      this->Add(i % 8 == 7 ? to - 3. * glm::length(half) * glm::normalize(way) : from, way);
    }
  }
};

double GetNumber(vtkTable* table, const char* column, vtkIdType row, int component = 0)
{
  auto* array = vtkDataArray::SafeDownCast(table->GetColumnByName(column));
  return array ? array->GetComponent(row, component) : vtkMath::Nan();
}

glm::dvec3 GetVector(vtkTable* table, const char* column, vtkIdType row)
{
  return glm::dvec3(GetNumber(table, column, row, 0), GetNumber(table, column, row, 1),
    GetNumber(table, column, row, 2));
}

bool IsSame(vtkDataArray* a, vtkDataArray* b)
{
  return a && b && a->GetDataType() == b->GetDataType() &&
    a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
      static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize())) == 0;
}

bool IsSame(vtkTable* a, vtkTable* b)
{
  bool same = a->GetNumberOfColumns() == b->GetNumberOfColumns();
  for (vtkIdType i = 0; i < a->GetNumberOfColumns() && same; ++i)
  {
    same = IsSame(
      vtkDataArray::SafeDownCast(a->GetColumn(i)), vtkDataArray::SafeDownCast(b->GetColumn(i)));
  }
  return same;
}

// All three answers for all rays, against the truth, to so much of the scene's size, and bit for
// bit against those without AVX2, and those of a file.
void Compare(vtkRelievoRayScene* scene, const BruteRays& truth, const Rays& rays,
  const std::string& what, double low = 0., double high = 1e300, double most = 1e-12)
{
  scene->SetMinimumDistance(low);
  scene->SetMaximumDistance(high);
  vtkNew<vtkTable> nearest;
  vtkNew<vtkTable> all;
  vtkNew<vtkUnsignedCharArray> any;
  RELIEVO_CHECK_THAT(scene->FindNearest(rays.Origins, rays.Directions, nearest) &&
      scene->FindAll(rays.Origins, rays.Directions, all) &&
      scene->FindAny(rays.Origins, rays.Directions, any),
    what);
  vtkNew<vtkTable> plainNearest;
  vtkNew<vtkTable> plainAll;
  vtkNew<vtkUnsignedCharArray> plainAny;
  vtkRelievoWideTree::SetUsesAvx2(false);
  RELIEVO_CHECK_THAT(scene->FindNearest(rays.Origins, rays.Directions, plainNearest) &&
      scene->FindAll(rays.Origins, rays.Directions, plainAll) &&
      scene->FindAny(rays.Origins, rays.Directions, plainAny),
    what + ", without AVX2");
  vtkRelievoWideTree::SetUsesAvx2(true);
  RELIEVO_CHECK_THAT(
    IsSame(nearest, plainNearest) && IsSame(all, plainAll) && IsSame(any, plainAny),
    what + ", other answers without AVX2");
  vtkNew<vtkRelievoRayScene> stored;
  stored->SetMinimumDistance(low);
  stored->SetMaximumDistance(high);
  RELIEVO_CHECK_THAT(scene->Write("scene.rays") && stored->Read("scene.rays") &&
      stored->FindNearest(rays.Origins, rays.Directions, plainNearest) &&
      stored->FindAll(rays.Origins, rays.Directions, plainAll) &&
      stored->FindAny(rays.Origins, rays.Directions, plainAny),
    what + ", of a file");
  RELIEVO_CHECK_THAT(
    IsSame(nearest, plainNearest) && IsSame(all, plainAll) && IsSame(any, plainAny),
    what + ", other answers of a file");
  const double size = glm::length(truth.GetHigh() - truth.GetLow());
  vtkIdType row = 0;
  int unsure = 0;
  int hits = 0;
  int mismatches = 0;
  double offDistance = 0.;
  double offPlace = 0.;
  for (vtkIdType i = 0; i < rays.GetCount(); ++i)
  {
    const glm::dvec3 from = rays.GetOrigin(i);
    const glm::dvec3 way = rays.GetDirection(i);
    const BruteAnswer answer = truth.Find(from, way, low, high);
    const vtkIdType first = row;
    while (row < all->GetNumberOfRows() && GetNumber(all, "ray", row) == static_cast<double>(i))
    {
      ++row;
    }
    if (answer.Unsure)
    {
      ++unsure;
      continue;
    }
    bool right = row - first == static_cast<vtkIdType>(answer.Hits.size()) &&
      (any->GetValue(i) != 0) == !answer.Hits.empty() &&
      std::isinf(GetNumber(nearest, "distance", i)) == answer.Hits.empty();
    for (vtkIdType k = first; k < row && right; ++k)
    {
      const relievoTest::BruteHit& hit = answer.Hits[static_cast<std::size_t>(k - first)];
      right = GetNumber(all, "prop", k) == hit.Prop &&
        GetNumber(all, "cell", k) == static_cast<double>(hit.Cell);
      offDistance = relievoTest::Larger(
        offDistance, std::abs(GetNumber(all, "distance", k) - hit.Distance) / size);
      const glm::dvec3 place = from + hit.Distance * glm::normalize(way);
      offPlace =
        relievoTest::Larger(offPlace, glm::length(GetVector(all, "position", k) - place) / size);
    }
    if (right && !answer.Hits.empty())
    {
      ++hits;
      for (const char* column : { "distance", "prop", "block", "cell" })
      {
        right = right && GetNumber(nearest, column, i) == GetNumber(all, column, first);
      }
      for (const char* column : { "position", "normal", "geometric_normal", "weights", "points" })
      {
        right = right && GetVector(nearest, column, i) == GetVector(all, column, first);
      }
    }
    mismatches += right ? 0 : 1;
  }
  std::cout << what << ": " << rays.GetCount() << " rays, " << hits << " hit, " << unsure
            << " left out\n";
  RELIEVO_CHECK_THAT(mismatches == 0, what + ": " + std::to_string(mismatches) + " wrong");
  RELIEVO_CHECK_THAT(row == all->GetNumberOfRows(), what);
  RELIEVO_CHECK_THAT(20 * unsure <= rays.GetCount(), what + ": " + std::to_string(unsure));
  RELIEVO_CHECK_AT_MOST(offDistance, most, what + ", distances, of the size");
  RELIEVO_CHECK_AT_MOST(offPlace, most, what + ", places, of the size");
}

vtkSmartPointer<vtkPolyData> MakeMesh()
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

void AddTriangle(vtkPolyData* mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  vtkIdType ids[3];
  int i = 0;
  for (const glm::dvec3& p : { a, b, c })
  {
    ids[i++] = mesh->GetPoints()->InsertNextPoint(p.x, p.y, p.z);
  }
  mesh->GetPolys()->InsertNextCell(3, ids);
}

// Triangles of all sizes; with `faults` also some without an area, or with a corner nowhere.
vtkSmartPointer<vtkPolyData> MakeSoup(int count, bool faults)
{
  const auto mesh = MakeMesh();
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 at = DrawBetween(glm::dvec3(-1.), glm::dvec3(1.));
    const glm::dvec3 reach(std::pow(10., Draw(-3., 0.)));
    glm::dvec3 p[3];
    for (glm::dvec3& each : p)
    {
      each = at + DrawBetween(-reach, reach);
    }
    if (faults && i % 5 == 0)
    {
      p[2] = i % 2 == 0 ? p[1] : 0.5 * (p[0] + p[1]);
    }
    if (faults && i % 7 == 0)
    {
      p[i % 3][i % 2] = i % 2 == 0 ? vtkMath::Nan() : vtkMath::Inf();
    }
    AddTriangle(mesh, p[0], p[1], p[2]);
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> MakeSlivers(int count)
{
  const auto mesh = MakeMesh();
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 a = DrawBetween(glm::dvec3(-1.), glm::dvec3(1.));
    const glm::dvec3 b = DrawBetween(glm::dvec3(-1.), glm::dvec3(1.));
    const double width = std::pow(10., Draw(-7., -1.));
    AddTriangle(mesh, a, b, b + DrawBetween(glm::dvec3(-width), glm::dvec3(width)));
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> MakeSphere(const glm::dvec3& center, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->SetThetaResolution(2 * resolution);
  sphere->SetPhiResolution(resolution);
  sphere->SetRadius(1.);
  sphere->SetCenter(center.x, center.y, center.z);
  sphere->Update();
  return sphere->GetOutput();
}

void TestMesh(vtkPolyData* mesh, int count, const std::string& what)
{
  BruteRays truth;
  truth.Add(mesh, 0);
  vtkNew<vtkRelievoRayScene> scene;
  RELIEVO_CHECK(scene->AddData(mesh) == 0);
  Rays rays;
  rays.AddThrough(truth.GetLow(), truth.GetHigh(), count);
  Compare(scene, truth, rays, what);
  const double size = glm::length(truth.GetHigh() - truth.GetLow());
  Compare(scene, truth, rays, what + ", between", 0.3 * size, 1.1 * size);
}

// Rays at the very points and edges of a closed mesh: none gets out.
void TestWatertight()
{
  const auto mesh = MakeSphere(glm::dvec3(0.3, -0.2, 0.1), 40);
  vtkNew<vtkRelievoRayScene> scene;
  scene->AddData(mesh);
  Rays rays;
  for (int i = 0; i < 20; ++i)
  {
    const glm::dvec3 from =
      glm::dvec3(0.3, -0.2, 0.1) + DrawBetween(glm::dvec3(-0.4), glm::dvec3(0.4));
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetCellPoints(cell, count, ids);
      glm::dvec3 a;
      glm::dvec3 b;
      mesh->GetPoint(ids[0], &a.x);
      mesh->GetPoint(ids[1], &b.x);
      const double share = i % 2 == 0 ? 0. : Draw(0., 1.);
      rays.Add(from, a + share * (b - a) - from);
    }
  }
  vtkNew<vtkUnsignedCharArray> met;
  RELIEVO_CHECK(scene->FindAny(rays.Origins, rays.Directions, met));
  vtkIdType out = 0;
  for (vtkIdType i = 0; i < met->GetNumberOfTuples(); ++i)
  {
    out += met->GetValue(i) ? 0 : 1;
  }
  RELIEVO_CHECK(met->GetNumberOfTuples() > 100000);
  RELIEVO_CHECK_AT_MOST(static_cast<double>(out), 0., "rays that leave a closed mesh by an edge");
}

void TestBunny()
{
  const auto bunny = relievoTest::LoadMesh("bunny");
  TestMesh(bunny, 60, "bunny");
  relievoTest::EmbreeScene embree;
  embree.AddActor(bunny);
  vtkNew<vtkRelievoRayScene> scene;
  scene->AddData(bunny);
  double bounds[6];
  bunny->GetBounds(bounds);
  Rays rays;
  rays.AddThrough(glm::dvec3(bounds[0], bounds[2], bounds[4]),
    glm::dvec3(bounds[1], bounds[3], bounds[5]), 200000);
  vtkNew<vtkTable> nearest;
  RELIEVO_CHECK(scene->FindNearest(rays.Origins, rays.Directions, nearest));
  int other = 0;
  int hits = 0;
  double off = 0.;
  for (vtkIdType i = 0; i < rays.GetCount(); ++i)
  {
    const glm::dvec3 way = glm::normalize(rays.GetDirection(i));
    const auto truth = embree.Cast({ rays.GetOrigin(i), way }, 0., HUGE_VAL);
    const double distance = GetNumber(nearest, "distance", i);
    hits += truth.Hit ? 1 : 0;
    if (truth.Hit != std::isfinite(distance) ||
      (truth.Hit && std::abs(truth.Depth - distance) > 1e-6 * bunny->GetLength()))
    {
      ++other; // a float's choice of the triangle, at an edge
      continue;
    }
    if (truth.Hit)
    {
      off = relievoTest::Larger(off, std::abs(truth.Depth - distance) / bunny->GetLength());
    }
  }
  RELIEVO_CHECK(hits > 60000);
  RELIEVO_CHECK_AT_MOST(other / double(rays.GetCount()), 1e-4, "share of other hits than Embree's");
  RELIEVO_CHECK_AT_MOST(off, 1e-6, "distances beside Embree's, of the size");
  // In kibibytes; exact shadows hold 40 bytes for a triangle and 16 for its share of nodes.
  RELIEVO_CHECK_AT_MOST(
    scene->GetActualMemorySize() * 1024. / bunny->GetNumberOfCells(), 56., "bytes for a triangle");
}

// A triangle, by hand.
void TestTriangle()
{
  const auto mesh = MakeMesh();
  AddTriangle(mesh, glm::dvec3(0., 0., 1.), glm::dvec3(4., 0., 1.), glm::dvec3(0., 4., 1.));
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(0., 0., 1.);
  normals->InsertNextTuple3(1., 0., 0.);
  normals->InsertNextTuple3(0., 1., 0.);
  mesh->GetPointData()->SetNormals(normals);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, 2.); // twice as wide along x
  matrix->SetElement(2, 3, 10.);
  vtkNew<vtkRelievoRayScene> scene;
  scene->AddData(mesh, matrix);
  Rays rays;
  rays.Add(glm::dvec3(2., 2., 20.), glm::dvec3(0., 0., -0.1)); // the front
  rays.Add(glm::dvec3(2., 2., 1.), glm::dvec3(0., 0., 7.));    // the back
  rays.Add(glm::dvec3(5., 2., 1.), glm::dvec3(0., 0., 7.));    // past it
  rays.Add(glm::dvec3(2., 2., 1.), glm::dvec3(0., 0., -7.));   // away
  vtkNew<vtkTable> hits;
  RELIEVO_CHECK(scene->FindNearest(rays.Origins, rays.Directions, hits));
  const glm::dvec3 weights(0.25, 0.25, 0.5);
  // By the inverse of the matrix, of the normals' mean by their weights.
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.25 / 2., 0.5, 0.25));
  for (int i = 0; i < 2; ++i)
  {
    const double side = i == 0 ? 1. : -1.;
    RELIEVO_CHECK_NEAR(GetNumber(hits, "distance", i), i == 0 ? 9. : 10., 1e-14, "distance");
    RELIEVO_CHECK(GetVector(hits, "points", i) == glm::dvec3(0., 1., 2.));
    RELIEVO_CHECK(glm::length(GetVector(hits, "weights", i) - weights) < 1e-15);
    RELIEVO_CHECK(glm::length(GetVector(hits, "position", i) - glm::dvec3(2., 2., 11.)) < 1e-14);
    RELIEVO_CHECK(
      glm::length(GetVector(hits, "geometric_normal", i) - glm::dvec3(0., 0., side)) < 1e-15);
    RELIEVO_CHECK(glm::length(GetVector(hits, "normal", i) - side * normal) < 1e-15);
  }
  for (int i = 2; i < 4; ++i)
  {
    RELIEVO_CHECK(std::isinf(GetNumber(hits, "distance", i)));
    RELIEVO_CHECK(GetNumber(hits, "prop", i) == -1. && GetNumber(hits, "cell", i) == -1.);
    RELIEVO_CHECK(GetVector(hits, "position", i) == glm::dvec3(0.));
  }
}

// Moved meshes are refitted, and meshes placed several times are stored once.
void TestMoves()
{
  const auto mesh = MakeSoup(400, true);
  vtkNew<vtkRelievoRayScene> scene;
  std::vector<vtkSmartPointer<vtkMatrix4x4>> matrices;
  for (int i = 0; i < 300; ++i)
  {
    vtkNew<vtkTransform> move;
    move->Translate(Draw(-9., 9.), Draw(-9., 9.), Draw(-9., 9.));
    move->RotateWXYZ(Draw(0., 360.), Draw(-1., 1.), Draw(-1., 1.), Draw(-1., 1.));
    move->Scale(i % 2 ? 1. : -1., Draw(0.2, 2.), 1.);
    matrices.push_back(vtkSmartPointer<vtkMatrix4x4>::New());
    matrices.back()->DeepCopy(move->GetMatrix());
    RELIEVO_CHECK(scene->AddData(mesh, matrices.back()) == i);
  }
  const auto compare = [&](const std::string& what, int built, int refitted) {
    BruteRays truth;
    for (std::size_t i = 0; i < matrices.size(); ++i)
    {
      truth.Add(mesh, static_cast<int>(i), matrices[i]);
    }
    RELIEVO_CHECK_THAT(scene->Update(), what);
    RELIEVO_CHECK_THAT(
      scene->GetNumberOfMeshesBuilt() == built && scene->GetNumberOfMeshesRefitted() == refitted,
      what);
    RELIEVO_CHECK_THAT(!scene->Update(), what);
    Rays rays;
    rays.AddThrough(truth.GetLow(), truth.GetHigh(), 60);
    Compare(scene, truth, rays, what);
  };
  compare("300 places", 1, 0);
  RELIEVO_CHECK(scene->GetNumberOfTriangles() == 300 * 400);
  RELIEVO_CHECK_AT_MOST(
    static_cast<double>(scene->GetActualMemorySize()), 120., "kibibytes of 300 places");
  matrices[7]->SetElement(0, 3, 2.);
  matrices[8]->SetElement(1, 3, -3.);
  compare("moved matrices", 0, 0);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    mesh->GetPoint(i, &p.x);
    p += DrawBetween(glm::dvec3(-0.01), glm::dvec3(0.01));
    mesh->GetPoints()->SetPoint(i, &p.x);
  }
  mesh->GetPoints()->Modified();
  compare("moved points", 0, 1);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const glm::dvec3 p = DrawBetween(glm::dvec3(-1.), glm::dvec3(1.));
    mesh->GetPoints()->SetPoint(i, &p.x);
  }
  mesh->GetPoints()->Modified();
  compare("points all over the place", 1, 0);
}

// Polygons of data are the area enclosed by their outlines, for any first corner and winding, also
// in grids, and after their points have moved.
void TestConcave()
{
  using Corner = std::array<double, 2>;
  const std::vector<std::vector<Corner>> outlines = {
    { { 0., 0. }, { 2., 0. }, { 2., 1. }, { 1., 1. }, { 1., 2. }, { 0., 2. } }, // an L
    { { 0., 0. }, { 3., 0. }, { 3., 3. }, { 2., 3. }, { 2., 1. }, { 1., 1. }, { 1., 3. },
      { 0., 3. } },                                    // a U
    { { 0., 0. }, { 2., 1. }, { 4., 0. }, { 2., 3. } } // an arrow
  };
  vtkNew<vtkTransform> turn;
  turn->Translate(5., -3., 2.);
  turn->RotateWXYZ(40., 1., 2., 3.);
  const auto place = [&turn](double x, double y, double z) {
    const double from[3] = { x, y, z };
    glm::dvec3 to;
    turn->TransformPoint(from, &to.x);
    return to;
  };
  const auto isInside = [](const std::vector<Corner>& outline, double x, double y) {
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      const Corner& a = outline[i];
      const Corner& b = outline[(i + 1) % outline.size()];
      if ((a[1] > y) != (b[1] > y))
      {
        inside ^= x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
      }
    }
    return inside;
  };
  int mismatches = 0;
  for (std::size_t i = 0; i < 4 * outlines.size(); ++i)
  {
    const std::vector<Corner>& outline = outlines[i / 4];
    std::vector<Corner> mirrored = outline;
    for (Corner& corner : mirrored)
    {
      std::swap(corner[0], corner[1]);
    }
    const auto count = static_cast<vtkIdType>(outline.size());
    for (vtkIdType first = 0; first < count; ++first)
    {
      // A triangle apart, and then the polygon.
      std::vector<vtkIdType> ids;
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      points->SetNumberOfPoints(count);
      for (int k = 0; k < 3; ++k)
      {
        const glm::dvec3 at = place(9. + k % 2, k == 2 ? 10. : 9., 0.);
        points->InsertNextPoint(&at.x);
      }
      for (vtkIdType k = 0; k < count; ++k)
      {
        ids.push_back(k);
      }
      const vtkIdType apart[3] = { count, count + 1, count + 2 };
      vtkNew<vtkPolyData> mesh;
      vtkNew<vtkUnstructuredGrid> grid;
      vtkNew<vtkCellArray> polygons;
      polygons->InsertNextCell(3, apart);
      polygons->InsertNextCell(count, ids.data());
      mesh->SetPoints(points);
      mesh->SetPolys(polygons);
      grid->SetPoints(points);
      grid->SetCells(VTK_POLYGON, polygons);
      vtkNew<vtkRelievoRayScene> scene;
      scene->AddData(i % 4 < 2 ? static_cast<vtkDataSet*>(mesh) : grid);
      // Mirrored, and begun one corner on: others turn in.
      for (const bool isMirrored : { false, true })
      {
        const std::vector<Corner>& now = isMirrored ? mirrored : outline;
        for (vtkIdType k = 0; k < count; ++k)
        {
          const vtkIdType corner = first + (i % 2 ? k : count - k) + (isMirrored ? 1 : 0);
          const Corner& at = now[static_cast<std::size_t>(corner % count)];
          const glm::dvec3 point = place(at[0], at[1], 0.);
          points->SetPoint(k, &point.x);
        }
        points->Modified();
        grid->Modified();
        Rays rays;
        std::vector<int> expected;
        for (int k = 0; k < 50; ++k)
        {
          const double x = Draw(-0.5, 4.5);
          const double y = Draw(-0.5, 4.5);
          expected.push_back(isInside(now, x, y) ? 1 : 0);
          rays.Add(place(x, y, 3.), place(x, y, -1.) - place(x, y, 3.));
        }
        vtkNew<vtkTable> hits;
        RELIEVO_CHECK(scene->FindAll(rays.Origins, rays.Directions, hits));
        std::vector<int> met(expected.size());
        for (vtkIdType row = 0; row < hits->GetNumberOfRows(); ++row)
        {
          ++met[static_cast<std::size_t>(GetNumber(hits, "ray", row))];
          mismatches += GetNumber(hits, "cell", row) == 1. ? 0 : 1;
        }
        for (std::size_t k = 0; k < expected.size(); ++k)
        {
          mismatches += met[k] == expected[k] ? 0 : 1;
        }
      }
    }
  }
  RELIEVO_CHECK_NEAR(mismatches, 0, 0, "rays at polygons that are not convex");
}

// Glyphs by the thousands beside a mesh, blocks and props that rays cannot trace, in a renderer.
void TestRenderer()
{
  vtkNew<vtkRenderer> renderer;
  const auto sphere = MakeSphere(glm::dvec3(0.), 8);
  vtkNew<vtkPolyDataMapper> meshMapper;
  meshMapper->SetInputData(sphere);
  vtkNew<vtkActor> hidden;
  hidden->SetMapper(meshMapper);
  hidden->VisibilityOff();
  renderer->AddActor(hidden);
  vtkNew<vtkActor> large;
  large->SetMapper(meshMapper);
  large->SetScale(3., 2., 2.);
  large->GetProperty()->SetOpacity(0.25);
  renderer->AddActor(large);

  vtkNew<vtkPoints> places;
  vtkNew<vtkFloatArray> sizes;
  sizes->SetName("size");
  for (int i = 0; i < 3000; ++i)
  {
    const glm::dvec3 p = DrawBetween(glm::dvec3(-9.), glm::dvec3(9.));
    places->InsertNextPoint(&p.x);
    sizes->InsertNextValue(static_cast<float>(Draw(0.1, 0.4)));
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(places);
  points->GetPointData()->AddArray(sizes);
  const auto source = MakeSphere(glm::dvec3(0.), 4);
  vtkNew<vtkGlyph3DMapper> glyphMapper;
  glyphMapper->SetInputData(points);
  glyphMapper->SetSourceData(source);
  glyphMapper->SetScaleArray("size");
  glyphMapper->SetScaleModeToScaleByMagnitude();
  vtkNew<vtkActor> glyphs;
  glyphs->SetMapper(glyphMapper);
  renderer->AddActor(glyphs);

  vtkNew<vtkActor> wires;
  wires->SetMapper(meshMapper);
  wires->GetProperty()->SetRepresentationToWireframe();
  renderer->AddActor(wires);

  vtkNew<vtkLineSource> line;
  vtkNew<vtkPolyDataMapper> lineMapper;
  lineMapper->SetInputConnection(line->GetOutputPort());
  vtkNew<vtkActor> lines;
  lines->SetMapper(lineMapper);
  renderer->AddActor(lines);

  vtkNew<vtkSkybox> sky;
  renderer->AddActor(sky);

  BruteRays truth;
  truth.Add(sphere, 1, large->GetMatrix());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    vtkNew<vtkMatrix4x4> matrix;
    for (int k = 0; k < 3; ++k)
    {
      matrix->SetElement(k, k, sizes->GetValue(i));
      matrix->SetElement(k, 3, p[k]);
    }
    truth.Add(source, 2, matrix, i);
  }
  vtkNew<vtkRelievoRayScene> scene;
  scene->SetRenderer(renderer);
  {
    relievoTest::ExpectMessage expect("Rays do not hit vtkOpenGLActor, vtkOpenGLActor:");
    scene->Update();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  RELIEVO_CHECK(scene->GetNumberOfPropsLeftOut() == 2 && scene->GetPropLeftOut(0) == wires.Get() &&
    scene->GetPropLeftOut(1) == lines.Get());
  Rays rays;
  rays.AddThrough(truth.GetLow(), truth.GetHigh(), 150);
  Compare(scene, truth, rays, "glyphs and a mesh"); // and no second warning
  vtkNew<vtkTable> all;
  scene->FindAll(rays.Origins, rays.Directions, all);
  for (vtkIdType i = 0; i < all->GetNumberOfRows(); ++i)
  {
    const double opacity = GetNumber(all, "prop", i) == 1. ? 0.25 : 1.;
    RELIEVO_CHECK(GetNumber(all, "opacity", i) == opacity);
  }
}

// The volume within a mesh's triangles, positive if they are wound as seen from outside.
double GetVolume(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  double volume = 0.;
  for (vtkIdType i = 0; i < triangles->GetOutput()->GetNumberOfCells(); ++i)
  {
    vtkPoints* corners = triangles->GetOutput()->GetCell(i)->GetPoints();
    glm::dvec3 p[3];
    for (int k = 0; k < 3; ++k)
    {
      corners->GetPoint(k, &p[k].x);
    }
    volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6.;
  }
  return volume;
}

// Copies of meshes and glyphs have their outside outside, also where matrices mirror.
void TestMirrored()
{
  vtkNew<vtkCubeSource> box; // of quads
  box->SetXLength(2.);
  box->SetYLength(3.);
  box->SetCenter(0.5, 1., 2.);
  vtkNew<vtkTriangleFilter> cut;
  cut->SetInputConnection(box->GetOutputPort());
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(cut->GetOutputPort());
  strips->Update();
  RELIEVO_CHECK(strips->GetOutput()->GetNumberOfStrips() > 0);
  vtkNew<vtkPoints> places;
  vtkNew<vtkDoubleArray> scales;
  scales->SetName("scale");
  scales->SetNumberOfComponents(3);
  for (const double side : { 1., -1. })
  {
    places->InsertNextPoint(7. * side, 0., 0.);
    scales->InsertNextTuple3(1., side, 1.);
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(places);
  points->GetPointData()->AddArray(scales);
  for (vtkAlgorithm* source :
    { static_cast<vtkAlgorithm*>(box), static_cast<vtkAlgorithm*>(strips) })
  {
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkGlyph3DMapper> glyphs;
    glyphs->SetInputData(points);
    glyphs->SetSourceConnection(source->GetOutputPort());
    glyphs->SetScaleArray("scale");
    glyphs->SetScaleModeToScaleByVectorComponents();
    std::vector<double> expected;
    for (const double side : { 1., -1. })
    {
      for (vtkMapper* each : { static_cast<vtkMapper*>(mapper), static_cast<vtkMapper*>(glyphs) })
      {
        vtkNew<vtkActor> actor;
        actor->SetMapper(each);
        actor->SetScale(side, 1., 2.);
        actor->RotateZ(20.);
        renderer->AddActor(actor);
        expected.push_back(each == mapper ? 12. : 24.);
      }
    }
    vtkNew<vtkRelievoRayScene> scene;
    scene->SetRenderer(renderer);
    scene->Update();
    RELIEVO_CHECK(scene->GetNumberOfMeshes() == 4);
    for (int i = 0; i < scene->GetNumberOfMeshes(); ++i)
    {
      vtkNew<vtkPolyData> copy;
      scene->CopyMesh(i, copy);
      const auto prop = static_cast<std::size_t>(scene->GetMeshProp(i));
      RELIEVO_CHECK_NEAR(GetVolume(copy), expected[prop], 1e-5, "volume of a copy");
    }
  }
}

// A sheet of hills over a square, of triangles that do not cover each other from above.
vtkSmartPointer<vtkPolyData> MakeHills()
{
  constexpr int side = 9;
  const auto mesh = MakeMesh();
  for (int i = 0; i < side * side; ++i)
  {
    const int row = i / side;
    mesh->GetPoints()->InsertNextPoint((i - side * row) / 4. - 1., row / 4. - 1., Draw(-1., 1.));
  }
  for (vtkIdType i = 0; i < side * (side - 1); ++i)
  {
    if (i % side + 1 < side)
    {
      const vtkIdType ids[2][3] = { { i, i + 1, i + side }, { i + 1, i + side + 1, i + side } };
      mesh->GetPolys()->InsertNextCell(3, ids[0]);
      mesh->GetPolys()->InsertNextCell(3, ids[1]);
    }
  }
  return mesh;
}

// Matrices that flatten, whose last element is not 1, and of perspective; of actors and of data.
void TestMatrices()
{
  const auto hills = MakeHills();
  vtkNew<vtkTransform> flat;
  flat->Translate(30., 2., -1.);
  flat->RotateWXYZ(50., 1., 2., 3.);
  flat->Scale(2., 1., 0.);
  vtkNew<vtkTransform> skewed; // and so singular only up to rounding
  skewed->DeepCopy(flat);
  skewed->RotateWXYZ(1e-3, 3., 2., 1.);
  vtkNew<vtkMatrix4x4> scaled;
  scaled->SetElement(0, 3, 5.);
  scaled->SetElement(3, 3, 4.);
  vtkNew<vtkMatrix4x4> perspective;
  perspective->SetElement(3, 0, 0.2);
  perspective->SetElement(3, 2, -0.3);
  vtkMatrix4x4* const matrices[] = { flat->GetMatrix(), skewed->GetMatrix(), scaled, perspective };
  for (const bool isData : { false, true })
  {
    for (vtkMatrix4x4* matrix : matrices)
    {
      vtkNew<vtkRenderer> renderer;
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(hills);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->SetUserMatrix(matrix);
      vtkNew<vtkRelievoRayScene> scene;
      if (isData)
      {
        scene->AddData(hills, matrix);
      }
      else
      {
        renderer->AddActor(actor);
        scene->SetRenderer(renderer);
      }
      BruteRays truth;
      truth.Add(hills, 0, matrix);
      Rays rays;
      rays.AddThrough(truth.GetLow() - 0.1, truth.GetHigh() + 0.1, 300);
      Compare(scene, truth, rays, "a matrix of four kinds");
      RELIEVO_CHECK(!scene->Update() && scene->GetNumberOfPropsLeftOut() == 0);
      hills->GetPoints()->SetPoint(0, -1., -1., Draw(-1., 1.));
      hills->GetPoints()->Modified();
      RELIEVO_CHECK(scene->Update());
      vtkNew<vtkPolyData> copy;
      scene->CopyMesh(0, copy);
      double p[4] = { 0., 0., 0., 1. };
      hills->GetPoint(0, p);
      matrix->MultiplyPoint(p, p);
      glm::dvec3 copied;
      copy->GetPoint(0, &copied.x);
      RELIEVO_CHECK(glm::length(copied - glm::dvec3(p[0], p[1], p[2]) / p[3]) < 1e-13);
    }
  }
  // Geometry that a matrix moves behind infinity is left out, with a warning.
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(hills);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  perspective->SetElement(3, 0, 1.5);
  actor->SetUserMatrix(perspective);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRelievoRayScene> scene;
  scene->SetRenderer(renderer);
  relievoTest::ExpectMessage expect("matrices that");
  scene->Update();
  RELIEVO_CHECK(scene->GetNumberOfPropsLeftOut() == 1);
}

// Glyphs where their points are, in double, a million away; flat ones; and those of an actor that
// is flattened, by their points.
void TestGlyphs()
{
  const auto hills = MakeHills();
  for (const glm::dvec3& scale :
    { glm::dvec3(1.), glm::dvec3(1., 1., 0.), glm::dvec3(1., 2., 1e-3) })
  {
    for (const double height : { 1., 0. })
    {
      vtkNew<vtkPoints> places;
      places->SetDataTypeToDouble();
      vtkNew<vtkDoubleArray> scales;
      scales->SetName("scale");
      scales->SetNumberOfComponents(3);
      for (int i = 0; i < 5; ++i)
      {
        places->InsertNextPoint(4. * i, 1e6 + 0.3, 1e6 + Draw(-1., 1.));
        scales->InsertNextTuple(&scale.x);
      }
      vtkNew<vtkPolyData> points;
      points->SetPoints(places);
      points->GetPointData()->AddArray(scales);
      vtkNew<vtkGlyph3DMapper> mapper;
      mapper->SetInputData(points);
      mapper->SetSourceData(hills);
      mapper->SetScaleArray("scale");
      mapper->SetScaleModeToScaleByVectorComponents();
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      actor->SetScale(1., 1., height);
      actor->RotateX(20.);
      vtkNew<vtkRenderer> renderer;
      renderer->AddActor(actor);
      vtkNew<vtkRelievoRayScene> scene;
      scene->SetRenderer(renderer);
      BruteRays truth;
      for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
      {
        vtkNew<vtkMatrix4x4> matrix;
        for (int k = 0; k < 3; ++k)
        {
          matrix->SetElement(k, k, scale[k] == 0. ? 1e-10 : scale[k]); // VTK's
          matrix->SetElement(k, 3, places->GetPoint(i)[k]);
        }
        vtkMatrix4x4::Multiply4x4(actor->GetMatrix(), matrix, matrix);
        truth.Add(hills, 0, matrix, i);
      }
      Rays rays;
      rays.AddThrough(truth.GetLow() - 0.1, truth.GetHigh() + 0.1, 300);
      Compare(scene, truth, rays, "glyphs far away", 0., 1e300, 1e-8); // as far as it rounds
      vtkNew<vtkTable> hits;
      RELIEVO_CHECK(scene->FindNearest(rays.Origins, rays.Directions, hits));
      for (vtkIdType i = 0; i < hits->GetNumberOfRows(); ++i)
      {
        const double point = GetNumber(hits, "points", i);
        RELIEVO_CHECK(point < static_cast<double>(hills->GetNumberOfPoints()));
      }
    }
  }
}

// Data of other kinds than meshes, by their own cells and points; blocks by their flat index.
void TestData()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 5, 6);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(3);
  blocks->SetBlock(2, image);
  vtkNew<vtkRelievoRayScene> scene;
  scene->AddData(MakeSphere(glm::dvec3(50.), 8));
  RELIEVO_CHECK(scene->AddData(blocks) == 1);
  Rays rays;
  rays.Add(glm::dvec3(1.25, -3., 4.5), glm::dvec3(0., 1., 0.));
  rays.Add(glm::dvec3(1.25, 30., 4.5), glm::dvec3(0., -1., 0.));
  vtkNew<vtkTable> hits;
  RELIEVO_CHECK(scene->FindNearest(rays.Origins, rays.Directions, hits));
  for (int i = 0; i < 2; ++i)
  {
    RELIEVO_CHECK(GetNumber(hits, "prop", i) == 1. && GetNumber(hits, "block", i) == 3.);
    const double y = i == 0 ? 0. : 3.; // of 3 x 4 x 5 cells
    RELIEVO_CHECK_NEAR(GetNumber(hits, "cell", i), 1. + 3. * (y + 4. * 4.), 0., "cell");
    glm::dvec3 place(0.);
    for (int k = 0; k < 3; ++k)
    {
      glm::dvec3 corner;
      image->GetPoint(static_cast<vtkIdType>(GetNumber(hits, "points", i, k)), &corner.x);
      place += GetNumber(hits, "weights", i, k) * corner;
    }
    RELIEVO_CHECK(glm::length(place - GetVector(hits, "position", i)) < 1e-14);
    RELIEVO_CHECK(glm::length(place - glm::dvec3(1.25, i == 0 ? 0. : 4., 4.5)) < 1e-14);
  }
}

// Shaders follow rays in meshes of a limited size; rays on processors are not limited by it.
void TestLimitOfShaders()
{
  const vtkIdType most = vtkRelievoMeshTexels::GetMostTriangles();
  vtkRelievoMeshTexels::SetMostTriangles(1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeSphere(glm::dvec3(0.), 8));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRelievoRayScene> ofRenderer;
  ofRenderer->SetRenderer(renderer);
  vtkNew<vtkRelievoRayScene> ofData;
  ofData->AddData(MakeSphere(glm::dvec3(0.), 8));
  Rays rays;
  rays.Add(glm::dvec3(0., 0., -5.), glm::dvec3(0., 0., 1.));
  for (vtkRelievoRayScene* scene : { ofRenderer.Get(), ofData.Get() })
  {
    vtkNew<vtkTable> hits;
    RELIEVO_CHECK(scene->FindNearest(rays.Origins, rays.Directions, hits));
    RELIEVO_CHECK_NEAR(GetNumber(hits, "distance", 0), 4., 1e-12, "distance");
  }
  vtkRelievoMeshTexels::SetMostTriangles(most);
}

void TestRefusals()
{
  vtkNew<vtkRelievoRayScene> scene;
  vtkNew<vtkTable> hits;
  Rays rays;
  rays.Add(glm::dvec3(0., 0., -5.), glm::dvec3(0., 0., 1.));
  RELIEVO_CHECK(scene->FindNearest(rays.Origins, rays.Directions, hits)); // nothing there
  RELIEVO_CHECK(hits->GetNumberOfRows() == 1 && std::isinf(GetNumber(hits, "distance", 0)));
  Rays none;
  RELIEVO_CHECK(scene->FindNearest(none.Origins, none.Directions, hits));
  RELIEVO_CHECK(hits->GetNumberOfRows() == 0);
  scene->AddData(MakeSphere(glm::dvec3(0.), 8));
  {
    relievoTest::ExpectMessage expect("2 of 3 rays are not finite or have no direction");
    rays.Add(glm::dvec3(0., 0., -5.), glm::dvec3(0.));
    rays.Add(glm::dvec3(0., 0., -5.), glm::dvec3(0., vtkMath::Nan(), 1.));
    RELIEVO_CHECK(scene->FindNearest(rays.Origins, rays.Directions, hits));
    RELIEVO_CHECK_NEAR(GetNumber(hits, "distance", 0), 4., 1e-12, "distance");
    RELIEVO_CHECK(std::isinf(GetNumber(hits, "distance", 1)));
    RELIEVO_CHECK(std::isinf(GetNumber(hits, "distance", 2)));
  }
  {
    relievoTest::ExpectMessage expect("got 2 origins and 3 directions");
    rays.Origins->RemoveLastTuple();
    RELIEVO_CHECK(!scene->FindNearest(rays.Origins, rays.Directions, hits));
    RELIEVO_CHECK(hits->GetNumberOfRows() == 0);
  }
  {
    relievoTest::ExpectMessage expect("components, expected 3");
    vtkNew<vtkDoubleArray> flat;
    flat->SetNumberOfComponents(2);
    RELIEVO_CHECK(!scene->FindNearest(rays.Origins, flat, hits));
  }
  {
    relievoTest::ExpectMessage expect("got a matrix that is not finite, or maps points");
    vtkNew<vtkMatrix4x4> behind;
    behind->SetElement(3, 3, 0.5);
    behind->SetElement(3, 0, 1.);
    scene->AddData(MakeSphere(glm::dvec3(0.), 8), behind);
    RELIEVO_CHECK(!scene->FindNearest(rays.Origins, rays.Origins, hits));
    scene->RemoveAllData();
  }
  {
    relievoTest::ExpectMessage expect("expected a vtkDataSet");
    RELIEVO_CHECK(scene->AddData(vtkNew<vtkTable>()) == -1);
  }
  // Ended at the second of its reports.
  scene->AddData(MakeSphere(glm::dvec3(0.), 8));
  Rays many;
  many.AddThrough(glm::dvec3(-1.), glm::dvec3(1.), 200000);
  vtkNew<vtkCallbackCommand> watch;
  std::vector<double> reports;
  watch->SetClientData(&reports);
  watch->SetCallback([](vtkObject* caller, unsigned long, void* own, void* done) {
    auto* all = static_cast<std::vector<double>*>(own);
    all->push_back(*static_cast<double*>(done));
    static_cast<vtkRelievoRayScene*>(caller)->SetAbort(all->size() == 2);
  });
  scene->AddObserver(vtkCommand::ProgressEvent, watch);
  RELIEVO_CHECK(!scene->FindNearest(many.Origins, many.Directions, hits));
  RELIEVO_CHECK(reports.size() == 2 && reports[0] > 0. && reports[1] > reports[0]);
  RELIEVO_CHECK(reports.back() < 1. && hits->GetNumberOfRows() == 0);
  RELIEVO_CHECK(scene->FindNearest(many.Origins, many.Directions, hits) && reports.back() == 1.);
}

// A tree is refused before it is built if its arrays exceed the address space that is left, and
// built where they fit.
void TestMemory()
{
  constexpr int Side = 400;
  constexpr double Triangles = 2. * Side * Side;
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(Side, Side);
  vtkNew<vtkTriangleFilter> cut;
  cut->SetInputConnection(plane->GetOutputPort());
  cut->Update();
  vtkNew<vtkRelievoRayScene> small, scene;
  small->AddData(MakeSphere(glm::dvec3(0.), 8));
  scene->AddData(cut->GetOutput());
  Rays down;
  down.Add(glm::dvec3(0.1, 0.2, 1.), glm::dvec3(0., 0., -1.));
  vtkNew<vtkUnsignedCharArray> hit;
  RELIEVO_CHECK(small->FindAny(down.Origins, down.Directions, hit)); // threads have their stacks
  bool done = true;
  {
    // 45 bytes for each triangle and 24 for each of 401 x 401 points.
    relievoTest::ExpectMessage expect(
      "no tree for rays at 320000 triangles: it would take 18259224 bytes (17.4 MiB), and the "
      "machine has 16000000 bytes");
    const relievoTest::AddressLimit limit(50. * Triangles);
    done = scene->FindAny(down.Origins, down.Directions, hit);
  }
  RELIEVO_CHECK(!done && scene->GetNumberOfTriangles() == 0);
  if (!relievoTest::AddressLimit::IsUsable)
  {
    return; // the refusal above needs no memory
  }
  {
    const relievoTest::AddressLimit limit(78. * Triangles);
    done = scene->FindAny(down.Origins, down.Directions, hit);
  }
  RELIEVO_CHECK(done && hit->GetValue(0) == 1);
  RELIEVO_CHECK(scene->GetNumberOfTriangles() == static_cast<vtkIdType>(Triangles));
}
}

//------------------------------------------------------------------------------
// Small boxes far closer together than the steps of the grid on which the whole is sorted, beside
// one that is far away: a query reads the leaves around it, and each box is in one leaf.
void TestCluster()
{
  constexpr int Side = 128;
  constexpr double Size = 1e-4;
  std::vector<vtkRelievoWideTree::Box> boxes;
  std::mt19937 lots(5);
  std::vector<int> places(Side * Side);
  std::iota(places.begin(), places.end(), 0);
  std::shuffle(places.begin(), places.end(), lots);
  const auto make = [](int i, int k) {
    const glm::dvec3 low(0.7 + Size * i / Side, -0.3 + Size * k / Side, 0.2);
    return vtkRelievoWideTree::Box{ glm::vec3(low), glm::vec3(low + 0.9 * Size / Side) };
  };
  for (const int place : places)
  {
    boxes.push_back(make(place % Side, place / Side));
  }
  boxes.push_back({ glm::vec3(-1.f), glm::vec3(-0.99f) });
  vtkRelievoWideTree tree;
  tree.Build(boxes, 4);
  std::vector<int> order = tree.GetOrder();
  std::sort(order.begin(), order.end());
  std::vector<int> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  RELIEVO_CHECK(order == all);
  int leaves = 0;
  int full = 0;
  int found = 0;
  tree.FindOverlaps({ glm::vec3(-2.f), glm::vec3(2.f) }, [&](int, int count) {
    ++leaves;
    full += count == 4 ? 1 : 0;
    return true;
  });
  RELIEVO_CHECK(leaves == Side * Side / 4 + 1 && full == leaves - 1);
  leaves = 0;
  const vtkRelievoWideTree::Box middle = make(Side / 2, Side / 2);
  tree.FindOverlaps(middle, [&](int first, int count) {
    ++leaves;
    for (int k = first; k < first + count; ++k)
    {
      const vtkRelievoWideTree::Box& box = boxes[tree.GetOrder()[k]];
      found += box.Min == middle.Min ? 1 : 0;
    }
    return true;
  });
  std::cout << "a query of the cluster reads " << leaves << " leaves\n";
  RELIEVO_CHECK(found == 1 && leaves <= 8);
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testRays)
{
  relievoTest::Session session;
  TestTriangle();
  TestBunny();
  TestMesh(MakeSoup(2000, false), 400, "soup");
  TestMesh(MakeSoup(2000, true), 400, "soup with faults");
  TestMesh(MakeSlivers(1000), 1000, "slivers");
  TestMesh(MakeSphere(glm::dvec3(1e6, -1e6, 1e6), 20), 1000, "a million away");
  TestCluster();
  TestWatertight();
  TestMoves();
  TestConcave();
  TestRenderer();
  TestMirrored();
  TestMatrices();
  TestGlyphs();
  TestData();
  TestLimitOfShaders();
  TestRefusals();
#ifdef __linux__
  TestMemory();
#endif
  return session.Result();
}
}
