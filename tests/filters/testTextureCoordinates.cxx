// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Texture coordinates of meshes without any: true lengths on planes and boxes, longitude and
// latitude on spheres, no triangle mirrored or torn over a seam, bounded stretch on a scanned mesh;
// tangents follow; small and odd meshes, messages.
#include "Check.h"
#include "Refusal.h"
#include "Session.h"
#include "Surfaces.h"
#include "TestCase.h"
#include "vtkRelievoOFFReader.h"
#include "vtkRelievoTangents.h"
#include "vtkRelievoTextureCoordinates.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace testTextureCoordinates
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoTextureCoordinates;

constexpr double Pi = 3.14159265358979323846;

vtkSmartPointer<vtkPolyData> Run(Filter* filter, vtkPolyData* mesh)
{
  filter->SetInputData(mesh);
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  return filter->GetOutput();
}

glm::dvec3 Point(vtkPolyData* mesh, vtkIdType i)
{
  double p[3];
  mesh->GetPoint(i, p);
  return glm::dvec3(p[0], p[1], p[2]);
}

glm::dvec2 Texture(vtkPolyData* mesh, vtkIdType i)
{
  vtkDataArray* texture = mesh->GetPointData()->GetTCoords();
  return glm::dvec2(texture->GetComponent(i, 0), texture->GetComponent(i, 1));
}

// The effect of a texture with one tile per unit on the triangles of a mesh.
struct Laid
{
  double LeastArea = 1e300; // of texture area over area
  double MostArea = 0.;
  double LongestEdge = 0.; // in the texture
  int Mirrored = 0;
};

Laid LaidOn(vtkPolyData* mesh)
{
  Laid laid;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkNew<vtkIdList> c;
    mesh->GetPolys()->GetCellAtId(cell, c);
    for (vtkIdType k = 1; k + 1 < c->GetNumberOfIds(); ++k)
    {
      const vtkIdType ids[3] = { c->GetId(0), c->GetId(k), c->GetId(k + 1) };
      const glm::dvec3 p0 = Point(mesh, ids[0]);
      const glm::dvec2 t0 = Texture(mesh, ids[0]);
      const glm::dvec2 a = Texture(mesh, ids[1]) - t0;
      const glm::dvec2 b = Texture(mesh, ids[2]) - t0;
      const double area =
        glm::length(glm::cross(Point(mesh, ids[1]) - p0, Point(mesh, ids[2]) - p0));
      const double inTexture = a.x * b.y - a.y * b.x;
      laid.LongestEdge =
        std::max({ laid.LongestEdge, glm::length(a), glm::length(b), glm::length(a - b) });
      if (area > 1e-12)
      {
        laid.Mirrored += inTexture < 0. ? 1 : 0;
        laid.LeastArea = std::min(laid.LeastArea, std::abs(inTexture) / area);
        laid.MostArea = std::max(laid.MostArea, std::abs(inTexture) / area);
      }
    }
  }
  return laid;
}

// A rectangle of 3 x 2, turned and far away: the texture must show it in true size.
void TestPlane()
{
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, -0.5, 0.7));
  const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(0., 0., 1.), normal));
  const glm::dvec3 v = glm::cross(normal, u);
  for (const double away : { 0., 1e6 })
  {
    const vtkSmartPointer<vtkPolyData> mesh = MakeSurface(
      [&](double s, double t) -> SurfacePoint {
        return { away + 3. * s * u + 2. * t * v, normal, u };
      },
      6, 4);
    vtkNew<Filter> filter;
    filter->SetMappingToPlane();
    filter->SetTileSize(0.5);
    const vtkSmartPointer<vtkPolyData> fitted = Run(filter, mesh);
    RELIEVO_CHECK(filter->GetNumberOfAddedPoints() == 0);
    const double scale = 3. / 0.5;
    double worst = 0.;
    for (vtkIdType i = 0; i < fitted->GetNumberOfPoints(); ++i)
    {
      const vtkIdType row = i / 7;
      const glm::dvec2 expected(scale * double(i % 7) / 6., double(row));
      worst = std::max(worst, glm::length(Texture(fitted, i) - expected));
    }
    RELIEVO_CHECK_AT_MOST(worst, away > 0. ? 2e-8 * scale * 10. : 1e-6, "fitted plane, tiles");
    filter->SetTileSize(0.);
    filter->SetPlaneNormal(2. * normal.x, 2. * normal.y, 2. * normal.z);
    const vtkSmartPointer<vtkPolyData> given = Run(filter, mesh);
    RELIEVO_CHECK_NEAR(Texture(given, 6).x, 1., 1e-6, "one tile along the longer way");
    RELIEVO_CHECK_NEAR(Texture(given, 34).y, 2. / 3., 1e-6, "its height");
    filter->SetPlaneNormal(-normal.x, -normal.y, -normal.z);
    RELIEVO_CHECK(LaidOn(Run(filter, mesh)).Mirrored == mesh->GetNumberOfPolys());
  }
  // Seen from +z: x to the right, y upwards; with x up, -y to the right.
  const vtkSmartPointer<vtkPolyData> flat = MakeSurface(PlanePoint, 4, 4);
  vtkNew<Filter> filter;
  filter->SetMappingToPlane();
  for (int up = 0; up < 3; ++up)
  {
    filter->SetUp(up);
    filter->SetPlaneNormal(0., 0., 1.);
    const vtkSmartPointer<vtkPolyData> mesh = Run(filter, flat);
    const glm::dvec2 corner = Texture(mesh, 4); // at (1, 0)
    RELIEVO_CHECK(glm::length(corner - (up == 0 ? glm::dvec2(1., 1.) : glm::dvec2(1., 0.))) < 1e-7);
    RELIEVO_CHECK(LaidOn(mesh).Mirrored == 0);
  }
}

