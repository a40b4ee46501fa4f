// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells inside bodies that have a formula: parity against the formula, two and six views against
// the same views of the formula, excess of views, distances, and the number of threads.
#include "Check.h"
#include "Session.h"
#include "Solids.h"
#include "TestCase.h"
#include "vtkRelievoVoxelShell.h"

#include <vtkCellData.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>
#include <vtkUnsignedCharArray.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace testVoxelShell
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoVoxelShell;

vtkUnsignedCharArray* Mask(vtkImageData* image)
{
  return vtkUnsignedCharArray::SafeDownCast(image->GetCellData()->GetArray("mask"));
}

vtkImageData* Run(Filter* filter, vtkPolyData* mesh, int method)
{
  filter->SetInputData(mesh);
  filter->SetMethod(method);
  filter->SetBounds(-1.5, 1.5, -1.45, 1.55, -1.52, 1.48);
  filter->SetDimensions(60, 50, 70);
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  return filter->GetOutput();
}

glm::dvec3 CenterOf(vtkImageData* image, int i, int j, int k)
{
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  return { origin[0] + (i + 0.5) * spacing[0], origin[1] + (j + 0.5) * spacing[1],
    origin[2] + (k + 0.5) * spacing[2] };
}

std::vector<Solid> Solids()
{
  const glm::dmat3 tilted = Turn({ 1., 0.3, 0.2 }, 37.);
  return { MakeBall(), MakeTorus(), MakeTorus(1e-3, tilted), MakeHollowBall(), MakeBowl(),
    MakeBowl(1e-3, tilted), MakeBox(), MakeBox(tilted) };
}

// The beginning and end of the body along an axis through a position, by steps along the formula as
// seen from either side; the triangles' error is left undecided.
struct Span
{
  double First = std::numeric_limits<double>::infinity();
  double Last = -std::numeric_limits<double>::infinity();
};

// The span of a body grown by this much.
Span SpanAt(const Solid& solid, glm::dvec3 place, int axis, double grown)
{
  Span span;
  const auto march = [&](double from, double direction) {
    double at = from;
    while (at * direction < 2.)
    {
      place[axis] = at;
      const double distance = solid.DistanceAt(place) - grown;
      if (distance <= 0.)
      {
        break;
      }
      at += direction * std::max(distance, 1e-5);
    }
    return at;
  };
  span.First = march(-2., 1.);
  if (span.First < 2.)
  {
    span.Last = march(2., -1.);
  }
  return span;
}

// Cells of the views whose verdict is sure: 1 or 0; 2 where the chord of triangles decides.
int SeenTruth(const Solid& solid, const glm::dvec3& center, const std::vector<int>& axes)
{
  bool sure = true;
  for (const int axis : axes)
  {
    const Span wide = SpanAt(solid, center, axis, 1.5 * solid.Chord + 1e-4);
    if (!(center[axis] >= wide.First && center[axis] <= wide.Last))
    {
      return 0;
    }
    const Span narrow = SpanAt(solid, center, axis, -1.5 * solid.Chord - 1e-4);
    sure = sure && center[axis] >= narrow.First && center[axis] <= narrow.Last;
  }
  return sure ? 1 : 2;
}

void TestParity()
{
  for (const Solid& solid : Solids())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      vtkNew<Filter> filter;
      filter->SetAxis(axis);
      vtkImageData* image = Run(filter, solid.Mesh, Filter::PARITY);
      RELIEVO_CHECK(filter->IsClosed());
      RELIEVO_CHECK(filter->GetNumberOfOpenColumns(axis) == 0);
      const vtkIdType columns[3] = { 50 * 70, 60 * 70, 60 * 50 };
      RELIEVO_CHECK(filter->GetNumberOfColumns(axis) == columns[axis]);
      int mismatches = 0;
      int near = 0;
      vtkIdType cell = 0;
      vtkIdType inside = 0;
      for (int k = 0; k < 70; ++k)
      {
        for (int j = 0; j < 50; ++j)
        {
          for (int i = 0; i < 60; ++i, ++cell)
          {
            const double distance = solid.DistanceAt(CenterOf(image, i, j, k));
            const bool is = Mask(image)->GetValue(cell) == 1;
            inside += is ? 1 : 0;
            const bool decided = std::abs(distance) > solid.Chord + 1e-12;
            near += decided ? 0 : 1;
            mismatches += decided && is != (distance < 0.) ? 1 : 0;
          }
        }
      }
      RELIEVO_CHECK_AT_MOST(mismatches, 0., solid.Name + ": wrong cells");
      RELIEVO_CHECK_AT_MOST(near, 0.01 * 60 * 50 * 70, solid.Name + ": undecided cells");
      RELIEVO_CHECK(filter->GetNumberOfCellsInside() == inside);
    }
  }
}

