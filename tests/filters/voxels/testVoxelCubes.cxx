// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cubes of a mask: the cells with cubes, sizes compared with distances by brute force, movement by
// the repeller, and data of the nearest point.
#include "Check.h"
#include "Refusal.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoVoxelCubes.h"

#include <vtkCellData.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace testVoxelCubes
{
namespace
{
constexpr int Size[3] = { 13, 9, 11 };
const glm::dvec3 Origin(-1., 2., 0.5);
const glm::dvec3 Spacing(0.5, 0.25, 1.);

glm::dvec3 CenterOf(int cell)
{
  const glm::dvec3 index(
    cell % Size[0] + 0.5, cell / Size[0] % Size[1] + 0.5, cell / Size[0] / Size[1] + 0.5);
  return Origin + index * Spacing;
}

// A few cells anywhere, and a block with inner cells.
vtkSmartPointer<vtkImageData> Image()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Size[0] + 1, Size[1] + 1, Size[2] + 1);
  image->SetOrigin(Origin.x, Origin.y, Origin.z);
  image->SetSpacing(Spacing.x, Spacing.y, Spacing.z);
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("mask");
  std::mt19937 any(5);
  for (int cell = 0; cell < Size[0] * Size[1] * Size[2]; ++cell)
  {
    const glm::dvec3 apart = glm::abs(CenterOf(cell) - glm::dvec3(0.5, 3.1, 4.));
    const bool block = apart.x < 1. && apart.y < 0.6 && apart.z < 2.1;
    mask->InsertNextValue(block || any() % 200 == 0 ? 1 : 0);
  }
  image->GetCellData()->AddArray(mask);
  return image;
}

void TestSizes()
{
  const vtkSmartPointer<vtkImageData> image = Image();
  auto* mask = vtkUnsignedCharArray::SafeDownCast(image->GetCellData()->GetArray("mask"));
  vtkNew<vtkRelievoVoxelCubes> cubes;
  cubes->SetInputData(image);
  cubes->SetTransition(1.7);
  cubes->SetRestSize(0.1);
  cubes->SetGrowth(0.999); // inner cells as well
  cubes->WholeGridOn();
  cubes->Update();
  vtkPolyData* output = cubes->GetOutput();
  auto* sizes = vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray("size"));
  auto* scales = vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray("scale"));
  RELIEVO_CHECK(output->GetNumberOfPoints() == mask->GetNumberOfValues());
  double largest = 0.;
  vtkIdType falling = 0;
  for (int cell = 0; cell < mask->GetNumberOfValues(); ++cell)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (int other = 0; other < mask->GetNumberOfValues(); ++other)
    {
      if (mask->GetValue(other))
      {
        nearest = std::min(nearest, glm::distance(CenterOf(cell), CenterOf(other)));
      }
    }
    const double rest = 1. - std::min(nearest / 1.7, 1.);
    const double size = 0.1 + 0.9 * 0.999 * rest * rest * (3. - 2. * rest);
    falling += rest > 0. && rest < 1. ? 1 : 0;
    largest = std::max(largest, std::abs(sizes->GetValue(cell) - size));
    for (int axis = 0; axis < 3; ++axis)
    {
      largest =
        std::max(largest, std::abs(scales->GetComponent(cell, axis) - size * Spacing[axis]));
      RELIEVO_CHECK(std::abs(output->GetPoint(cell)[axis] - CenterOf(cell)[axis]) < 1e-5);
    }
  }
  RELIEVO_CHECK(falling > 100);
  RELIEVO_CHECK_AT_MOST(largest, 1e-6, "sizes against brute force");
  // Without the outer grid and hidden cells.
  cubes->SetGrowth(1.);
  cubes->SetTransition(0.);
  cubes->WholeGridOff();
  cubes->Update();
  vtkIdType shell = 0;
  for (int cell = 0; cell < mask->GetNumberOfValues(); ++cell)
  {
    bool seen = false;
    int step = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int at = cell / step % Size[axis];
      seen = seen || at == 0 || at == Size[axis] - 1 || !mask->GetValue(cell - step) ||
        !mask->GetValue(cell + step);
      step *= Size[axis];
    }
    shell += mask->GetValue(cell) && seen ? 1 : 0;
  }
  RELIEVO_CHECK(cubes->GetOutput()->GetNumberOfPoints() == shell);
  sizes = vtkFloatArray::SafeDownCast(cubes->GetOutput()->GetPointData()->GetArray("size"));
  RELIEVO_CHECK(sizes->GetRange()[0] == 1. && sizes->GetRange()[1] == 1.);
}

