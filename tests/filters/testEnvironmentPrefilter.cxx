// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Levels of a prefiltered environment: constant light stays, a gradient keeps the part that an
// integral tells, and every texel is the weighted mean of all light by a plain sum in double, also
// beside a sun of 1e5: no fireflies, no NaN; sizes, structure, messages.
#include "Check.h"
#include "Environments.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoEnvironmentPrefilter.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace testEnvironmentPrefilter
{
namespace
{
using namespace relievoTest;

constexpr double Pi = 3.14159265358979323846;

vtkSmartPointer<vtkMultiBlockDataSet> Run(
  vtkImageData* image, int levels = 6, int size = 0, double tolerance = 5e-4)
{
  vtkNew<vtkRelievoEnvironmentPrefilter> filter;
  filter->SetInputData(image);
  filter->SetTolerance(tolerance);
  filter->SetLevels(levels);
  filter->SetSize(size);
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  return filter->GetOutput();
}

vtkImageData* LevelOf(vtkMultiBlockDataSet* levels, int level)
{
  return vtkImageData::SafeDownCast(levels->GetBlock(static_cast<unsigned int>(level)));
}

glm::dvec3 Texel(vtkImageData* image, vtkIdType i)
{
  vtkDataArray* array = image->GetPointData()->GetArray("radiance");
  return glm::dvec3(
    array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2));
}

// GGX by its half vector, times the cosine, as the papers write it.
double Weight(double x, double roughness)
{
  const double alpha2 = roughness * roughness * roughness * roughness;
  const double half2 = (1. + x) / 2.;
  const double below = half2 * (alpha2 - 1.) + 1.;
  return x > 0. ? alpha2 / (Pi * below * below) * x : 0.;
}

glm::dvec3 DirectionOfTexel(int n, vtkIdType texel)
{
  const int size[3] = { n, n, 6 };
  return DirectionOf(
    Cube, size, static_cast<int>(texel / n / n), texel % n + 0.5, texel / n % n + 0.5);
}

// The weighted mean of all texels about a direction, each parted near it and at the
// horizon, where a single sun's share is all there is.
glm::dvec3 PlainSum(vtkImageData* sharp, const glm::dvec3& axis, double roughness)
{
  const int n = sharp->GetDimensions()[0];
  glm::dvec3 sum(0.);
  double weights = 0.;
  for (vtkIdType texel = 0; texel < sharp->GetNumberOfPoints(); ++texel)
  {
    const double x = glm::dot(axis, DirectionOfTexel(n, texel));
    if (x < -3. / n)
    {
      continue;
    }
    const int parts = x > 0.9 ? 5 : (x < 3. / n ? 9 : (x < 0.2 ? 3 : 1));
    const int size[3] = { n * parts, n * parts, 6 };
    const auto slice = static_cast<int>(texel / n / n);
    double weight = 0.;
    for (int k = 0; k < parts * parts; ++k)
    {
      const auto i = static_cast<int>(texel % n * parts + k % parts);
      const auto j = static_cast<int>(texel / n % n * parts + k / parts);
      weight += SolidAngleOf(Cube, size, slice, i, j) *
        Weight(glm::dot(axis, DirectionOf(Cube, size, slice, i + 0.5, j + 0.5)), roughness);
    }
    sum += weight * Texel(sharp, texel);
    weights += weight;
  }
  return sum / weights;
}

void TestFurnace()
{
  for (const int projection : { Equirectangular, Cube })
  {
    const auto levels = Run(
      MakeEnvironment([](const glm::dvec3&) { return glm::dvec3(1., 0.5, 1e4); }, projection, 64));
    double worst = 0.;
    RELIEVO_CHECK(levels->GetNumberOfBlocks() == 6);
    for (int level = 0; level < 6; ++level)
    {
      vtkImageData* image = LevelOf(levels, level);
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        const glm::dvec3 off = glm::abs(Texel(image, i) / glm::dvec3(1., 0.5, 1e4) - 1.);
        worst = std::max({ worst, off.x, off.y, off.z });
      }
    }
    RELIEVO_CHECK_AT_MOST(worst, 1e-5, "white furnace, all levels: off 1");
  }
}

