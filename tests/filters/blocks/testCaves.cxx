// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Caves against the naive double loop, bit for bit: with and without skipping, in pieces, with any
// number of threads, far from the origin, with negative spacing; and the width of tunnels that was
// asked for.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoCaveFunction.h"
#include "vtkRelievoCaves.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRelievoFormulas.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace testCaves
{
namespace
{
using Caves = vtkRelievoCaves;

// Both noises at a place, from the formula itself.
std::array<double, 2> NaiveNoises(Caves* caves, const double point[3])
{
  glm::dvec3 place;
  for (int axis = 0; axis < 3; ++axis)
  {
    place[axis] = point[axis] * (1. / caves->GetScale());
  }
  const int up = caves->GetUp();
  place[up] = point[up] * (1. / caves->GetScale() * caves->GetVerticalScale());
  // Two seeds from one: negative ones have them the other way around.
  const auto doubled = 2u * static_cast<unsigned int>(caves->GetSeed());
  const unsigned int swapped = caves->GetSeed() < 0 ? 1u : 0u;
  std::array<double, 2> noises;
  for (unsigned int which = 0; which < 2; ++which)
  {
    const glm::dvec3 cell = glm::floor(place);
    noises[which] = relievo::f64::relievoSimplexNoise(
      glm::ivec3(cell), place - cell, doubled + (which ^ swapped));
    place += glm::dvec3(0.5, 0.25, 0.125);
  }
  return noises;
}

std::vector<double> ValuesOf(vtkImageData* image)
{
  vtkDataArray* array = image->GetPointData()->GetScalars();
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

// The mask as two nested tests at each sample would make it.
std::vector<double> NaiveMask(Caves* caves)
{
  double shell[2];
  caves->GetFunction()->GetThresholds(shell);
  const double middle = 0.5 * (shell[0] + shell[1]);
  const double perHalf = 2. / (shell[1] - shell[0]);
  std::vector<double> mask;
  const int* size = caves->GetSize();
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const double point[] = { caves->GetOrigin()[0] + i * caves->GetSpacing()[0],
          caves->GetOrigin()[1] + j * caves->GetSpacing()[1],
          caves->GetOrigin()[2] + k * caves->GetSpacing()[2] };
        const std::array<double, 2> noises = NaiveNoises(caves, point);
        mask.push_back(std::abs(noises[0] - middle) * perHalf - 1. < 0. &&
          std::abs(noises[1] - middle) * perHalf - 1. < 0.);
      }
    }
  }
  return mask;
}

struct Case
{
  std::string Name;
  std::array<int, 3> Size;
  std::function<void(Caves*)> SetUp;
};

std::vector<Case> Cases()
{
  return {
    { "as it comes", { 61, 50, 40 }, [](Caves*) {} },
    { "fine", { 75, 50, 33 },
      [](Caves* caves) {
        caves->SetScale(300.);
        caves->SetTunnelWidth(60.);
      } },
    { "coarse", { 33, 40, 50 }, [](Caves* caves) { caves->SetScale(12.1); } },
    { "far away", { 49, 48, 47 },
      [](Caves* caves) {
        caves->SetOrigin(1e7, -1e7, 1e7 + 0.125);
        caves->SetUp(1);
      } },
    { "negative spacing", { 40, 41, 42 }, [](Caves* caves) { caves->SetSpacing(-1., 0.7, -2.); } },
    { "a column", { 1, 1, 900 }, [](Caves* caves) { caves->SetSeed(-7); } },
    { "a row", { 900, 1, 1 }, [](Caves* caves) { caves->SetSeed(3); } },
    { "a shell to one side", { 50, 50, 50 },
      [](Caves* caves) {
        caves->SetTunnelWidth(0.);
        caves->SetShell(0.2, 0.5);
      } },
    { "all air", { 20, 20, 20 },
      [](Caves* caves) {
        caves->SetTunnelWidth(0.);
        caves->SetShell(-2., 2.);
      } },
    { "none", { 50, 50, 50 },
      [](Caves* caves) {
        caves->SetTunnelWidth(0.);
        caves->SetShell(1.5, 2.);
      } },
  };
}