void TestRepeller()
{
  const vtkSmartPointer<vtkImageData> image = Image();
  vtkNew<vtkRelievoVoxelCubes> cubes;
  cubes->SetInputData(image);
  cubes->WholeGridOn();
  cubes->SetGrowth(0.5);
  const glm::dvec3 middle(0.7, 3., 4.2);
  cubes->SetRepeller(middle.x, middle.y, middle.z);
  cubes->SetRepellerRadius(2.);
  cubes->Update();
  int moved = 0;
  for (vtkIdType i = 0; i < cubes->GetOutput()->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 place;
    cubes->GetOutput()->GetPoint(i, &place[0]);
    const glm::dvec3 before = CenterOf(static_cast<int>(i));
    const double d = glm::distance(before, middle);
    RELIEVO_CHECK(glm::distance(place, middle) > 0.9999);
    const glm::dvec3 truth =
      d < 2. ? middle + glm::normalize(before - middle) * (1. + d * d / 4.) : before;
    RELIEVO_CHECK(glm::distance(place, truth) < 1e-5);
    moved += d < 2. ? 1 : 0;
  }
  RELIEVO_CHECK(moved > 50);
}

void TestColors()
{
  vtkNew<vtkPolyData> model;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> values;
  values->SetName("value");
  std::mt19937 any(7);
  std::uniform_real_distribution<double> unit(0., 1.);
  for (int i = 0; i < 50; ++i)
  {
    points->InsertNextPoint(-1. + 6. * unit(any), 2. + 2. * unit(any), 11. * unit(any));
    values->InsertNextValue(static_cast<float>(i));
  }
  model->SetPoints(points);
  model->GetPointData()->SetScalars(values);
  vtkNew<vtkRelievoVoxelCubes> cubes;
  cubes->SetInputData(0, Image());
  cubes->SetInputData(1, model);
  cubes->Update();
  vtkPolyData* output = cubes->GetOutput();
  vtkDataArray* found = output->GetPointData()->GetScalars();
  RELIEVO_CHECK(found && std::string(found->GetName()) == "value");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 place;
    output->GetPoint(i, &place[0]);
    double nearest = std::numeric_limits<double>::infinity();
    for (int p = 0; p < 50; ++p)
    {
      glm::dvec3 other;
      points->GetPoint(p, &other[0]);
      nearest = std::min(nearest, glm::distance(place, other));
    }
    glm::dvec3 chosen;
    points->GetPoint(static_cast<vtkIdType>(found->GetTuple1(i)), &chosen[0]);
    RELIEVO_CHECK(glm::distance(place, chosen) < nearest + 1e-6);
  }
  // Arrays that cubes must not copy, or that would replace their own.
  for (const char* name : { "vtkGhostType", "size", "scale" })
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(name);
    array->SetNumberOfValues(50);
    array->FillValue(1);
    model->GetPointData()->AddArray(array);
  }
  model->Modified();
  relievoTest::ExpectMessage expect("point data 'size', 'scale' of the model are left out");
  cubes->Update();
  RELIEVO_CHECK(expect.Count() == 1);
  RELIEVO_CHECK(!output->GetPointData()->HasArray("vtkGhostType"));
  RELIEVO_CHECK(output->GetPointData()->GetArray("size")->GetDataType() == VTK_FLOAT);
  RELIEVO_CHECK(output->GetPointData()->GetArray("scale")->GetNumberOfComponents() == 3);
}

// Far from the origin, as of maps in metres: places are double, and exact.
void TestFarAway()
{
  const vtkSmartPointer<vtkImageData> image = Image();
  vtkNew<vtkRelievoVoxelCubes> cubes;
  cubes->SetInputData(image);
  cubes->WholeGridOn();
  cubes->SetGrowth(0.5);
  cubes->Update();
  RELIEVO_CHECK(cubes->GetOutput()->GetPoints()->GetDataType() == VTK_FLOAT);
  image->SetOrigin(5e5, 5e6, 0.);
  image->SetSpacing(0.1, 0.1, 0.1);
  cubes->Update();
  vtkPolyData* output = cubes->GetOutput();
  RELIEVO_CHECK(output->GetPoints()->GetDataType() == VTK_DOUBLE);
  double largest = 0.;
  for (vtkIdType cell = 0; cell < output->GetNumberOfPoints(); ++cell)
  {
    const glm::dvec3 index = (CenterOf(static_cast<int>(cell)) - Origin) / Spacing;
    glm::dvec3 place;
    output->GetPoint(cell, &place[0]);
    largest = std::max(largest, glm::distance(place, glm::dvec3(5e5, 5e6, 0.) + 0.1 * index));
  }
  RELIEVO_CHECK_AT_MOST(largest, 1e-8, "places far from the origin");
}

