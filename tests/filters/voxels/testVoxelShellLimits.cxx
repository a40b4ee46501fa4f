// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces whose inside is hard to tell: holes, sheets, degenerate triangles, points that are not
// finite; soups, strips, grids, composites, ghosts; and moving surfaces.
#include "Check.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "VoxelCells.h"

#include <vtkAppendFilter.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>
#include <vtkTransform.h>
#include <vtkTransformFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace testVoxelShellLimits
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoVoxelShell;

// Without some of its triangles.
vtkSmartPointer<vtkPolyData> Punch(vtkPolyData* mesh, vtkIdType first, vtkIdType count)
{
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    if (i < first || i >= first + count)
    {
      cells->InsertNextCell(ids);
    }
  }
  auto punched = vtkSmartPointer<vtkPolyData>::New();
  punched->SetPoints(mesh->GetPoints());
  punched->SetPolys(cells);
  return punched;
}

void TestHoles()
{
  const Solid torus = MakeTorus(1e-3, Turn({ 1., 0.3, 0.2 }, 37.));
  const Cells whole = CellsOf(torus.Mesh);
  const auto inside = static_cast<double>(std::count(whole.begin(), whole.end(), 1));
  const vtkIdType triangles = torus.Mesh->GetNumberOfPolys();
  vtkNew<Filter> filter;
  filter->SetInputData(Punch(torus.Mesh, triangles / 3, 40));
  SetGrid(filter);
  const Cells holed = CellsOf(filter);
  RELIEVO_CHECK(!filter->IsClosed());
  RELIEVO_CHECK(filter->GetNumberOfOpenColumns(0) + filter->GetNumberOfOpenColumns(1) +
      filter->GetNumberOfOpenColumns(2) >
    0);
  RELIEVO_CHECK(filter->GetNumberOfColumns(0) == 1600);
  RELIEVO_CHECK_THAT(
    filter->GetReport().find("the surface is open; open along x: ") != std::string::npos,
    filter->GetReport());
  RELIEVO_CHECK_AT_MOST(static_cast<double>(Differences(whole, holed)) / inside, 0.002,
    "cells that a hole changes, share of those inside");
  // A hole between columns is one as well.
  filter->SetInputData(Punch(torus.Mesh, triangles / 2, 1));
  const Cells pricked = CellsOf(filter);
  RELIEVO_CHECK(!filter->IsClosed());
  RELIEVO_CHECK_AT_MOST(static_cast<double>(Differences(whole, pricked)), 2., "cells of a prick");
  // Half a ball, open along z: seen from x and y it has an even number of crossings.
  const Solid ball = MakeBall();
  filter->SetInputData(Punch(ball.Mesh, 0, ball.Mesh->GetNumberOfPolys() / 2));
  CellsOf(filter);
  RELIEVO_CHECK(!filter->IsClosed());
  RELIEVO_CHECK(filter->GetNumberOfOpenColumns(2) > 300);
}

void TestSheets()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1., -1., 0.03);
  plane->SetPoint1(1., -0.9, 0.2);
  plane->SetPoint2(-0.8, 1., 0.1);
  plane->SetResolution(7, 5);
  plane->Update();
  vtkNew<Filter> filter;
  filter->SetInputData(plane->GetOutput());
  SetGrid(filter);
  Cells cells = CellsOf(filter);
  RELIEVO_CHECK(std::count(cells.begin(), cells.end(), 1) == 0);
  RELIEVO_CHECK(!filter->IsClosed() && filter->GetNumberOfOpenColumns(2) > 500);
  for (const int method : { Filter::TWO_VIEWS, Filter::SIX_VIEWS })
  {
    cells = CellsOf(plane->GetOutput(), method);
    RELIEVO_CHECK(std::count(cells.begin(), cells.end(), 1) == 0);
  }
  // Twice the same sheet encloses nothing.
  vtkPolyData* mesh = plane->GetOutput();
  vtkNew<vtkPolyData> both;
  both->SetPoints(mesh->GetPoints());
  vtkNew<vtkCellArray> polys;
  polys->Append(mesh->GetPolys());
  polys->Append(mesh->GetPolys());
  both->SetPolys(polys);
  filter->SetInputData(both);
  cells = CellsOf(filter);
  RELIEVO_CHECK(filter->IsClosed());
  RELIEVO_CHECK(std::count(cells.begin(), cells.end(), 1) == 0);
}

