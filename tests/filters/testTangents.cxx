// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tangents of a plane, a sphere and a torus compared with their formulas; mirrored halves are split
// and correct on both sides; triangles without texture area, flat meshes, passed data, messages.
#include "Check.h"
#include "Refusal.h"
#include "Session.h"
#include "Surfaces.h"
#include "TestCase.h"
#include "vtkRelievoTangents.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace testTangents
{
namespace
{
using namespace relievoTest;

const double NaN = std::nan("");

glm::dvec3 Tuple3(vtkDataArray* array, vtkIdType i)
{
  return glm::dvec3(
    array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2));
}

double Degrees(const glm::dvec3& a, const glm::dvec3& b)
{
  return 57.295779513082320877 * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

vtkSmartPointer<vtkPolyData> Run(vtkRelievoTangents* filter, vtkPolyData* mesh)
{
  filter->SetInputData(mesh);
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  return filter->GetOutput();
}

// Unit tangents across unit normals, w 1 or -1, at all points but those of no triangle.
void CheckFrames(vtkPolyData* mesh, const std::string& name, int unused = 0)
{
  vtkDataArray* tangents = mesh->GetPointData()->GetArray("tangent");
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  double worst = 0.;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const glm::dvec3 t = Tuple3(tangents, i);
    const double w = tangents->GetComponent(i, 3);
    if (t == glm::dvec3(0.) && w == 0.)
    {
      --unused;
      continue;
    }
    worst = std::max({ worst, std::abs(glm::length(t) - 1.), std::abs(std::abs(w) - 1.),
      std::abs(glm::dot(t, Tuple3(normals, i))) });
  }
  RELIEVO_CHECK_AT_MOST(worst, 1e-6, name + ": off length 1, the normal's plane, or w 1 or -1");
  RELIEVO_CHECK(unused == 0);
}

struct Errors
{
  double Mean, Worst;
};

// Degrees between tangents and truth; the poles, which have none, are left out.
Errors ErrorsOf(vtkPolyData* mesh, double w)
{
  Errors errors = { 0., 0. };
  int count = 0;
  vtkDataArray* tangents = mesh->GetPointData()->GetArray("tangent");
  vtkDataArray* truth = mesh->GetPointData()->GetArray("truth");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double v = mesh->GetPointData()->GetTCoords()->GetComponent(i, 1);
    const bool pole = v == 0. || v == 1.;
    if (Tuple3(tangents, i) != glm::dvec3(0.) && !pole)
    {
      const double degrees = Degrees(Tuple3(tangents, i), Tuple3(truth, i));
      errors.Mean += degrees;
      errors.Worst = std::max(errors.Worst, degrees);
      ++count;
      RELIEVO_CHECK(tangents->GetComponent(i, 3) == w);
    }
  }
  RELIEVO_CHECK(count > 10);
  errors.Mean /= count;
  return errors;
}

void TestSurfaces()
{
  vtkNew<vtkRelievoTangents> filter;
  const vtkSmartPointer<vtkPolyData> flat = Run(filter, MakeSurface(PlanePoint, 7, 5));
  RELIEVO_CHECK_AT_MOST(ErrorsOf(flat, 1.).Worst, 1e-6, "plane, degrees");
  RELIEVO_CHECK(filter->GetNumberOfAddedPoints() == 0);
  const struct
  {
    const char* Name;
    Surface Make;
    int Unused; // the corners of the poles' row that no triangle has
  } cases[] = { { "sphere", SpherePoint, 2 }, { "torus", TorusPoint, 0 } };
  for (const auto& one : cases)
  {
    double last = 0.;
    for (const int rows : { 32, 64, 128 })
    {
      const vtkSmartPointer<vtkPolyData> mesh = Run(filter, MakeSurface(one.Make, 2 * rows, rows));
      const std::string name = one.Name + std::string(", ") + std::to_string(rows) + " rows";
      CheckFrames(mesh, name, one.Unused);
      const Errors errors = ErrorsOf(mesh, 1.);
      RELIEVO_CHECK_AT_MOST(errors.Mean, 60. / (rows * rows), name + ": mean degrees");
      RELIEVO_CHECK(last == 0. || errors.Mean < 0.3 * last);
      last = errors.Mean;
    }
  }
}