void TestViews()
{
  for (const Solid& solid : Solids())
  {
    for (const int method : { Filter::TWO_VIEWS, Filter::SIX_VIEWS })
    {
      vtkNew<Filter> filter;
      vtkImageData* image = Run(filter, solid.Mesh, method);
      const std::vector<int> axes =
        method == Filter::TWO_VIEWS ? std::vector<int>{ 2 } : std::vector<int>{ 0, 1, 2 };
      int mismatches = 0;
      int unsure = 0;
      int cells = 0;
      // Some of them: the march takes its time.
      for (int k = 1; k < 70; k += 2)
      {
        for (int j = 0; j < 50; j += 3)
        {
          for (int i = 0; i < 60; ++i)
          {
            const int truth = SeenTruth(solid, CenterOf(image, i, j, k), axes);
            ++cells;
            unsure += truth == 2 ? 1 : 0;
            const vtkIdType cell = (static_cast<vtkIdType>(k) * 50 + j) * 60 + i;
            mismatches += truth != 2 && Mask(image)->GetValue(cell) != truth ? 1 : 0;
          }
        }
      }
      RELIEVO_CHECK_AT_MOST(mismatches, 0., solid.Name + ": cells other than seen");
      RELIEVO_CHECK_AT_MOST(unsure, 0.02 * cells, solid.Name + ": undecided cells");
    }
  }
}

// The excess documented in docs/voxels.md.
void TestExcess()
{
  struct Case
  {
    Solid Body;
    double Two;
    double Six;
  };
  const glm::dmat3 onEdge = Turn({ 1., 0., 0. }, 90.);
  const glm::dmat3 tilted = Turn({ 1., 1., 0. }, 30.);
  // Slices of the torus on edge are rings, seen as discs. The bowl's have no short formula: they
  // are those of the filter, whose cells TestViews compares with views of the formula.
  const double torus =
    (0.8 - glm::pi<double>() * 0.16 + 4. / 3. * 0.064) / (2. * glm::pi<double>() * 0.16);
  const Case cases[] = { { MakeBall(), 0., 0. }, { MakeTorus(1e-3, onEdge), torus, 0. },
    { MakeHollowBall(), 1. / 7., 1. / 7. }, { MakeBowl(1e-3, tilted), 0.061, 0.011 } };
  for (const Case& each : cases)
  {
    double inside[3];
    for (const int method : { Filter::TWO_VIEWS, Filter::SIX_VIEWS, Filter::PARITY })
    {
      vtkNew<Filter> filter;
      filter->SetInputData(each.Body.Mesh);
      filter->SetMethod(method);
      filter->SetCellSize(0.02);
      filter->Update();
      inside[method] = static_cast<double>(filter->GetNumberOfCellsInside());
    }
    const double two = inside[0] / inside[2] - 1.;
    const double six = inside[1] / inside[2] - 1.;
    std::printf("%s: excess of two views %.1f %%, of six %.1f %%\n", each.Body.Name.c_str(),
      100. * two, 100. * six);
    RELIEVO_CHECK_NEAR(two, each.Two, 0.004, each.Body.Name + ": excess of two views");
    RELIEVO_CHECK_NEAR(six, each.Six, 0.004, each.Body.Name + ": excess of six views");
    RELIEVO_CHECK_NEAR(inside[2] * 8e-6 / each.Body.Volume, 1., 3e-3, each.Body.Name + ": volume");
    RELIEVO_CHECK(six <= two && inside[2] <= inside[1]); // solid cells are never missed
  }
}

