// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth images of a plane and a sphere become the points that were seen, to the last digits of a
// double: both projections, off-centre windows, near the origin and at (5e5, 5e6, 0).
#include "Check.h"
#include "DepthImage.h"
#include "Refusal.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoDepthToPoints.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace testDepthToPoints
{
namespace
{
using namespace relievoTest;

const glm::dvec3 Origin(0.);
const glm::dvec3 FarAway(5e5, 5e6, 0.);

const DepthView Views[] = {
  { "perspective", Origin, false, { 0., 0. }, { 320, 240 } },
  { "parallel", Origin, true, { 0., 0. }, { 320, 240 } },
  { "off-centre perspective, odd size", Origin, false, { 0.3, -0.2 }, { 251, 333 } },
  { "off-centre parallel, odd size", Origin, true, { -0.25, 0.4 }, { 333, 251 } },
  { "perspective, far away", FarAway, false, { 0., 0. }, { 320, 240 } },
  { "parallel, far away", FarAway, true, { 0., 0. }, { 320, 240 } },
  { "off-centre perspective, far away", FarAway, false, { 0.3, -0.2 }, { 320, 240 } },
  { "one pixel", Origin, false, { 0., 0. }, { 1, 1 } },
};

// Largest distance between the filter's points and those seen.
double WorstDistance(const DepthView& view, const DepthImage& made, vtkPolyData* cloud)
{
  const vtkIdType count = static_cast<vtkIdType>(made.Positions.size());
  if (!RELIEVO_CHECK(cloud->GetNumberOfPoints() == count))
  {
    return std::numeric_limits<double>::infinity();
  }
  double worst = 0.;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    cloud->GetPoint(i, point);
    const glm::dvec3 relative = glm::dvec3(point[0], point[1], point[2]) - view.Center;
    worst = std::max(worst, glm::length(relative - made.Positions[i]));
  }
  return worst;
}

void TestViews()
{
  for (const DepthView& view : Views)
  {
    const DepthImage made = MakeDepthImage(view);
    RELIEVO_CHECK(!made.Positions.empty());
    vtkNew<vtkRelievoDepthToPoints> filter;
    filter->SetInputData(made.Image);
    filter->Update();
    vtkPolyData* cloud = filter->GetOutput();
    // A step of a double at 5e6 is 9.3e-10; matrices, their inverse and the sum take a few.
    const bool farAway = glm::length(view.Center) > 0.;
    RELIEVO_CHECK_AT_MOST(WorstDistance(view, made, cloud), farAway ? 5e-9 : 1e-13,
      std::string(view.Name) + ", distance from the truth");
    RELIEVO_CHECK(cloud->GetPoints()->GetDataType() == VTK_DOUBLE);
    RELIEVO_CHECK(cloud->GetNumberOfVerts() == cloud->GetNumberOfPoints());
    RELIEVO_CHECK(cloud->GetNumberOfCells() == cloud->GetNumberOfPoints());

    const DepthImage rounded = MakeDepthImage(view, true);
    filter->SetInputData(rounded.Image);
    filter->Update();
    // Half a step of a float depth below 16 is 4.8e-7; a window's corner ray is 1.3 times as long.
    RELIEVO_CHECK_AT_MOST(WorstDistance(view, rounded, filter->GetOutput()), 7e-7,
      std::string(view.Name) + ", float depth, distance from the truth");
  }
}

void TestArrays()
{
  const DepthImage made = MakeDepthImage(Views[0]);
  vtkNew<vtkRelievoDepthToPoints> filter;
  filter->SetInputData(made.Image);
  filter->Update();
  vtkPointData* from = made.Image->GetPointData();
  vtkPointData* to = filter->GetOutput()->GetPointData();
  RELIEVO_CHECK(to->GetNumberOfArrays() == 3);
  for (const char* name : { "depth", "id", "normal" })
  {
    vtkDataArray* given = from->GetArray(name);
    vtkDataArray* got = to->GetArray(name);
    if (!RELIEVO_CHECK_THAT(got && got->GetDataType() == given->GetDataType(), name))
    {
      continue;
    }
    RELIEVO_CHECK(got->GetNumberOfTuples() == static_cast<vtkIdType>(made.Pixels.size()));
    int mismatches = 0;
    for (vtkIdType i = 0; i < got->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < got->GetNumberOfComponents(); ++c)
      {
        mismatches += got->GetComponent(i, c) == given->GetComponent(made.Pixels[i], c) ? 0 : 1;
      }
    }
    RELIEVO_CHECK_THAT(mismatches == 0, std::string("values moved in ") + name);
  }
  RELIEVO_CHECK(filter->GetOutput()->GetFieldData()->GetArray("worldToNDC") != nullptr);
  filter->KeepArraysOff();
  filter->Update();
  RELIEVO_CHECK(filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0);
  RELIEVO_CHECK(
    filter->GetOutput()->GetNumberOfPoints() == static_cast<vtkIdType>(made.Positions.size()));
}

