// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where cells inside a surface are hard to tell: holes, sheets, degenerate triangles, points that
// are not finite, soups, strips, composites, moving surfaces, odd grids, depth images that do not
// fit; and grids that are too large.
#include "Check.h"
#include "Session.h"
#include "Solids.h"
#include "vtkRelievoVoxelShell.h"

#include <vtkAppendFilter.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
using namespace relievoTest;
using Filter = vtkRelievoVoxelShell;
using Cells = std::vector<unsigned char>;

Cells CellsOf(Filter* filter)
{
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  auto* mask =
    vtkUnsignedCharArray::SafeDownCast(filter->GetOutput()->GetCellData()->GetArray("mask"));
  const unsigned char* first = mask->GetPointer(0);
  return Cells(first, first + mask->GetNumberOfValues());
}

void SetGrid(Filter* filter, int count = 40)
{
  filter->SetBounds(-1.5, 1.5, -1.45, 1.55, -1.52, 1.48);
  filter->SetDimensions(count, count, count);
}

Cells CellsOf(vtkDataObject* data, int method = Filter::PARITY)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(data);
  filter->SetMethod(method);
  SetGrid(filter);
  return CellsOf(filter);
}

vtkIdType Differences(const Cells& a, const Cells& b)
{
  vtkIdType count = a.size() == b.size() ? 0 : 1000000;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
  {
    count += a[i] != b[i] ? 1 : 0;
  }
  return count;
}

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

void TestMoving()
{
  const Solid box = MakeBox(Turn({ 1., 0.3, 0.2 }, 37.));
  vtkNew<vtkTransform> transform;
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetInputData(box.Mesh);
  moved->SetTransform(transform);
  vtkNew<Filter> filter;
  filter->SetInputConnection(moved->GetOutputPort());
  SetGrid(filter);
  const double step = 3. / 40.;
  const Cells before = CellsOf(filter);
  transform->Translate(4. * step, 0., 0.);
  const Cells after = CellsOf(filter);
  int wrong = 0;
  for (int row = 0; row < 1600; ++row)
  {
    for (int i = 4; i < 40; ++i)
    {
      const auto cell = static_cast<std::size_t>(row * 40 + i);
      wrong += after[cell] != before[cell - 4] ? 1 : 0;
    }
  }
  RELIEVO_CHECK_AT_MOST(wrong, 0., "cells that did not move along");
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

void TestGrids()
{
  const Solid ball = MakeBall();
  vtkNew<Filter> filter;
  filter->SetInputData(ball.Mesh);
  CellsOf(filter);
  const int* points = filter->GetOutput()->GetDimensions();
  RELIEVO_CHECK(points[0] == 101 && points[1] == 101 && points[2] == 101);
  filter->SetCellSize(0.1);
  filter->SetPadding(3);
  CellsOf(filter);
  points = filter->GetOutput()->GetDimensions();
  RELIEVO_CHECK(points[0] == 27 && points[1] == 27 && points[2] == 27);
  RELIEVO_CHECK_NEAR(filter->GetOutput()->GetSpacing()[1], 0.1, 1e-12, "cell size");
  filter->SetPadding(0);
  // Cells in one row, along each axis; cells on the axis of the ball: the truth is its radius.
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int method : { Filter::TWO_VIEWS, Filter::SIX_VIEWS, Filter::PARITY })
    {
      int dimensions[3] = { 1, 1, 1 };
      dimensions[axis] = 1000;
      double bounds[6] = { -0.01, 0.011, -0.01, 0.011, -0.01, 0.011 };
      bounds[2 * axis] = -2.;
      bounds[2 * axis + 1] = 2.;
      filter->SetDimensions(dimensions);
      filter->SetBounds(bounds);
      filter->SetMethod(method);
      const Cells row = CellsOf(filter);
      for (std::size_t i = 0; i < row.size(); ++i)
      {
        const double place = -2. + (static_cast<double>(i) + 0.5) * 0.004;
        RELIEVO_CHECK(std::abs(std::abs(place) - 1.) < 2e-3 || row[i] == (std::abs(place) < 1.));
      }
    }
  }
  // Within the ball all is inside, also where the surface begins before the grid.
  filter->SetBounds(-0.1, 0.1, -0.1, 0.1, -0.1, 0.1);
  filter->SetDimensions(9, 9, 65);
  for (const int method : { Filter::TWO_VIEWS, Filter::SIX_VIEWS, Filter::PARITY })
  {
    filter->SetMethod(method);
    const Cells cells = CellsOf(filter);
    RELIEVO_CHECK(std::count(cells.begin(), cells.end(), 1) == 9 * 9 * 65);
  }
  // Flat, a point, far away, and all of no extent.
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  vtkNew<Filter> flat;
  flat->SetInputData(plane->GetOutput());
  CellsOf(flat);
  RELIEVO_CHECK(flat->GetOutput()->GetDimensions()[2] == 2);
  vtkNew<vtkPolyData> point;
  vtkNew<vtkPoints> one;
  one->InsertNextPoint(3., 4., 5.);
  point->SetPoints(one);
  flat->SetInputData(point);
  RELIEVO_CHECK(CellsOf(flat).size() == 1);
}