// u = 1 - |2 u - 1|: the second half of a torus has the first half's texture, mirrored.
void TestMirrored()
{
  const vtkSmartPointer<vtkPolyData> mesh = MakeSurface(TorusPoint, 64, 32);
  vtkDataArray* texture = mesh->GetPointData()->GetTCoords();
  vtkDataArray* truth = mesh->GetPointData()->GetArray("truth");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    texture->SetComponent(i, 0, 1. - std::abs(2. * (i % 65) / 64. - 1.));
  }
  vtkNew<vtkRelievoTangents> filter;
  const vtkSmartPointer<vtkPolyData> split = Run(filter, mesh);
  CheckFrames(split, "mirrored torus");
  // The points of the middle ring are two now. At the ends they were two before.
  RELIEVO_CHECK(filter->GetNumberOfAddedPoints() == 33);
  vtkDataArray* tangents = split->GetPointData()->GetArray("tangent");
  vtkDataArray* originals = split->GetPointData()->GetArray("vtkOriginalPointIds");
  double worst = 0.;
  double worstSeam = 0.;
  int wrongSides = 0;
  for (vtkIdType cell = 0; cell < split->GetNumberOfPolys(); ++cell)
  {
    vtkNew<vtkIdList> corners;
    split->GetPolys()->GetCellAtId(cell, corners);
    vtkNew<vtkIdList> before;
    mesh->GetPolys()->GetCellAtId(cell, before);
    for (int c = 0; c < 3; ++c)
    {
      const vtkIdType point = corners->GetId(c);
      RELIEVO_CHECK(originals->GetComponent(point, 0) == before->GetId(c));
      const double side = cell % 128 >= 64 ? -1. : 1.;
      const double degrees =
        Degrees(Tuple3(tangents, point), side * Tuple3(truth, before->GetId(c)));
      const bool seam = before->GetId(c) % 65 % 32 == 0;
      (seam ? worstSeam : worst) = std::max(seam ? worstSeam : worst, degrees);
      wrongSides += tangents->GetComponent(point, 3) == side ? 0 : 1;
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 0.12, "mirrored torus, inside, degrees");
  // At a seam triangles of one side tell: half a step of 360 / 64 degrees.
  RELIEVO_CHECK_AT_MOST(worstSeam, 2.8126, "mirrored torus, at the seams, degrees");
  RELIEVO_CHECK_AT_MOST(wrongSides, 0, "mirrored torus, corners of the wrong handedness");
}

void TestArraysPass()
{
  const vtkSmartPointer<vtkPolyData> mesh = MakeSurface(TorusPoint, 16, 8);
  vtkDataArray* texture = mesh->GetPointData()->GetTCoords();
  vtkNew<vtkDoubleArray> pressure;
  pressure->SetName("pressure");
  vtkNew<vtkDoubleArray> quality;
  quality->SetName("quality");
  const vtkIdType some[] = { 0, 5, 9 };
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(3, some);
  mesh->SetLines(lines);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    texture->SetComponent(i, 0, std::abs(2. * (i % 17) / 16. - 1.));
    pressure->InsertNextValue(1e-3 * double(i));
  }
  const vtkIdType lonely = mesh->GetPoints()->InsertNextPoint(9., 9., 9.);
  mesh->GetPointData()->GetNormals()->InsertNextTuple3(0., 0., 1.);
  texture->InsertNextTuple2(0., 0.);
  mesh->GetPointData()->GetArray("truth")->InsertNextTuple3(1., 0., 0.);
  pressure->InsertNextValue(7.);
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    quality->InsertNextValue(double(i));
  }
  mesh->GetPointData()->SetScalars(pressure);
  mesh->GetCellData()->AddArray(quality);
  vtkNew<vtkRelievoTangents> filter;
  filter->SetTangentsName("T");
  const vtkSmartPointer<vtkPolyData> split = Run(filter, mesh);
  RELIEVO_CHECK(split->GetNumberOfPoints() > mesh->GetNumberOfPoints());
  RELIEVO_CHECK(split->GetNumberOfCells() == mesh->GetNumberOfCells());
  RELIEVO_CHECK(split->GetNumberOfLines() == 1);
  RELIEVO_CHECK(split->GetCellData()->GetArray("quality")->GetComponent(40, 0) == 40.);
  RELIEVO_CHECK(split->GetPointData()->GetArray("T")->GetNumberOfComponents() == 4);
  RELIEVO_CHECK(split->GetPointData()->GetScalars() != nullptr);
  RELIEVO_CHECK(split->GetPoints()->GetDataType() == VTK_DOUBLE);
  RELIEVO_CHECK(Tuple3(split->GetPointData()->GetArray("T"), lonely) == glm::dvec3(0.));
  vtkDataArray* originals = split->GetPointData()->GetArray("vtkOriginalPointIds");
  int mismatches = 0;
  for (vtkIdType i = 0; i < split->GetNumberOfPoints(); ++i)
  {
    const auto from = static_cast<vtkIdType>(originals->GetComponent(i, 0));
    mismatches += i < mesh->GetNumberOfPoints() && from != i ? 1 : 0;
    double a[3];
    double b[3];
    split->GetPoint(i, a);
    mesh->GetPoint(from, b);
    mismatches += std::equal(a, a + 3, b) ? 0 : 1;
    for (const char* name : { "pressure", "Normals", "TCoords", "truth" })
    {
      vtkDataArray* to = split->GetPointData()->GetArray(name);
      for (int c = 0; c < to->GetNumberOfComponents(); ++c)
      {
        mismatches +=
          to->GetComponent(i, c) == mesh->GetPointData()->GetArray(name)->GetComponent(from, c) ? 0
                                                                                                : 1;
      }
    }
  }
  RELIEVO_CHECK_AT_MOST(mismatches, 0, "values that are not those of the point before");
}

