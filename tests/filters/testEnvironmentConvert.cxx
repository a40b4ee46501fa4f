// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Environments from formulas, turned from every projection into every other: axes arrive exactly,
// smooth light to its formula, constant light as it is, the light of single strong texels whole;
// number types, mirrored cubes, small and odd sizes, messages.
#include "Check.h"
#include "Environments.h"
#include "Refusal.h"
#include "Session.h"
#include "SrgbCurve.h"
#include "TestCase.h"
#include "vtkRelievoEnvironmentConvert.h"

#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace testEnvironmentConvert
{
namespace
{
using namespace relievoTest;

const char* Names[] = { "", "equirectangular", "cube", "sphere map" };

vtkSmartPointer<vtkImageData> Convert(
  vtkImageData* image, int projection, int size = 0, int samples = 2)
{
  vtkNew<vtkRelievoEnvironmentConvert> filter;
  filter->SetInputData(image);
  filter->SetOutputProjection(projection);
  filter->SetOutputSize(size);
  filter->SetSamplesPerTexel(samples);
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  return filter->GetOutput();
}

// Six colours, each within 30 degrees of its axis.
glm::dvec3 AxisLight(const glm::dvec3& d)
{
  const glm::dvec3 size = glm::abs(d);
  const double most = std::max({ size.x, size.y, size.z });
  const int axis = most == size.x ? 0 : (most == size.y ? 1 : 2);
  const int number = 2 * axis + (d[axis] < 0. ? 1 : 0);
  return most < 0.866 ? glm::dvec3(0.)
                      : glm::dvec3(number + 1, (number * 3) % 6, (number * 5) % 7) / 255.;
}

// The image's value in the nearest direction.
glm::dvec3 Look(vtkImageData* image, int projection, const glm::dvec3& direction)
{
  const int* size = image->GetDimensions();
  vtkDataArray* array = image->GetPointData()->GetScalars();
  double best = -2.;
  vtkIdType found = 0;
  vtkIdType texel = 0;
  for (int slice = 0; slice < size[2]; ++slice)
  {
    for (int row = 0; row < size[1]; ++row)
    {
      for (int column = 0; column < size[0]; ++column, ++texel)
      {
        const glm::dvec3 d = DirectionOf(projection, size, slice, column + 0.5, row + 0.5);
        if (glm::dot(d, direction) > best)
        {
          best = glm::dot(d, direction);
          found = texel;
        }
      }
    }
  }
  return glm::dvec3(
    array->GetComponent(found, 0), array->GetComponent(found, 1), array->GetComponent(found, 2));
}

void TestAxes()
{
  for (const int from : { Equirectangular, Cube, SphereMap })
  {
    const vtkSmartPointer<vtkImageData> image = MakeEnvironment(AxisLight, from, 96);
    for (const int to : { Equirectangular, Cube, SphereMap })
    {
      const vtkSmartPointer<vtkImageData> made = Convert(image, to, 64);
      for (int axis = 0; axis < 6; ++axis)
      {
        glm::dvec3 d(0.);
        d[axis / 2] = axis % 2 ? -1. : 1.;
        const glm::dvec3 off = glm::abs(Look(made, to, d) - AxisLight(d));
        RELIEVO_CHECK_THAT(std::max({ off.x, off.y, off.z }) < 1e-7,
          std::string(Names[from]) + " to " + Names[to] + ", axis " + std::to_string(axis));
      }
    }
  }
}

void TestSmooth()
{
  for (const int from : { Equirectangular, Cube, SphereMap })
  {
    // Cube and sphere map have as many texels to an angle as the equirectangular image's equator.
    const int n = from == Equirectangular ? 128 : (from == Cube ? 64 : 192);
    const vtkSmartPointer<vtkImageData> image = MakeEnvironment(SmoothLight, from, n);
    const vtkSmartPointer<vtkImageData> even =
      MakeEnvironment([](const glm::dvec3&) { return glm::dvec3(0.7, 1e4, 0.); }, from, 17);
    for (const int to : { Equirectangular, Cube, SphereMap })
    {
      const std::string name = std::string(Names[from]) + " to " + Names[to];
      const LightErrors errors = ErrorsOf(Convert(image, to, 48), to, SmoothLight);
      RELIEVO_CHECK_AT_MOST(errors.Mean, from == SphereMap || to == SphereMap ? 1e-3 : 2e-4,
        name + ": mean error of smooth light");
      // Towards -z a sphere map's texels are long: its last ones look 15 degrees apart.
      const double worst = from == SphereMap ? 0.2 : (to == SphereMap ? 0.02 : 1e-3);
      RELIEVO_CHECK_AT_MOST(errors.Worst, worst, name + ": worst");
      RELIEVO_CHECK_AT_MOST(errors.WorstBorder, errors.Worst, name + ": worst at borders");
      const glm::dvec3 flux = FluxOf(Convert(image, to), to) / FluxOf(image, from);
      RELIEVO_CHECK_AT_MOST(
        std::abs(flux.x - 1.), to == SphereMap || from == SphereMap ? 2e-3 : 1e-5, name + ": flux");
      const LightErrors constant = ErrorsOf(
        Convert(even, to, 23), to, [](const glm::dvec3&) { return glm::dvec3(0.7, 1e4, 0.); });
      RELIEVO_CHECK_AT_MOST(constant.Worst, 1e-6, name + ": constant light");
    }
  }
}

// Texels of 1e5 in the dark: the light lost or added.
double LostOf(vtkImageData* image, int from, int to, int samples)
{
  double worst = 0.;
  for (const int n : { 8, 24, 50 })
  {
    const double flux = FluxOf(Convert(image, to, n, samples), to).x / FluxOf(image, from).x;
    worst = std::max(worst, std::abs(flux - 1.));
  }
  return worst;
}

void TestSuns()
{
  std::mt19937 random(3);
  const Light dark = [](const glm::dvec3&) { return glm::dvec3(0.); };
  for (const int from : { Equirectangular, Cube })
  {
    for (const int to : { Equirectangular, Cube })
    {
      const std::string name = std::string(Names[from]) + " to " + Names[to];
      const int n = from == Cube ? 64 : 128;
      double worst[2] = { 0., 0. };
      for (int i = 0; i < 6; ++i)
      {
        const vtkSmartPointer<vtkImageData> image = MakeEnvironment(dark, from, n);
        const int* size = image->GetDimensions();
        // Anywhere: the first at the seam or an edge. Not within 8 rows of a pole or an edge.
        const auto row = 8 + static_cast<vtkIdType>(random() % (n - 16));
        const auto column = static_cast<vtkIdType>(i < 3 ? 0 : random() % size[0]);
        const auto slice = static_cast<vtkIdType>(random() % size[2]);
        image->GetPointData()->GetScalars()->SetTuple3(
          (slice * size[1] + row) * size[0] + column, 1e5, 1e5, 1e5);
        worst[0] = std::max(worst[0], LostOf(image, from, to, 2));
        worst[1] = std::max(worst[1], LostOf(image, from, to, 4));
      }
      RELIEVO_CHECK_AT_MOST(worst[0], 0.05, name + ": light of one texel lost or added, 2 samples");
      RELIEVO_CHECK_AT_MOST(worst[1], 0.02, name + ": the same, 4 samples");
      // A sun in the zenith is the whole first row; one at a corner of a face is its texel.
      const vtkSmartPointer<vtkImageData> zenith = MakeEnvironment(dark, from, n);
      for (vtkIdType i = 0; i < (from == Cube ? 1 : 2 * n); ++i)
      {
        zenith->GetPointData()->GetScalars()->SetTuple3(i, 1e5, 1e5, 1e5);
      }
      RELIEVO_CHECK_AT_MOST(
        LostOf(zenith, from, to, 2), 0.1, name + ": light of a pole's row or a corner's texel");
    }
  }
}

void TestMirrored()
{
  const vtkSmartPointer<vtkImageData> plain = MakeEnvironment(SmoothLight, Cube, 32);
  const Light turned = [](const glm::dvec3& d) { return SmoothLight({ d.x, d.y, -d.z }); };
  const vtkSmartPointer<vtkImageData> mirrored = MakeEnvironment(turned, Cube, 32);
  vtkNew<vtkRelievoEnvironmentConvert> filter;
  filter->SetInputData(mirrored);
  filter->InputMirroredOn();
  filter->SetOutputProjection(Equirectangular);
  filter->Update();
  RELIEVO_CHECK_AT_MOST(
    ErrorsOf(filter->GetOutput(), Equirectangular, SmoothLight).Worst, 5e-3, "mirrored cube in");
  filter->SetInputData(plain);
  filter->InputMirroredOff();
  filter->OutputMirroredOn();
  filter->SetOutputProjection(Cube);
  filter->Update();
  RELIEVO_CHECK_AT_MOST(
    ErrorsOf(filter->GetOutput(), Cube, turned).Worst, 5e-3, "mirrored cube out");
}

void TestNumbers()
{
  // Bytes, linear and sRGB; one component; four; NaN.
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 6);
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetNumberOfComponents(4);
  bytes->SetNumberOfTuples(96);
  for (int c = 0; c < 4; ++c)
  {
    bytes->FillComponent(c, 51. * (c + 1));
  }
  image->GetPointData()->SetScalars(bytes);
  vtkNew<vtkRelievoEnvironmentConvert> filter;
  filter->SetInputData(image);
  filter->Update();
  const auto first = [&filter](int c) {
    return filter->GetOutput()->GetPointData()->GetArray("radiance")->GetComponent(50, c);
  };
  RELIEVO_CHECK_NEAR(first(0), 0.2, 1e-7, "a byte of 51");
  RELIEVO_CHECK_NEAR(first(2), 0.6, 1e-7, "a byte of 153");
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfScalarComponents() == 3);
  filter->InputSRGBOn();
  filter->Update();
  RELIEVO_CHECK_NEAR(first(0), LinearFromSrgb(0.2), 1e-6, "sRGB of 51");
  vtkNew<vtkFloatArray> grey;
  grey->SetNumberOfValues(96);
  grey->FillValue(2.5f);
  grey->SetValue(3, std::numeric_limits<float>::quiet_NaN());
  grey->SetValue(4, std::numeric_limits<float>::infinity());
  image->GetPointData()->SetScalars(grey);
  image->Modified();
  filter->InputSRGBOff();
  filter->Update();
  RELIEVO_CHECK(first(0) == 2.5 && first(1) == 2.5 && first(2) == 2.5);
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetScalars();
  RELIEVO_CHECK(array->GetComponent(3, 1) == 0. && array->GetComponent(4, 1) == 65504.);
}