void TestNaive()
{
  for (const Case& one : Cases())
  {
    vtkNew<Caves> caves;
    caves->SetSize(one.Size[0], one.Size[1], one.Size[2]);
    one.SetUp(caves);
    const std::vector<double> naive = NaiveMask(caves);
    const auto air = std::count(naive.begin(), naive.end(), 1.);
    RELIEVO_CHECK_THAT((air > 0) == (one.Name != "none"), one.Name + ": air is a matter of luck");
    for (const bool skipping : { false, true })
    {
      caves->SetSkipping(skipping);
      caves->Update();
      RELIEVO_CHECK_THAT(ValuesOf(caves->GetOutput()) == naive,
        one.Name + ": the mask differs from the naive loop" + (skipping ? ", skipping" : ""));
      RELIEVO_CHECK(caves->GetNumberOfAirSamples() == air);
    }
    // The function and the labels tell air from rock where the naive mask does.
    caves->SetContent(Caves::LABELS);
    caves->SetAirLabel(9);
    caves->SetRockLabel(4);
    caves->Update();
    const std::vector<double> labels = ValuesOf(caves->GetOutput());
    int mismatches = 0;
    for (vtkIdType i = 0; i < caves->GetOutput()->GetNumberOfPoints(); ++i)
    {
      double point[3];
      caves->GetOutput()->GetPoint(i, point);
      const bool inside = caves->GetFunction()->EvaluateFunction(point) < 0.;
      mismatches += inside != (naive[i] == 1.) || labels[i] != (inside ? 9. : 4.);
    }
    RELIEVO_CHECK_THAT(
      mismatches == 0, one.Name + ": " + std::to_string(mismatches) + " samples differ");
  }
}

// The density is the function's value, at most 1.
void TestDensity()
{
  vtkNew<Caves> caves;
  caves->SetSize(50, 40, 30);
  caves->SetContent(Caves::DENSITY);
  caves->SetScale(90.);
  std::vector<double> first;
  for (const bool skipping : { true, false })
  {
    caves->SetSkipping(skipping);
    caves->Update();
    const std::vector<double> values = ValuesOf(caves->GetOutput());
    double worst = 0.;
    for (vtkIdType i = 0; i < caves->GetOutput()->GetNumberOfPoints(); ++i)
    {
      double point[3];
      caves->GetOutput()->GetPoint(i, point);
      const double truth = std::min(caves->GetFunction()->EvaluateFunction(point), 1.);
      worst = std::max(worst, std::abs(truth - values[i]));
    }
    RELIEVO_CHECK_AT_MOST(worst, 1e-7, "density against the function");
    RELIEVO_CHECK(first.empty() || first == values);
    first = values;
  }
}