// Triangles without texture area, of one kind after the other, in a plane: they take their
// neighbours' tangents and, without any, a vector across the normal.
void TestDegenerate()
{
  const auto plane = []() { return MakeSurface(PlanePoint, 8, 8); };
  const vtkSmartPointer<vtkPolyData> strip = plane();
  for (vtkIdType i = 0; i < 9; ++i)
  {
    strip->GetPointData()->GetTCoords()->SetComponent(9 + i, 1, 0.); // as the row below
  }
  const vtkSmartPointer<vtkPolyData> holes = plane();
  holes->GetPointData()->GetTCoords()->SetComponent(40, 0, NaN);
  holes->GetPointData()->GetTCoords()->SetComponent(20, 1, NaN);
  for (const auto& mesh : { strip, holes })
  {
    vtkNew<vtkRelievoTangents> filter;
    const vtkSmartPointer<vtkPolyData> output = Run(filter, mesh);
    CheckFrames(output, "some without texture area");
    RELIEVO_CHECK(filter->GetNumberOfDegenerateTriangles() == (mesh == strip ? 16 : 12));
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const glm::dvec3 t = Tuple3(output->GetPointData()->GetArray("tangent"), i);
      const bool alone = mesh == holes && (i == 40 || i == 20);
      RELIEVO_CHECK(alone || glm::length(t - glm::dvec3(1., 0., 0.)) < 1e-6);
    }
  }
  // All of them, far from each other in the texture or not at all apart; and lines as triangles.
  for (const double value : { 0., 0.37, 1e6 })
  {
    const vtkSmartPointer<vtkPolyData> mesh = MakeSurface(SpherePoint, 16, 8);
    mesh->GetPointData()->GetTCoords()->FillComponent(0, value);
    mesh->GetPointData()->GetTCoords()->FillComponent(1, -value);
    vtkNew<vtkRelievoTangents> filter;
    CheckFrames(Run(filter, mesh), "constant texture coordinates", 2);
    RELIEVO_CHECK(filter->GetNumberOfDegenerateTriangles() == mesh->GetNumberOfPolys());
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      mesh->GetPointData()->GetTCoords()->SetTuple2(i, 0.1 * double(i), 0.3 * double(i) + value);
    }
    mesh->Modified();
    CheckFrames(Run(filter, mesh), "texture coordinates in a line", 2);
    RELIEVO_CHECK(filter->GetNumberOfDegenerateTriangles() == mesh->GetNumberOfPolys());
  }
  // Normals that are none, places that are none: still finite, still unit where they can be.
  const vtkSmartPointer<vtkPolyData> broken = plane();
  broken->GetPointData()->GetNormals()->SetTuple3(30, 0., 0., 0.);
  broken->GetPointData()->GetNormals()->SetTuple3(50, NaN, 0., 1.);
  broken->GetPoints()->SetPoint(10, NaN, 0., 0.);
  vtkNew<vtkRelievoTangents> filter;
  const vtkSmartPointer<vtkPolyData> output = Run(filter, broken);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const glm::dvec3 t = Tuple3(output->GetPointData()->GetArray("tangent"), i);
    RELIEVO_CHECK(std::abs(glm::length(t) - 1.) < 1e-6);
  }
}