// A surface without triangles is not closed.
void TestNoSurface()
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkPolyData> line;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1., 0., 0.);
  points->InsertNextPoint(1., 1., 0.5);
  line->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  line->SetLines(cells);
  for (vtkPolyData* mesh : { nothing.Get(), line.Get() })
  {
    vtkNew<Filter> filter;
    filter->SetInputData(mesh);
    SetGrid(filter);
    const Cells found = CellsOf(filter);
    RELIEVO_CHECK(std::count(found.begin(), found.end(), 1) == 0);
    RELIEVO_CHECK(!filter->IsClosed());
    RELIEVO_CHECK_THAT(
      filter->GetReport().find("; there is no surface") != std::string::npos, filter->GetReport());
  }
}

void TestOddTriangles()
{
  const Solid torus = MakeTorus(1e-3, Turn({ 1., 0.3, 0.2 }, 37.));
  const Cells whole = CellsOf(torus.Mesh);
  // Triangles of a point, of an edge, with a point on their own edge; points that are not finite.
  vtkNew<vtkPolyData> odd;
  odd->DeepCopy(torus.Mesh);
  vtkPoints* points = odd->GetPoints();
  vtkCellArray* cells = odd->GetPolys();
  vtkNew<vtkIdList> ids;
  cells->GetCellAtId(11, ids);
  const vtkIdType a = ids->GetId(0);
  const vtkIdType b = ids->GetId(1);
  double pa[3];
  double pb[3];
  points->GetPoint(a, pa);
  points->GetPoint(b, pb);
  const vtkIdType middle =
    points->InsertNextPoint((pa[0] + pb[0]) / 2., (pa[1] + pb[1]) / 2., (pa[2] + pb[2]) / 2.);
  // The edge a b is cut on one side by a triangle without area, which keeps all closed.
  const vtkIdType c = ids->GetId(2);
  odd->SetPolys(Punch(odd, 11, 1)->GetPolys());
  cells = odd->GetPolys();
  cells->InsertNextCell({ a, middle, c });
  cells->InsertNextCell({ middle, b, c });
  cells->InsertNextCell({ a, b, middle });
  cells->InsertNextCell({ a, a, a });
  cells->InsertNextCell({ a, b, b });
  cells->InsertNextCell({ a, b }); // a polygon of two points
  const vtkIdType nan = points->InsertNextPoint(std::nan(""), 0., 0.);
  cells->InsertNextCell({ a, b, nan });
  vtkNew<Filter> filter;
  filter->SetInputData(odd);
  SetGrid(filter);
  RELIEVO_CHECK(Differences(whole, CellsOf(filter)) == 0);
  RELIEVO_CHECK(filter->IsClosed());
  RELIEVO_CHECK_THAT(
    filter->GetReport().find("left out: 1 triangles") != std::string::npos, filter->GetReport());
  // Bounds come from the points that are finite.
  vtkNew<Filter> automatic;
  automatic->SetInputData(odd);
  CellsOf(automatic);
  RELIEVO_CHECK(automatic->GetNumberOfCellsInside() > 10000);
}

void TestKindsOfData()
{
  const Solid torus = MakeTorus(1e-3, Turn({ 1., 0.3, 0.2 }, 37.));
  const Cells whole = CellsOf(torus.Mesh);
  // A soup: each triangle with points of its own.
  vtkNew<vtkPoints> soupPoints;
  soupPoints->SetDataTypeToDouble();
  vtkNew<vtkCellArray> soupCells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < torus.Mesh->GetNumberOfPolys(); ++i)
  {
    torus.Mesh->GetPolys()->GetCellAtId(i, ids);
    soupCells->InsertNextCell(3);
    for (int p = 0; p < 3; ++p)
    {
      soupCells->InsertCellPoint(soupPoints->InsertNextPoint(torus.Mesh->GetPoint(ids->GetId(p))));
    }
  }
  vtkNew<vtkPolyData> soup;
  soup->SetPoints(soupPoints);
  soup->SetPolys(soupCells);
  RELIEVO_CHECK(Differences(whole, CellsOf(soup)) == 0);

  vtkNew<vtkStripper> strips;
  strips->SetInputData(torus.Mesh);
  strips->Update();
  RELIEVO_CHECK(strips->GetOutput()->GetNumberOfStrips() > 0);
  RELIEVO_CHECK(Differences(whole, CellsOf(strips->GetOutput())) == 0);

  vtkNew<vtkAppendFilter> grid;
  grid->SetInputData(torus.Mesh);
  grid->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  grid->Update();
  RELIEVO_CHECK(Differences(whole, CellsOf(grid->GetOutput())) == 0);

  // Blocks: the torus in two halves, and an empty one.
  const vtkIdType half = torus.Mesh->GetNumberOfPolys() / 2;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Punch(torus.Mesh, 0, half));
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, Punch(torus.Mesh, half, torus.Mesh->GetNumberOfPolys()));
  RELIEVO_CHECK(Differences(whole, CellsOf(blocks)) == 0);

  // A second copy that is a ghost.
  vtkNew<vtkPolyData> ghosts;
  ghosts->SetPoints(torus.Mesh->GetPoints());
  vtkNew<vtkCellArray> polys;
  polys->Append(torus.Mesh->GetPolys());
  polys->Append(torus.Mesh->GetPolys());
  ghosts->SetPolys(polys);
  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType i = 0; i < 4 * half; ++i)
  {
    flags->InsertNextValue(i < 2 * half ? 0 : vtkDataSetAttributes::DUPLICATECELL);
  }
  ghosts->GetCellData()->AddArray(flags);
  RELIEVO_CHECK(Differences(whole, CellsOf(ghosts)) == 0);
}

