// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies that overlap, and grids that a body surrounds.
#include "Check.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "VoxelCells.h"

#include <vtkAppendPolyData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTransform.h>
#include <vtkTransformFilter.h>

namespace testVoxelShellOverlap
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoVoxelShell;

// Bodies that overlap: by parity, cells in both are outside, bit for bit; views see the union.
void TestOverlap()
{
  const Solid ball = MakeBall(1e-3, Turn({ 1., 0.3, 0.2 }, 37.));
  vtkNew<vtkTransform> transform;
  transform->Translate(0.31, 0.17, 0.05);
  vtkNew<vtkTransformFilter> moved;
  moved->SetInputData(ball.Mesh);
  moved->SetTransform(transform);
  moved->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  moved->Update();
  vtkNew<vtkAppendPolyData> both;
  both->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  both->AddInputData(ball.Mesh);
  both->AddInputData(moved->GetPolyDataOutput());
  both->Update();
  const Cells one = CellsOf(ball.Mesh);
  const Cells other = CellsOf(moved->GetPolyDataOutput());
  vtkNew<Filter> filter;
  filter->SetInputData(both->GetOutput());
  SetGrid(filter);
  const Cells parity = CellsOf(filter);
  RELIEVO_CHECK(filter->IsClosed());
  const Cells views = CellsOf(both->GetOutput(), Filter::SIX_VIEWS);
  int mismatches = 0;
  int missed = 0;
  int overlap = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    mismatches += parity[i] != (one[i] ^ other[i]) ? 1 : 0;
    missed += (one[i] | other[i]) && !views[i] ? 1 : 0;
    overlap += one[i] & other[i];
  }
  RELIEVO_CHECK(overlap > 4000);
  RELIEVO_CHECK_AT_MOST(mismatches, 0., "cells that are not in one of two bodies");
  RELIEVO_CHECK_AT_MOST(missed, 0., "cells of two bodies that views miss");
}

// A grid within the body, which no view gets outside of: all of it is inside, and none of a hollow.
void TestWithin()
{
  for (const double half : { 0.5, 0.25 })
  {
    const Solid solid = half > 0.3 ? MakeBall() : MakeHollowBall();
    for (const int method : { Filter::TWO_VIEWS, Filter::SIX_VIEWS, Filter::PARITY })
    {
      vtkNew<Filter> filter;
      filter->SetInputData(solid.Mesh);
      filter->SetMethod(method);
      filter->SetBounds(-half, half, -half, half, -half, half);
      filter->SetDimensions(16, 16, 16);
      CellsOf(filter);
      const bool hollow = half < 0.3 && method == Filter::PARITY;
      RELIEVO_CHECK(filter->GetNumberOfCellsInside() == (hollow ? 0 : 4096));
    }
  }
}
}

RELIEVO_TEST_CASE(testVoxelShellOverlap)
{
  relievoTest::Session session;
  TestOverlap();
  TestWithin();
  return session.Result();
}
}