// A cube without point normals is flat: 24 points, tangents in the faces, with given normals too.
void TestFlat()
{
  for (const bool given : { false, true })
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> texture;
    texture->SetNumberOfComponents(2);
    for (int i = 0; i < 8; ++i)
    {
      points->InsertNextPoint(i & 1, i >> 1 & 1, i >> 2);
      texture->InsertNextTuple2((i & 1) + 0.1 * (i >> 2), (i >> 1 & 1) + 0.2 * (i >> 2));
    }
    const vtkIdType quads[6][4] = { { 1, 3, 7, 5 }, { 0, 4, 6, 2 }, { 2, 6, 7, 3 }, { 0, 1, 5, 4 },
      { 4, 5, 7, 6 }, { 0, 2, 3, 1 } };
    vtkNew<vtkCellArray> polys;
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (int q = 0; q < 6; ++q)
    {
      const double sign = q % 2 ? -1. : 1.;
      for (const int last : { 2, 3 })
      {
        const vtkIdType triangle[3] = { quads[q][0], quads[q][last - 1], quads[q][last] };
        polys->InsertNextCell(3, triangle);
        normals->InsertNextTuple3(
          q / 2 == 0 ? sign : 0., q / 2 == 1 ? sign : 0., q / 2 == 2 ? sign : 0.);
      }
    }
    vtkNew<vtkPolyData> cube;
    cube->SetPoints(points);
    cube->SetPolys(polys);
    cube->GetPointData()->SetTCoords(texture);
    if (given)
    {
      cube->GetCellData()->SetNormals(normals);
    }
    vtkNew<vtkRelievoTangents> filter;
    const vtkSmartPointer<vtkPolyData> output = Run(filter, cube);
    RELIEVO_CHECK(output->GetNumberOfPoints() == 24);
    RELIEVO_CHECK(filter->GetNumberOfAddedPoints() == 16);
    CheckFrames(output, "flat cube");
    for (vtkIdType cell = 0; cell < 12; ++cell)
    {
      vtkNew<vtkIdList> corners;
      output->GetPolys()->GetCellAtId(cell, corners);
      const glm::dvec3 normal = Tuple3(output->GetPointData()->GetNormals(), corners->GetId(0));
      RELIEVO_CHECK(glm::length(normal - Tuple3(normals, cell)) < 1e-6);
    }
  }
}

template <typename Spoil>
void MustRefuse(const std::string& words, Spoil spoil)
{
  const vtkSmartPointer<vtkPolyData> mesh = MakeSurface(PlanePoint, 4, 4);
  spoil(mesh.Get());
  vtkNew<vtkRelievoTangents> filter;
  filter->SetInputData(mesh);
  CheckRefused(filter.Get(), words);
}

void TestRefusals()
{
  MustRefuse("needs texture coordinates",
    [](vtkPolyData* mesh) { mesh->GetPointData()->RemoveArray("TCoords"); });
  MustRefuse(
    "its point arrays are: none", [](vtkPolyData* mesh) { mesh->GetPointData()->Initialize(); });
  MustRefuse("triangulate them first", [](vtkPolyData* mesh) {
    const vtkIdType quad[] = { 0, 1, 6, 5 };
    mesh->GetPolys()->InsertNextCell(4, quad);
  });
  MustRefuse("triangle strips", [](vtkPolyData* mesh) {
    const vtkIdType strip[] = { 0, 1, 5, 6 };
    vtkNew<vtkCellArray> strips;
    strips->InsertNextCell(4, strip);
    mesh->SetStrips(strips);
  });
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkRelievoTangents> filter;
  RELIEVO_CHECK(Run(filter, empty)->GetNumberOfPoints() == 0);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testTangents)
{
  Session session;
  TestSurfaces();
  TestMirrored();
  TestArraysPass();
  TestDegenerate();
  TestFlat();
  TestRefusals();
  return session.Result();
}
}