// A prism over the shape of a U, of the area 7 of 9, with caps of one polygon each.
void TestConcavePolygons()
{
  const double shape[8][2] = { { 0., 0. }, { 3., 0. }, { 3., 3. }, { 2., 3. }, { 2., 1. },
    { 1., 1. }, { 1., 3. }, { 0., 3. } };
  for (int first = 0; first < 8; ++first)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkIdList> bottom;
    vtkNew<vtkIdList> top;
    for (int i = 0; i < 8; ++i)
    {
      const double* place = shape[(first + i) % 8];
      points->InsertNextPoint(place[0], place[1], 0.);
      points->InsertNextPoint(place[0] + 0.02, place[1] + 0.01, 1.003);
      bottom->InsertNextId(2 * (7 - i));
      top->InsertNextId(2 * i + 1);
      const vtkIdType next = 2 * ((i + 1) % 8);
      cells->InsertNextCell({ 2 * i, next, next + 1, 2 * i + 1 });
    }
    cells->InsertNextCell(bottom);
    cells->InsertNextCell(top);
    vtkNew<vtkPolyData> prism;
    prism->SetPoints(points);
    prism->SetPolys(cells);
    vtkNew<Filter> filter;
    filter->SetInputData(prism);
    filter->SetBounds(-0.1, 3.1, -0.1, 3.1, -0.1, 1.1);
    filter->SetCellSize(0.05);
    for (const int method : { Filter::TWO_VIEWS, Filter::SIX_VIEWS, Filter::PARITY })
    {
      filter->SetMethod(method);
      CellsOf(filter);
      RELIEVO_CHECK(filter->IsClosed());
      RELIEVO_CHECK_NEAR(static_cast<double>(filter->GetNumberOfCellsInside()) * 0.05 * 0.05 * 0.05,
        7. * 1.003, 0.15, "volume of a prism");
    }
  }
}

void TestMoving()
{
  const Solid box = MakeBox(Turn({ 1., 0.3, 0.2 }, 37.));
  vtkNew<vtkTransform> transform;
  vtkNew<vtkTransformFilter> moved;
  moved->SetInputData(box.Mesh);
  moved->SetTransform(transform);
  vtkNew<Filter> filter;
  filter->SetInputConnection(moved->GetOutputPort());
  SetGrid(filter);
  const double step = 3. / 40.;
  const Cells before = CellsOf(filter);
  transform->Translate(4. * step, 0., 0.);
  const Cells after = CellsOf(filter);
  int mismatches = 0;
  for (int row = 0; row < 1600; ++row)
  {
    for (int i = 4; i < 40; ++i)
    {
      const auto cell = static_cast<std::size_t>(row * 40 + i);
      mismatches += after[cell] != before[cell - 4] ? 1 : 0;
    }
  }
  RELIEVO_CHECK_AT_MOST(mismatches, 0., "cells that did not move along");
  transform->Translate(100., 0., 0.);
  const Cells gone = CellsOf(filter);
  RELIEVO_CHECK(std::count(gone.begin(), gone.end(), 1) == 0);
  transform->Identity();
  RELIEVO_CHECK(CellsOf(filter) == before);
  // Without bounds of its own, the grid follows.
  filter->SetBounds(1., -1., 1., -1., 1., -1.);
  const Cells fitted = CellsOf(filter);
  transform->Translate(1000., 0., 0.);
  RELIEVO_CHECK(Differences(fitted, CellsOf(filter)) <= 2);
  RELIEVO_CHECK(filter->GetOutput()->GetOrigin()[0] > 990.);
}
}

RELIEVO_TEST_CASE(testVoxelShellLimits)
{
  relievoTest::Session session;
  TestHoles();
  TestSheets();
  TestNoSurface();
  TestOddTriangles();
  TestKindsOfData();
  TestConcavePolygons();
  TestMoving();
  return session.Result();
}
}
