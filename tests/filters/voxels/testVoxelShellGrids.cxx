// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Grids: by size, by dimensions, of one row, flat, within the body, empty, too large; and from
// depth images of other resolutions, or that do not fit.
#include "Check.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "VoxelCells.h"

#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

namespace testVoxelShellGrids
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoVoxelShell;

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
  filter->SetMemoryLimit(1073741824.);
  {
    relievoTest::ExpectMessage expect("1000 x 1000 x 1000 cells are asked for; it would take 1");
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1);
    RELIEVO_CHECK_THAT(expect.Messages()[0].find("and MemoryLimit is 1073741824 bytes (1.0 GiB)") !=
        std::string::npos,
      expect.Messages()[0]);
    RELIEVO_CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
  }
  filter->SetMemoryLimit(0.);
  {
    relievoTest::ExpectMessage expect("and the machine has ");
    filter->SetCellSize(1e-9);
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  {
    relievoTest::ExpectMessage expect("at most 2147483646 along an axis");
    filter->SetMemoryLimit(VTK_DOUBLE_MAX);
    // The last size is below the smallest divisor of a double.
    for (const double size : { 1e-10, 1e-300, 1e-320 })
    {
      filter->SetCellSize(size);
      filter->Update();
    }
    filter->SetDimensions(1, 1, 2147483647);
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 4);
  }
  filter->SetDimensions(5, 5, 5);
  RELIEVO_CHECK(CellsOf(filter).size() == 125);
}

void TestInfinite()
{
  const Solid ball = MakeBall();
  const double inf = std::numeric_limits<double>::infinity();
  const double boxes[4][6] = { { -2., inf, -2., 2., -2., 2. }, { -1e308, 1e308, -1., 1., -1., 1. },
    { -inf, inf, -inf, inf, -inf, inf }, { -2., 2., -inf, 2., -2., 2. } };
  for (const auto& box : boxes)
  {
    for (const int count : { 0, 10 })
    {
      vtkNew<Filter> filter;
      filter->SetInputData(ball.Mesh);
      filter->SetBounds(box);
      filter->SetDimensions(count, count, count);
      relievoTest::ExpectMessage expect("expected finite numbers");
      filter->Update();
      RELIEVO_CHECK(expect.Count() == 1 && filter->GetErrorCode() == vtkErrorCode::UserError);
      RELIEVO_CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
    }
  }
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
    int mismatches = 0;
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
          mismatches += std::abs(distance) > 1.5 * texel && cells[cell] != (distance < 0.) ? 1 : 0;
        }
      }
    }
    RELIEVO_CHECK_AT_MOST(mismatches, 0., "wrong cells, texels: " + std::to_string(size));
    RELIEVO_CHECK(std::count(cells.begin(), cells.end(), 1) > 5000);
    RELIEVO_CHECK_THAT(
      filter->GetReport().rfind("6 views, along x y z", 0) == 0, filter->GetReport());
    // Three axes have distances of 8 bytes per cell, whatever Method says.
    filter->DistancesOn();
    filter->SetMemoryLimit(25. * 64000.);
    relievoTest::ExpectMessage expect("40 x 40 x 40 cells are asked for; it would take 1");
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1);
    filter->SetMemoryLimit(60. * 64000.);
    CellsOf(filter);
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
  refused(front, front, true, "depth image 1: there is one already from below along y");
  refused(front, DepthOfBall(2, 1, 64), true, "along y there is a depth image from below only");
  refused(front, DepthOfBall(1, -1, 64, true), true, "does not look along x, y or z in parallel");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 1);
  refused(front, bare, true, "depth image 1: it has no layer 'depth'");
}
}

RELIEVO_TEST_CASE(testVoxelShellGrids)
{
  relievoTest::Session session;
  TestGrids();
  TestEmpty();
  TestTooLarge();
  TestInfinite();
  TestDepthImages();
  return session.Result();
}
}