// Light 1 + d . a: the mean about r is 1 + m r . a, m the mean cosine of the lobe.
void TestGradient()
{
  const glm::dvec3 slope(0.4, 0.7, -0.5);
  const auto levels = Run(MakeEnvironment(
    [&slope](const glm::dvec3& d) { return glm::dvec3(1. + glm::dot(d, slope)); }, Cube, 128));
  for (int level = 1; level < 6; ++level)
  {
    const double roughness = level / 5.;
    double first = 0.;
    double zeroth = 0.;
    for (int i = 0; i < 100000; ++i)
    {
      const double x = (i + 0.5) / 100000;
      const double weight = Weight(x, roughness);
      first += x * weight;
      zeroth += weight;
    }
    vtkImageData* image = LevelOf(levels, level);
    const int n = image->GetDimensions()[0];
    double worst = 0.;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double truth = 1. + first / zeroth * glm::dot(DirectionOfTexel(n, i), slope);
      worst = std::max(worst, std::abs(Texel(image, i).y - truth));
    }
    RELIEVO_CHECK_AT_MOST(
      worst, 0.01, "gradient, roughness " + std::to_string(roughness).substr(0, 3));
  }
}

void TestSums(
  const std::string& name, vtkImageData* image, double tolerance, int samples, double limit)
{
  const auto levels = Run(image, 6, 0, tolerance);
  vtkImageData* sharp = LevelOf(levels, 0);
  std::mt19937 random(11);
  for (int level = 1; level < 6; ++level)
  {
    vtkImageData* blurred = LevelOf(levels, level);
    const int n = blurred->GetDimensions()[0];
    double worst = 0.;
    double mean = 0.;
    for (int k = 0; k < samples; ++k)
    {
      const auto i = static_cast<vtkIdType>(random() % blurred->GetNumberOfPoints());
      const glm::dvec3 truth = PlainSum(sharp, DirectionOfTexel(n, i), level / 5.);
      const glm::dvec3 off = glm::abs(Texel(blurred, i) - truth) / glm::abs(truth);
      worst = std::max({ worst, off.x, off.y, off.z });
      mean += (off.x + off.y + off.z) / 3. / samples;
    }
    const std::string what = name + ", roughness " + std::to_string(level / 5.).substr(0, 3);
    RELIEVO_CHECK_AT_MOST(mean, limit / 2., what + ": mean off the plain sum");
    RELIEVO_CHECK_AT_MOST(worst, limit, what + ": worst");
  }
}