// A box of quads: each side in true size, upright where it can be.
void TestBox()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const glm::dvec3 size(3., 2., 5.);
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(
      1e6 + size.x * (i & 1), -2e6 + size.y * (i >> 1 & 1), 7. + size.z * (i >> 2));
  }
  const vtkIdType quads[6][4] = { { 1, 3, 7, 5 }, { 0, 4, 6, 2 }, { 2, 6, 7, 3 }, { 0, 1, 5, 4 },
    { 4, 5, 7, 6 }, { 0, 2, 3, 1 } };
  vtkNew<vtkCellArray> polys;
  for (const auto& quad : quads)
  {
    polys->InsertNextCell(4, quad);
  }
  vtkNew<vtkPolyData> box;
  box->SetPoints(points);
  box->SetPolys(polys);
  for (int up = 0; up < 3; ++up)
  {
    vtkNew<Filter> filter;
    filter->SetTileSize(1.);
    filter->SetUp(up);
    const vtkSmartPointer<vtkPolyData> mesh = Run(filter, box);
    const Laid laid = LaidOn(mesh);
    RELIEVO_CHECK(laid.Mirrored == 0);
    RELIEVO_CHECK_NEAR(laid.LeastArea, 1., 1e-6, "box: texture area");
    RELIEVO_CHECK_NEAR(laid.MostArea, 1., 1e-6, "box: texture area");
    for (vtkIdType cell = 0; cell < 6; ++cell)
    {
      vtkNew<vtkIdList> c;
      mesh->GetPolys()->GetCellAtId(cell, c);
      glm::dvec2 least(1e9);
      for (int k = 0; k < 4; ++k)
      {
        least = glm::min(least, Texture(mesh, c->GetId(k)));
        if (cell / 2 != up)
        {
          // Height is v.
          const double height = Point(mesh, c->GetId(k))[up] - Point(box, 0)[up];
          RELIEVO_CHECK_NEAR(Texture(mesh, c->GetId(k)).y, height, 1e-6, "side: v");
        }
      }
      RELIEVO_CHECK(glm::length(least) < 1e-6); // each side begins at 0, 0
    }
    vtkNew<Filter> whole;
    RELIEVO_CHECK_NEAR(LaidOn(Run(whole, box)).LongestEdge, std::sqrt(34.) / 5., 1e-6,
      "one tile for the longest side");
  }
}

// Longitude and latitude of a sphere that is turned to each axis; seams and poles.
void TestSphere()
{
  for (int up = 0; up < 3; ++up)
  {
    // A sphere of columns that share their points: u = 0 and u = 1 are one.
    const vtkSmartPointer<vtkPolyData> mesh = MakeSurface(SpherePoint, 32, 16);
    vtkNew<vtkCellArray> shared;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
    {
      vtkNew<vtkIdList> c;
      mesh->GetPolys()->GetCellAtId(cell, c);
      vtkIdType corners[3];
      for (int k = 0; k < 3; ++k)
      {
        const vtkIdType id = c->GetId(k);
        const bool pole = id / 33 == 0 || id / 33 == 16;
        corners[k] = pole ? id / 33 * 33 : (id % 33 == 32 ? id - 32 : id);
      }
      shared->InsertNextCell(3, corners);
    }
    mesh->SetPolys(shared);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const glm::dvec3 p = 2. * Point(mesh, i);
      double turned[3];
      for (int c = 0; c < 3; ++c)
      {
        turned[(up + 1 + c) % 3] = p[c] + 10. * c;
      }
      mesh->GetPoints()->SetPoint(i, turned);
    }
    vtkNew<Filter> filter;
    filter->SetMappingToSphere();
    filter->SetUp(up);
    const vtkSmartPointer<vtkPolyData> laid = Run(filter, mesh);
    const Laid found = LaidOn(laid);
    RELIEVO_CHECK(found.Mirrored == 0);
    RELIEVO_CHECK_AT_MOST(found.LongestEdge, 0.08, "sphere: longest edge, tiles");
    RELIEVO_CHECK(filter->GetNumberOfAddedPoints() > 15);
    double worst = 0.;
    vtkDataArray* originals = laid->GetPointData()->GetArray("vtkOriginalPointIds");
    for (vtkIdType i = 0; i < laid->GetNumberOfPoints(); ++i)
    {
      const auto from = static_cast<vtkIdType>(originals->GetComponent(i, 0));
      const vtkIdType row = from / 33;
      if (row > 0 && row < 16 && from % 33 < 32)
      {
        // The seam lies opposite of the first axis, where this sphere has its middle column.
        const double u = double(from % 33) / 32. + 0.5;
        const glm::dvec2 texture = Texture(laid, i);
        const double turn = std::abs(texture.x - u);
        worst = std::max(
          { worst, std::min(turn, std::abs(turn - 1.)), std::abs(texture.y - double(row) / 16.) });
      }
    }
    RELIEVO_CHECK_AT_MOST(worst, 1e-6, "sphere: longitude and latitude");
    filter->SetTileSize(0.5); // radius 2: 8 pi tiles around, 25 whole ones; 13 up
    const vtkSmartPointer<vtkPolyData> tiled = Run(filter, mesh);
    double high = 0.;
    for (vtkIdType i = 0; i < tiled->GetNumberOfPoints(); ++i)
    {
      high = std::max(high, Texture(tiled, i).y);
    }
    RELIEVO_CHECK_NEAR(high, 13., 1e-5, "sphere: tiles from pole to pole");
    RELIEVO_CHECK(LaidOn(tiled).LongestEdge < 25. / 32. + 13. / 16.);
  }
}