void TestEmpty()
{
  vtkNew<vtkPolyData> empty;
  vtkNew<Filter> filter;
  filter->SetInputData(empty);
  filter->DistancesOn();
  for (const int method : { Filter::TWO_VIEWS, Filter::SIX_VIEWS, Filter::PARITY })
  {
    filter->SetMethod(method);
    filter->SetBounds(1., -1., 1., -1., 1., -1.);
    RELIEVO_CHECK(CellsOf(filter).empty());
    RELIEVO_CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
    SetGrid(filter);
    const Cells cells = CellsOf(filter);
    RELIEVO_CHECK(cells.size() == 64000 && std::count(cells.begin(), cells.end(), 1) == 0);
  }
  vtkNew<Filter> alone;
  relievoTest::ExpectMessage expect("there is no input");
  alone->Update();
  RELIEVO_CHECK(expect.Count() == 1 && alone->GetErrorCode() == vtkErrorCode::UserError);
}

void TestTooLarge()
{
  const Solid ball = MakeBall();
  vtkNew<Filter> filter;
  filter->SetInputData(ball.Mesh);
  filter->SetResolution(1000);
  {
    relievoTest::ExpectMessage expect("1000 x 1000 x 1000 cells would take 1");
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1);
    RELIEVO_CHECK_THAT(
      expect.Messages()[0].find("bytes, more than MemoryLimit (1024 MiB)") != std::string::npos,
      expect.Messages()[0]);
    RELIEVO_CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  }
  {
    relievoTest::ExpectMessage expect("cells would take");
    filter->SetCellSize(1e-9);
    filter->Update();
    filter->SetCellSize(1e-300);
    filter->Update();
    filter->SetDimensions(2147483647, 2147483647, 2147483647);
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 3);
  }
  filter->SetDimensions(5, 5, 5);
  RELIEVO_CHECK(CellsOf(filter).size() == 125);
}