void TestPieces()
{
  for (const int content : { Caves::MASK, Caves::DENSITY })
  {
    vtkNew<Caves> caves;
    caves->SetSize(70, 45, 52);
    caves->SetContent(content);
    caves->SetSeed(11);
    std::vector<double> whole;
    for (const int threads : { 1, 2, 7 })
    {
      vtkSMPTools::Initialize(threads);
      caves->Modified();
      caves->Update();
      const std::vector<double> values = ValuesOf(caves->GetOutput());
      RELIEVO_CHECK(whole.empty() || whole == values);
      whole = values;
    }
    vtkSMPTools::Initialize(0);
    int mismatches = 0;
    vtkIdType samples = 0;
    const auto compare = [&](vtkImageData* piece) {
      const std::vector<double> values = ValuesOf(piece);
      int extent[6];
      piece->GetExtent(extent);
      std::size_t at = 0;
      for (int k = extent[4]; k <= extent[5]; ++k)
      {
        for (int j = extent[2]; j <= extent[3]; ++j)
        {
          for (int i = extent[0]; i <= extent[1]; ++i)
          {
            mismatches += values[at++] != whole[i + 70 * (j + 45 * k)];
          }
        }
      }
      samples += piece->GetNumberOfPoints();
    };
    for (const int count : { 2, 5 })
    {
      for (int piece = 0; piece < count; ++piece)
      {
        caves->UpdatePiece(piece, count, piece % 2);
        compare(caves->GetOutput());
      }
    }
    const int extents[][6] = { { 3, 3, 3, 3, 3, 3 }, { 0, 69, 7, 7, 1, 50 },
      { 13, 44, 5, 36, 20, 51 } };
    for (const auto& extent : extents)
    {
      caves->UpdateExtent(extent);
      compare(caves->GetOutput());
    }
    RELIEVO_CHECK(samples > 2 * 70 * 45 * 52);
    RELIEVO_CHECK_THAT(mismatches == 0, std::to_string(mismatches) + " samples of pieces differ");
  }
}

// The mean length of air along level lines, and along upright ones.
void TestWidth()
{
  constexpr int Side = 140;
  for (const double width : { 6., 11., 20. })
  {
    double air = 0.;
    double level = 0.;
    double upright = 0.;
    for (int seed = 0; seed < 3; ++seed)
    {
      vtkNew<Caves> caves;
      caves->SetSize(Side, Side, Side);
      caves->SetScale(45.);
      caves->SetSpacing(1., 1., 0.5);
      caves->SetTunnelWidth(width);
      caves->SetSeed(seed);
      caves->Update();
      vtkImageData* image = caves->GetOutput();
      const auto* mask = static_cast<unsigned char*>(image->GetScalarPointer());
      for (int k = 0; k + 1 < Side; ++k)
      {
        for (int j = 0; j + 1 < Side; ++j)
        {
          for (int i = 0; i + 1 < Side; ++i)
          {
            const unsigned char* at = mask + i + Side * (j + Side * k);
            air += at[0];
            level += 0.25 * (at[0] != at[1]) + 0.25 * (at[0] != at[Side]);
            upright += 0.5 * (at[0] != at[Side * Side]);
          }
        }
      }
    }
    const std::string name = "width " + std::to_string(static_cast<int>(width));
    RELIEVO_CHECK_NEAR(air / level, width, 0.1 * width, name + " along level lines");
    RELIEVO_CHECK_NEAR(0.5 * air / upright, 0.5 * width, 0.05 * width, name + ", upwards");
  }
}

// The benefit of skipping; the classic order evaluates the second noise where the first passes.
void TestEvaluations()
{
  vtkNew<Caves> caves;
  caves->SetSize(128, 128, 64);
  caves->SetScale(100.);
  caves->SetTunnelWidth(0.);
  const auto samples = 128. * 128. * 64.;
  caves->SkippingOff();
  caves->Update();
  const double classic = static_cast<double>(caves->GetNumberOfEvaluations()) / samples;
  RELIEVO_CHECK_NEAR(classic, 1.2, 0.06, "evaluations a sample, classic");
  caves->SkippingOn();
  caves->Update();
  RELIEVO_CHECK_AT_MOST(static_cast<double>(caves->GetNumberOfEvaluations()) / samples, 0.6,
    "evaluations a sample, skipping");
  // Where steps are long, skipping costs nothing.
  caves->SetScale(8.);
  caves->Update();
  RELIEVO_CHECK_AT_MOST(static_cast<double>(caves->GetNumberOfEvaluations()) / samples, 1.25,
    "evaluations a sample, coarse");
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testCaves)
{
  relievoTest::Session session;
  TestNaive();
  TestDensity();
  TestPieces();
  TestWidth();
  TestEvaluations();
  return session.Result();
}
}