void TestDistances()
{
  const Solid torus = MakeTorus(1e-4);
  vtkNew<Filter> filter;
  filter->DistancesOn();
  vtkImageData* image = Run(filter, torus.Mesh, Filter::SIX_VIEWS);
  auto* front = vtkFloatArray::SafeDownCast(image->GetCellData()->GetArray("front"));
  auto* back = vtkFloatArray::SafeDownCast(image->GetCellData()->GetArray("back"));
  RELIEVO_CHECK(front && back && front->GetNumberOfComponents() == 3);
  // Along z, in the plane y = 0 or near: the tube's own height.
  double largest = 0.;
  int compared = 0;
  for (int j = 0; j < 50; ++j)
  {
    for (int i = 0; i < 60; ++i)
    {
      const int k = 12;
      const glm::dvec3 center = CenterOf(image, i, j, k);
      const double across = std::hypot(center.x, center.y) - 1.;
      const vtkIdType cell = (static_cast<vtkIdType>(k) * 50 + j) * 60 + i;
      if (std::abs(across) < 0.3)
      {
        const double height = std::sqrt(0.16 - across * across);
        largest = std::max(largest, std::abs(front->GetComponent(cell, 2) - (center.z + height)));
        largest = std::max(largest, std::abs(back->GetComponent(cell, 2) - (height - center.z)));
        ++compared;
      }
      else if (std::abs(across) > 0.41)
      {
        RELIEVO_CHECK(std::isnan(front->GetComponent(cell, 2)));
      }
    }
  }
  RELIEVO_CHECK(compared > 300);
  RELIEVO_CHECK_AT_MOST(largest, 3e-4, "distance along z");
  // Parity has them along its axis.
  image = Run(filter, torus.Mesh, Filter::PARITY);
  RELIEVO_CHECK(image->GetCellData()->GetArray("front")->GetNumberOfComponents() == 1);
}

void TestThreads()
{
  const Solid bowl = MakeBowl(1e-4, Turn({ 1., 0.3, 0.2 }, 37.));
  for (const int method : { Filter::TWO_VIEWS, Filter::SIX_VIEWS, Filter::PARITY })
  {
    vtkNew<Filter> one;
    vtkSMPTools::Initialize(1);
    vtkImageData* alone = Run(one, bowl.Mesh, method);
    vtkNew<Filter> many;
    vtkSMPTools::Initialize(7);
    vtkImageData* together = Run(many, bowl.Mesh, method);
    vtkSMPTools::Initialize(0);
    const unsigned char* a = Mask(alone)->GetPointer(0);
    RELIEVO_CHECK(
      std::equal(a, a + Mask(alone)->GetNumberOfValues(), Mask(together)->GetPointer(0)));
  }
}

void TestFieldData()
{
  vtkNew<Filter> filter;
  vtkImageData* image = Run(filter, MakeBall().Mesh, Filter::PARITY);
  vtkFieldData* fields = image->GetFieldData();
  RELIEVO_CHECK(fields->GetArray("inside")->GetTuple1(0) ==
    static_cast<double>(filter->GetNumberOfCellsInside()));
  RELIEVO_CHECK(fields->GetArray("closed")->GetTuple1(0) == 1.);
  RELIEVO_CHECK(fields->GetArray("columns")->GetComponent(0, 2) == 60. * 50.);
  RELIEVO_CHECK(fields->GetArray("open_columns")->GetComponent(0, 2) == 0.);
  RELIEVO_CHECK_THAT(
    filter->GetReport().find("; the surface is closed; open along z: 0 of 3000 columns") !=
      std::string::npos,
    filter->GetReport());
  RELIEVO_CHECK(fields->GetAbstractArray("report") != nullptr);
}
}

RELIEVO_TEST_CASE(testVoxelShell)
{
  relievoTest::Session session;
  TestParity();
  TestViews();
  TestExcess();
  TestDistances();
  TestThreads();
  TestFieldData();
  return session.Result();
}
}
