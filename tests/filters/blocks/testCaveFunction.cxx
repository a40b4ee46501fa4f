// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The cave function: its gradient against differences, places that cannot be, where caves begin
// again, and VTK's filters that take implicit functions.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoCaveFunction.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSampleFunction.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace testCaveFunction
{
namespace
{
using Function = vtkRelievoCaveFunction;

void TestGradient()
{
  vtkNew<Function> function;
  function->SetUp(1);
  function->SetScale(17.);
  function->SetVerticalScale(3.);
  function->SetTunnelWidth(0.);
  function->SetShell(-0.3, 0.1);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-100., 100.);
  double worst = 0.;
  double largest = 0.;
  int compared = 0;
  for (int i = 0; i < 20000; ++i)
  {
    double point[] = { uniform(random), uniform(random), 1e4 * uniform(random) };
    double gradient[3];
    function->EvaluateGradient(point, gradient);
    double difference[3];
    bool smooth = true;
    const double here = function->EvaluateFunction(point);
    for (int axis = 0; axis < 3; ++axis)
    {
      constexpr double Step = 1e-5;
      double low[] = { point[0], point[1], point[2] };
      double high[] = { point[0], point[1], point[2] };
      low[axis] -= Step;
      high[axis] += Step;
      const double below = function->EvaluateFunction(low);
      const double above = function->EvaluateFunction(high);
      difference[axis] = (above - below) / (2. * Step);
      // Not where the larger of two changes, nor in the middle of the shell.
      smooth = smooth && std::abs(above - 2. * here + below) < 1e-2 * Step;
    }
    if (smooth)
    {
      worst = std::max(worst, std::sqrt(vtkMath::Distance2BetweenPoints(gradient, difference)));
      largest = std::max(largest, vtkMath::Norm(gradient));
      ++compared;
    }
  }
  RELIEVO_CHECK(compared > 19000);
  RELIEVO_CHECK_AT_MOST(-largest, -3., "largest gradient, negative");
  RELIEVO_CHECK_AT_MOST(worst, 1e-4, "gradient against differences");
}

void TestPlaces()
{
  vtkNew<Function> function;
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : { std::nan(""), inf, -inf })
  {
    double point[] = { 1., bad, 2. };
    double gradient[] = { 1., 1., 1. };
    RELIEVO_CHECK(function->EvaluateFunction(point) > 1.);
    function->EvaluateGradient(point, gradient);
    RELIEVO_CHECK(vtkMath::Norm(gradient) == 0.);
  }
  // Anything finite has a value; caves begin again after 2^30 cells.
  const double period = 64. * 1073741824.;
  int same = 0;
  std::set<double> values;
  for (int i = 0; i < 100; ++i)
  {
    double point[] = { 37. * i, 11. * i, 64. };
    double again[] = { point[0] + period, point[1] - 3. * period, point[2] };
    const double value = function->EvaluateFunction(point);
    same += value == function->EvaluateFunction(again);
    values.insert(value);
    double huge[] = { std::pow(10., 3. * i), -std::pow(10., 3. * i), 0. };
    RELIEVO_CHECK(function->EvaluateFunction(huge) >= -1.);
  }
  RELIEVO_CHECK(same == 100 && values.size() > 90);
  // Wider tunnels than half of Scale are as wide as that.
  double shell[2][2];
  function->SetTunnelWidth(32.);
  function->GetThresholds(shell[0]);
  function->SetTunnelWidth(1000.);
  function->GetThresholds(shell[1]);
  RELIEVO_CHECK(shell[0][1] == shell[1][1] && shell[0][0] == -shell[0][1] && shell[0][1] > 0.4);
}

// Every bit of the seed counts.
void TestSeeds()
{
  std::vector<std::vector<double>> caves;
  for (int bit = -1; bit < 32; ++bit)
  {
    vtkNew<Function> function;
    function->SetSeed(bit < 0 ? 0 : static_cast<int>(1u << static_cast<unsigned int>(bit)));
    std::vector<double> values;
    for (int i = 0; i < 100; ++i)
    {
      double point[] = { 37. * i, 11. * i, 64. };
      values.push_back(function->EvaluateFunction(point));
    }
    RELIEVO_CHECK_THAT(std::find(caves.begin(), caves.end(), values) == caves.end(),
      "the same caves with bit " + std::to_string(bit) + " of the seed");
    caves.push_back(values);
  }
}

void TestSampled()
{
  vtkNew<Function> function;
  vtkNew<vtkSampleFunction> sample;
  sample->SetImplicitFunction(function);
  sample->SetSampleDimensions(30, 31, 32);
  sample->SetModelBounds(0., 58., 0., 60., 0., 62.);
  sample->SetOutputScalarTypeToDouble();
  sample->CappingOff();
  sample->ComputeNormalsOn();
  sample->Update();
  vtkImageData* image = sample->GetOutput();
  double worst = 0.;
  double normalWorst = 0.;
  int inside = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    const double value = function->EvaluateFunction(point);
    worst =
      std::max(worst, std::abs(value - image->GetPointData()->GetScalars()->GetComponent(i, 0)));
    inside += value < 0.;
    double gradient[3];
    function->EvaluateGradient(point, gradient);
    vtkMath::Normalize(gradient);
    double normal[3];
    image->GetPointData()->GetNormals()->GetTuple(i, normal);
    // vtkSampleFunction turns gradients around.
    vtkMath::Add(normal, gradient, normal);
    normalWorst = std::max(normalWorst, vtkMath::Norm(normal));
  }
  RELIEVO_CHECK(inside > 100);
  RELIEVO_CHECK_AT_MOST(worst, 1e-9, "sampled values");
  RELIEVO_CHECK_AT_MOST(normalWorst, 1e-5, "sampled normals");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testCaveFunction)
{
  relievoTest::Session session;
  TestGradient();
  TestPlaces();
  TestSeeds();
  TestSampled();
  return session.Result();
}
}