// A scanned mesh: stretched no more than promised; no mesh is too odd.
void TestMeshes()
{
  vtkNew<vtkRelievoOFFReader> reader;
  reader->SetFileName(DataFile("bunny.off").c_str());
  reader->Update();
  vtkNew<Filter> filter;
  filter->SetTileSize(1.);
  const vtkSmartPointer<vtkPolyData> box = Run(filter, reader->GetOutput());
  const Laid laid = LaidOn(box);
  RELIEVO_CHECK(laid.Mirrored == 0);
  RELIEVO_CHECK_AT_MOST(1. / laid.LeastArea, std::sqrt(3.) + 1e-3, "bunny, box: stretch");
  RELIEVO_CHECK_AT_MOST(laid.MostArea, 1. + 1e-3, "bunny, box: largest texture area");
  const double added = double(filter->GetNumberOfAddedPoints()) / double(box->GetNumberOfPoints());
  RELIEVO_CHECK_AT_MOST(added, 0.2, "bunny, box: share of points that were added");
  vtkNew<vtkRelievoTangents> tangents;
  tangents->SetInputData(box);
  tangents->Update();
  vtkDataArray* array = tangents->GetOutput()->GetPointData()->GetArray("tangent");
  RELIEVO_CHECK(array && tangents->GetNumberOfDegenerateTriangles() == 0);
  int mirrored = 0;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    mirrored += array->GetComponent(i, 3) < 0. ? 1 : 0;
  }
  RELIEVO_CHECK_AT_MOST(mirrored, 0, "bunny, box: mirrored tangents");

  // One point; all in one place; a line; a polygon without area; lines and arrays besides.
  for (int kind = 0; kind < 4; ++kind)
  {
    for (const int mapping : { Filter::PLANE, Filter::BOX, Filter::SPHERE })
    {
      vtkNew<vtkPoints> points;
      vtkNew<vtkDoubleArray> values;
      values->SetName("values");
      for (int i = 0; i < 4; ++i)
      {
        points->InsertNextPoint(kind == 0 ? 0. : double(i), kind == 3 ? i * i : 0., 0.);
        values->InsertNextValue(i);
      }
      const vtkIdType ids[] = { 0, 1, 2, 3 };
      vtkNew<vtkCellArray> cells;
      cells->InsertNextCell(4, ids);
      vtkNew<vtkPolyData> mesh;
      mesh->SetPoints(points);
      (kind == 2 ? mesh->SetLines(cells) : mesh->SetPolys(cells));
      mesh->GetPointData()->AddArray(values);
      vtkNew<Filter> odd;
      odd->SetMapping(mapping);
      const vtkSmartPointer<vtkPolyData> output = Run(odd, mesh);
      RELIEVO_CHECK(output->GetNumberOfCells() == 1);
      vtkDataArray* originals = output->GetPointData()->GetArray("vtkOriginalPointIds");
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        const glm::dvec2 t = Texture(output, i);
        RELIEVO_CHECK(std::isfinite(t.x) && std::isfinite(t.y));
        RELIEVO_CHECK(output->GetPointData()->GetArray("values")->GetComponent(i, 0) ==
          originals->GetComponent(i, 0));
      }
    }
  }
  vtkNew<vtkPolyData> empty;
  RELIEVO_CHECK(Run(filter, empty)->GetNumberOfPoints() == 0);
  const vtkSmartPointer<vtkPolyData> strips = MakeSurface(PlanePoint, 2, 2);
  const vtkIdType strip[] = { 0, 1, 3, 4 };
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(4, strip);
  strips->SetStrips(cells);
  filter->SetInputData(strips);
  CheckRefused(filter.Get(), "triangle strips; triangulate them first");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testTextureCoordinates)
{
  Session session;
  TestPlane();
  TestBox();
  TestSphere();
  TestMeshes();
  return session.Result();
}
}