// A depth image of the ball from one side of an axis, at any resolution.
vtkSmartPointer<vtkImageData> DepthOfBall(int axis, int sign, int size, bool perspective = false)
{
  // Columns of the camera's axes: right, up, and towards the viewer.
  glm::dvec3 back(0.);
  back[axis] = -sign;
  glm::dvec3 up(0.);
  up[(axis + 1) % 3] = 1.;
  const glm::dvec3 right = glm::cross(up, back);
  const glm::dvec3 eye = back * 5.;
  double worldToCamera[16] = {};
  const glm::dvec3 rows[3] = { right, up, back };
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      worldToCamera[4 * r + c] = rows[r][c];
    }
    worldToCamera[4 * r + 3] = -glm::dot(rows[r], eye);
  }
  worldToCamera[15] = 1.;
  double worldToNDC[16];
  std::copy(worldToCamera, worldToCamera + 16, worldToNDC);
  for (int i = 0; i < 12; ++i)
  {
    worldToNDC[i] /= i < 8 ? 1.2 : -5.; // half the height of the view
  }
  if (perspective)
  {
    std::copy(worldToCamera + 8, worldToCamera + 12, worldToNDC + 12);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, 1);
  vtkNew<vtkFloatArray> depth;
  depth->SetName("depth");
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      const double u = ((x + 0.5) / size * 2. - 1.) * 1.2;
      const double v = ((y + 0.5) / size * 2. - 1.) * 1.2;
      const double rest = 1. - u * u - v * v;
      depth->InsertNextValue(rest > 0. ? static_cast<float>(5. - std::sqrt(rest))
                                       : std::numeric_limits<float>::infinity());
    }
  }
  image->GetPointData()->AddArray(depth);
  const auto addMatrix = [&](const char* name, const double* values) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (int i = 0; i < 16; ++i)
    {
      array->InsertNextValue(values[i]);
    }
    image->GetFieldData()->AddArray(array);
  };
  addMatrix("worldToCamera", worldToCamera);
  addMatrix("worldToNDC", worldToNDC);
  return image;
}

void TestDepthImages()
{
  // Texels finer than cells, about as fine, and coarser: cells are off by a texel at most.
  for (const int size : { 640, 64, 10 })
  {
    vtkNew<Filter> filter;
    vtkNew<vtkMultiBlockDataSet> sides;
    for (int axis = 0; axis < 3; ++axis)
    {
      sides->SetBlock(static_cast<unsigned int>(axis), DepthOfBall(axis, 1, size));
      filter->AddInputDataObject(1, DepthOfBall(axis, -1, size));
    }
    filter->AddInputDataObject(1, sides);
    SetGrid(filter);
    const Cells cells = CellsOf(filter);
    const double texel = 2.4 / size;
    int wrong = 0;
    std::size_t cell = 0;
    for (int k = 0; k < 40; ++k)
    {
      for (int j = 0; j < 40; ++j)
      {
        for (int i = 0; i < 40; ++i, ++cell)
        {
          const glm::dvec3 place(
            -1.5 + (i + 0.5) * 0.075, -1.45 + (j + 0.5) * 0.075, -1.52 + (k + 0.5) * 0.075);
          const double distance = glm::length(place) - 1.;
          wrong += std::abs(distance) > 1.5 * texel && cells[cell] != (distance < 0.) ? 1 : 0;
        }
      }
    }
    RELIEVO_CHECK_AT_MOST(wrong, 0., "wrong cells, texels: " + std::to_string(size));
    RELIEVO_CHECK(std::count(cells.begin(), cells.end(), 1) > 5000);
    RELIEVO_CHECK_THAT(
      filter->GetReport().rfind("6 views, along x y z", 0) == 0, filter->GetReport());
  }
  const auto refused = [](vtkImageData* a, vtkImageData* b, bool bounds, const char* words) {
    vtkNew<Filter> filter;
    filter->AddInputDataObject(1, a);
    filter->AddInputDataObject(1, b);
    if (bounds)
    {
      SetGrid(filter);
    }
    relievoTest::ExpectMessage expect(words);
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1 && filter->GetOutput()->GetNumberOfCells() == 0);
  };
  const auto front = DepthOfBall(1, 1, 64);
  const auto back = DepthOfBall(1, -1, 64);
  refused(front, back, false, "set Bounds");
  refused(front, front, true, "along y there is a depth image from below only");
  refused(front, DepthOfBall(1, -1, 64, true), true, "does not look along x, y or z in parallel");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 1);
  refused(front, bare, true, "depth image 1: it has no layer 'depth'");
}
}

int main()
{
  relievoTest::Session session;
  TestHoles();
  TestSheets();
  TestOddTriangles();
  TestKindsOfData();
  TestMoving();
  TestGrids();
  TestEmpty();
  TestTooLarge();
  TestDepthImages();
  return session.Result();
}