void TestSizes()
{
  const struct
  {
    int From;
    int Size;
    int To;
    int Expected[3];
  } cases[] = { { Equirectangular, 64, Cube, { 32, 32, 6 } },
    { Equirectangular, 64, SphereMap, { 96, 96, 1 } },
    { Equirectangular, 64, Equirectangular, { 128, 64, 1 } }, { Cube, 10, Cube, { 10, 10, 6 } },
    { Cube, 10, Equirectangular, { 40, 20, 1 } }, { SphereMap, 30, Cube, { 10, 10, 6 } },
    { Cube, 1, Equirectangular, { 4, 2, 1 } }, { SphereMap, 1, Cube, { 1, 1, 6 } } };
  for (const auto& one : cases)
  {
    const vtkSmartPointer<vtkImageData> image = MakeEnvironment(SmoothLight, one.From, one.Size);
    const vtkSmartPointer<vtkImageData> made = Convert(image, one.To);
    RELIEVO_CHECK(std::equal(one.Expected, one.Expected + 3, made->GetDimensions()));
    if (one.From == one.To)
    {
      int mismatches = 0; // a copy
      for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
      {
        mismatches += made->GetPointData()->GetScalars()->GetComponent(i, 1) ==
            image->GetPointData()->GetScalars()->GetComponent(i, 1)
          ? 0
          : 1;
      }
      RELIEVO_CHECK(mismatches == 0);
    }
  }
  // Any shape is equirectangular when it is said to be.
  vtkNew<vtkImageData> odd;
  odd->SetDimensions(7, 5, 1);
  odd->AllocateScalars(VTK_DOUBLE, 3);
  odd->GetPointData()->GetScalars()->Fill(0.25);
  vtkNew<vtkRelievoEnvironmentConvert> filter;
  filter->SetInputData(odd);
  filter->SetInputProjection(vtkRelievoEnvironmentConvert::EQUIRECTANGULAR);
  filter->SetOutputSize(3);
  filter->Update();
  RELIEVO_CHECK(filter->GetOutput()->GetPointData()->GetScalars()->GetComponent(53, 2) == 0.25);
  vtkNew<vtkImageData> empty;
  RELIEVO_CHECK(Convert(empty, Cube)->GetNumberOfPoints() == 0);
}

void MustRefuse(const std::string& words, const int size[3], int projection, bool scalars)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size);
  if (scalars)
  {
    image->AllocateScalars(VTK_FLOAT, 3);
  }
  vtkNew<vtkRelievoEnvironmentConvert> filter;
  filter->SetInputData(image);
  filter->SetInputProjection(projection);
  CheckRefused(filter.Get(), words);
}

void TestRefusals()
{
  const int odd[] = { 7, 5, 1 };
  const int slices[] = { 8, 8, 2 };
  const int cube[] = { 8, 8, 6 };
  MustRefuse("the image is 7 x 5 x 1, but neither", odd, 0, true);
  MustRefuse("the image is 8 x 8 x 2, but", slices, 0, true);
  MustRefuse("but a cube is n x n x 6", odd, Cube, true);
  MustRefuse("but a sphere map is n x n x 1", cube, SphereMap, true);
  MustRefuse("but an equirectangular image has one slice", cube, Equirectangular, true);
  MustRefuse("Its point arrays are: none", cube, 0, false);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testEnvironmentConvert)
{
  Session session;
  TestAxes();
  TestSmooth();
  TestSuns();
  TestMirrored();
  TestNumbers();
  TestSizes();
  TestRefusals();
  return session.Result();
}
}