// With a direction matrix, the corners of each cube are those of its cell.
void TestTurned()
{
  const vtkSmartPointer<vtkImageData> image = Image();
  vtkNew<vtkRelievoVoxelCubes> cubes;
  cubes->SetInputData(image);
  cubes->WholeGridOn();
  cubes->SetGrowth(0.999);
  cubes->SetTransition(1.7);
  cubes->Update();
  RELIEVO_CHECK(!cubes->GetOutput()->GetPointData()->HasArray("orientation"));
  vtkNew<vtkFloatArray> sizes;
  sizes->DeepCopy(cubes->GetOutput()->GetPointData()->GetArray("size"));
  const double c = std::cos(0.6);
  const double s = std::sin(0.6);
  const double turned[9] = { c, 0., s, 0.6 * s, 0.8, -0.6 * c, -0.8 * s, 0.6, 0.8 * c };
  for (const double sign : { 1., -1. })
  {
    double matrix[9];
    std::transform(turned, turned + 9, matrix, [sign](double value) { return sign * value; });
    image->SetDirectionMatrix(matrix);
    cubes->Update();
    vtkPolyData* output = cubes->GetOutput();
    RELIEVO_CHECK(output->GetNumberOfPoints() == image->GetNumberOfCells());
    vtkDataArray* turns = output->GetPointData()->GetArray("orientation");
    vtkDataArray* scales = output->GetPointData()->GetArray("scale");
    double largest = turns ? 0. : 1.;
    for (vtkIdType cell = 0; turns && cell < output->GetNumberOfPoints(); cell += 7)
    {
      double wxyz[4];
      turns->GetTuple(cell, wxyz);
      glm::dvec3 size;
      scales->GetTuple(cell, &size[0]);
      const glm::dquat turn(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
      glm::dvec3 place;
      output->GetPoint(cell, &place[0]);
      const double share = sizes->GetValue(cell);
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::dvec3 at((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5, (corner >> 2) - 0.5);
        const glm::dvec3 drawn = place + turn * (at * size);
        // The cell's nearest corner, as a mirrored cube has them in another order.
        double nearest = std::numeric_limits<double>::infinity();
        for (int other = 0; other < 8; ++other)
        {
          const glm::dvec3 from((other & 1) - 0.5, (other >> 1 & 1) - 0.5, (other >> 2) - 0.5);
          const glm::dvec3 index =
            (CenterOf(static_cast<int>(cell)) - Origin) / Spacing + share * from;
          glm::dvec3 truth;
          image->TransformContinuousIndexToPhysicalPoint(&index[0], &truth[0]);
          nearest = std::min(nearest, glm::distance(truth, drawn));
        }
        largest = std::max(largest, nearest);
      }
    }
    RELIEVO_CHECK_AT_MOST(largest, 1e-5, "corners of turned cubes");
  }
  image->SetDirectionMatrix(1., 0.5, 0., 0., 1., 0., 0., 0., 1.);
  relievoTest::CheckRefused(cubes.Get(), "the cells are no boxes");
}

void TestNoMask()
{
  vtkNew<vtkRelievoVoxelCubes> cubes;
  vtkNew<vtkImageData> image;
  cubes->SetInputData(image);
  cubes->Update();
  RELIEVO_CHECK(cubes->GetErrorCode() == vtkErrorCode::NoError);
  image->SetDimensions(3, 3, 3);
  relievoTest::ExpectMessage expect("no cell array 'mask'");
  cubes->SetInputData(image);
  cubes->Modified();
  cubes->Update();
  RELIEVO_CHECK(expect.Count() == 1 && cubes->GetErrorCode() == vtkErrorCode::UserError);
}
}

RELIEVO_TEST_CASE(testVoxelCubes)
{
  relievoTest::Session session;
  TestSizes();
  TestRepeller();
  TestColors();
  TestFarAway();
  TestTurned();
  TestNoMask();
  return session.Result();
}
}