void TestStride()
{
  const DepthView& view = Views[2];
  const DepthImage made = MakeDepthImage(view);
  for (int stride : { 2, 7, 1000, VTK_INT_MAX })
  {
    vtkNew<vtkRelievoDepthToPoints> filter;
    filter->SetInputData(made.Image);
    filter->SetStride(stride);
    filter->Update();
    DepthImage part;
    for (std::size_t i = 0; i < made.Pixels.size(); ++i)
    {
      if (made.Pixels[i] % view.Size.x % stride == 0 && made.Pixels[i] / view.Size.x % stride == 0)
      {
        part.Positions.push_back(made.Positions[i]);
      }
    }
    RELIEVO_CHECK(WorstDistance(view, part, filter->GetOutput()) < 1e-13);
  }
  vtkNew<vtkRelievoDepthToPoints> filter;
  filter->SetStride(0);
  RELIEVO_CHECK(filter->GetStride() == 1);
}

void TestOtherName()
{
  const DepthImage made = MakeDepthImage(Views[0]);
  made.Image->GetPointData()->GetArray("depth")->SetName("z of the left eye");
  vtkNew<vtkRelievoDepthToPoints> filter;
  filter->SetInputData(made.Image);
  filter->SetDepthArrayName("z of the left eye");
  filter->Update();
  RELIEVO_CHECK(WorstDistance(Views[0], made, filter->GetOutput()) < 1e-13);
}

// NaN and both infinities are no places; an image of them gives no points and no error.
void TestNothingThere()
{
  DepthImage made = MakeDepthImage(Views[0]);
  vtkDataArray* depth = made.Image->GetPointData()->GetArray("depth");
  const double none[] = { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() };
  for (vtkIdType i = 0; i < depth->GetNumberOfTuples(); ++i)
  {
    depth->SetComponent(i, 0, none[i % 3]);
  }
  vtkNew<vtkRelievoDepthToPoints> filter;
  filter->SetInputData(made.Image);
  filter->Update();
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfCells() == 0);

  // No pixels at all, without arrays: the same, without a message.
  vtkNew<vtkImageData> empty;
  filter->SetInputData(empty);
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
}

// Runs the filter on an image that `spoil` has damaged; it must say `words` and give nothing.
template <typename Spoil>
void MustRefuse(const char* words, Spoil spoil)
{
  DepthImage made = MakeDepthImage(Views[0]);
  spoil(made.Image);
  vtkNew<vtkRelievoDepthToPoints> filter;
  filter->SetInputData(made.Image);
  CheckRefused(filter.Get(), words);
}

vtkDataArray* Field(vtkImageData* image, const char* name)
{
  return image->GetFieldData()->GetArray(name);
}

void TestRefusals()
{
  MustRefuse("'depth' (DepthArrayName) of one component, but its arrays are: id, normal",
    [](vtkImageData* image) { image->GetPointData()->RemoveArray("depth"); });
  MustRefuse("of one component, but its arrays are: none",
    [](vtkImageData* image) { image->GetPointData()->Initialize(); });
  MustRefuse("but it has 3", [](vtkImageData* image) {
    image->GetPointData()->RemoveArray("depth");
    image->GetPointData()->GetArray("normal")->SetName("depth");
  });
  MustRefuse("'worldToCamera' of 16 numbers (a 4 x 4 matrix, row by row), but its arrays are: "
             "worldToNDC",
    [](vtkImageData* image) { image->GetFieldData()->RemoveArray("worldToCamera"); });
  MustRefuse("'worldToNDC' of 16 numbers",
    [](vtkImageData* image) { image->GetFieldData()->RemoveArray("worldToNDC"); });
  MustRefuse("but it has 32 numbers", [](vtkImageData* image) {
    Field(image, "worldToNDC")->InsertNextTuple(0, Field(image, "worldToNDC"));
  });
  MustRefuse("no inverse", [](vtkImageData* image) { Field(image, "worldToCamera")->Fill(0.); });
  MustRefuse("not finite", [](vtkImageData* image) {
    Field(image, "worldToCamera")->SetComponent(0, 3, std::numeric_limits<double>::quiet_NaN());
  });
  MustRefuse("has 2 slices", [](vtkImageData* image) { image->SetDimensions(320, 120, 2); });
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testDepthToPoints)
{
  Session session;
  TestViews();
  TestArrays();
  TestStride();
  TestOtherName();
  TestNothingThere();
  TestRefusals();
  return session.Result();
}
}