void TestSuns()
{
  // A sun of one texel over a dim sky and a dark ground; and noise from texel to texel.
  const vtkSmartPointer<vtkImageData> sun = MakeEnvironment(
    [](const glm::dvec3& d) {
      return d.y > 0. ? glm::dvec3(0.3, 0.5, 1.) : glm::dvec3(0.02, 0.01, 0.01);
    },
    Cube, 128);
  sun->GetPointData()->GetScalars()->SetTuple3(128 * 37 + 50, 1e5, 9e4, 8e4);
  TestSums("sun", sun, 5e-4, 8, 0.01);
  const vtkSmartPointer<vtkImageData> noise =
    MakeEnvironment([](const glm::dvec3&) { return glm::dvec3(0.); }, Cube, 64);
  std::mt19937 random(5);
  for (vtkIdType i = 0; i < noise->GetNumberOfPoints(); ++i)
  {
    const double value = std::exp(12. * double(random()) / 4294967296.) / 1e3;
    noise->GetPointData()->GetScalars()->SetTuple3(i, value, value, 1.);
  }
  TestSums("noise", noise, 5e-4, 15, 0.01);
  // Only a sun: its remaining light elsewhere is as small as expected.
  const vtkSmartPointer<vtkImageData> alone =
    MakeEnvironment([](const glm::dvec3&) { return glm::dvec3(0.); }, Cube, 64);
  alone->GetPointData()->GetScalars()->SetTuple3(64 * 64 + 64 * 5 + 5, 1e5, 1e5, 1e5);
  const auto levels = Run(alone);
  int bad = 0;
  int dark = 0;
  for (int level = 0; level < 6; ++level)
  {
    vtkImageData* image = LevelOf(levels, level);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const glm::dvec3 light = Texel(image, i);
      bad += std::isfinite(light.x) && light.x >= 0. && light.x <= 1e5 ? 0 : 1;
      dark += level == 5 && light.x == 0. ? 1 : 0;
    }
  }
  RELIEVO_CHECK_AT_MOST(bad, 0, "texels that are not finite, below 0 or above the sun");
  RELIEVO_CHECK(dark > 4); // behind the horizon
  const vtkSmartPointer<vtkImageData> night =
    MakeEnvironment([](const glm::dvec3&) { return glm::dvec3(0.); }, Cube, 8);
  RELIEVO_CHECK(Texel(LevelOf(Run(night), 2), 3) == glm::dvec3(0.));
}

void TestStructure()
{
  const auto levels = Run(MakeEnvironment(SmoothLight, Equirectangular, 50), 4, 30);
  RELIEVO_CHECK(levels->GetNumberOfBlocks() == 4);
  for (int level = 0; level < 4; ++level)
  {
    vtkImageData* image = LevelOf(levels, level);
    const int* size = image->GetDimensions();
    RELIEVO_CHECK(size[0] == 32 >> level && size[1] == size[0] && size[2] == 6);
    vtkDataArray* roughness = image->GetFieldData()->GetArray("roughness");
    RELIEVO_CHECK(roughness && roughness->GetComponent(0, 0) == level / 3.);
    RELIEVO_CHECK(
      levels->GetMetaData(static_cast<unsigned int>(level))->Get(vtkCompositeDataSet::NAME()) ==
      "level " + std::to_string(level));
  }
  RELIEVO_CHECK_AT_MOST(
    ErrorsOf(LevelOf(levels, 0), Cube, SmoothLight).Mean, 2e-3, "level 0 is the environment");
  RELIEVO_CHECK(Run(MakeEnvironment(SmoothLight, Cube, 2), 12)->GetNumberOfBlocks() == 2);
  RELIEVO_CHECK(Run(MakeEnvironment(SmoothLight, Cube, 1))->GetNumberOfBlocks() == 1);
  // Large levels of small roughness, narrower than a texel.
  const auto many = Run(MakeEnvironment(SmoothLight, Cube, 64), 7, 16);
  RELIEVO_CHECK(many->GetNumberOfBlocks() == 5);
  vtkNew<vtkImageData> empty;
  RELIEVO_CHECK(Run(empty)->GetNumberOfBlocks() == 0);
  vtkNew<vtkImageData> odd;
  odd->SetDimensions(5, 3, 1);
  odd->AllocateScalars(VTK_FLOAT, 3);
  vtkNew<vtkRelievoEnvironmentPrefilter> filter;
  filter->SetInputData(odd);
  {
    ExpectMessage expect("No levels: the image is 5 x 3 x 1");
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::UserError);
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfBlocks() == 0);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testEnvironmentPrefilter)
{
  Session session;
  TestFurnace();
  TestGradient();
  TestSums("smooth light", MakeEnvironment(SmoothLight, Cube, 128), 5e-4, 5, 0.01);
  TestSums("smooth light, tolerance 1e-5", MakeEnvironment(SmoothLight, Cube, 64), 1e-5, 10, 0.002);
  TestSuns();
  TestStructure();
  return session.Result();
}
}
