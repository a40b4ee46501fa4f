// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Options of surfaces of blocks compared with their definitions: normals within materials and where
// they cancel out; rigid and level labels; noise; weights of materials.
#include "BlockScenes.h"
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoSmoothBlocks.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace testSmoothBlocksOptions
{
namespace
{
using namespace relievoTest;
using Filter = vtkRelievoSmoothBlocks;

// Each normal is the sum of the areas of all triangles at its place that have its material, or any.
// The corners at both ends of a diagonal see both triangles, the others one: so quads are compared.
void TestNormals()
{
  const LabelOf ball = BallOf(5.2, { 6.1, 6.2, 6.3 });
  const auto label = [&](int i, int j, int k) { return ball(i, j, k) * (i < 6 ? 1 : 2); };
  for (const int merging : { Filter::ACROSS_MATERIALS, Filter::WITHIN_MATERIALS })
  {
    vtkNew<Filter> filter;
    filter->SetNormals(merging);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    vtkPolyData* surface = Run(filter, MakeBlocks({ 12, 12, 12 }, label));
    const bool within = merging == Filter::WITHIN_MATERIALS;
    vtkDataArray* materials = surface->GetCellData()->GetArray("material");
    const auto keyOf = [&](const Place& place, vtkIdType cell) {
      return std::make_pair(place, within ? materials->GetComponent(cell, 0) : 0.);
    };
    std::map<std::pair<Place, double>, Place> sums;
    Place first[3];
    ForEachTriangle(surface, [&](vtkIdType cell, vtkIdList*, const Place* corners) {
      if (cell % 2 == 0)
      {
        std::copy(corners, corners + 3, first);
        return;
      }
      // Two triangles of a face: their areas' sum goes to all four corners.
      double both[3];
      double area[3];
      AreaOf(first, both);
      AreaOf(corners, area);
      vtkMath::Add(both, area, both);
      for (const Place& place : { first[0], first[1], first[2], corners[2] })
      {
        Place& sum = sums[keyOf(place, cell)];
        vtkMath::Add(sum.data(), both, sum.data());
      }
    });
    double worst = 0.;
    ForEachTriangle(surface, [&](vtkIdType cell, vtkIdList* ids, const Place* corners) {
      for (int c = 0; c < 3; ++c)
      {
        Place expected = sums[keyOf(corners[c], cell)];
        vtkMath::Normalize(expected.data());
        double normal[3];
        surface->GetPointData()->GetNormals()->GetTuple(ids->GetId(c), normal);
        worst =
          std::max(worst, std::sqrt(vtkMath::Distance2BetweenPoints(expected.data(), normal)));
      }
    });
    RELIEVO_CHECK_AT_MOST(worst, 1e-6, within ? "normals within materials" : "normals");
    const auto places = static_cast<vtkIdType>(sums.size());
    RELIEVO_CHECK(surface->GetNumberOfPoints() == places);
  }
}

// Inside a checkerboard normals cancel out at every point: each face there has its own.
void TestNullNormals(double strength)
{
  vtkNew<Filter> filter;
  filter->SetStrength(strength);
  vtkPolyData* surface = Run(filter,
    MakeBlocks({ 7, 7, 7 }, [](int i, int j, int k) { return vtkTypeInt64((i + j + k) & 1); }));
  int mismatches = 0;
  int inner = 0;
  ForEachTriangle(surface, [&](vtkIdType, vtkIdList* ids, const Place* corners) {
    double area[3];
    AreaOf(corners, area);
    vtkMath::Normalize(area);
    for (int c = 0; c < 3; ++c)
    {
      const auto isInner = [](double x) { return x > 1.5 && x < 5.5; };
      if (isInner(corners[c][0]) && isInner(corners[c][1]) && isInner(corners[c][2]))
      {
        double normal[3];
        surface->GetPointData()->GetNormals()->GetTuple(ids->GetId(c), normal);
        mismatches += !(vtkMath::Dot(area, normal) > 0.9);
        ++inner;
      }
    }
  });
  RELIEVO_CHECK(inner > 1000);
  RELIEVO_CHECK_THAT(
    mismatches == 0, std::to_string(mismatches) + " normals do not belong to their face");
}

// Ground with a step of each kind of label; rigid blocks beside it stay cubes.
void TestRigidAndLevel()
{
  const auto label = [](int i, int j, int k) {
    const int height = 2 + AnyOf(3, 3)(i, j, 0);
    return vtkTypeInt64(k < height ? (i < 6 ? 1 : (i < 12 ? 2 : 3)) : 0);
  };
  vtkNew<Filter> filter;
  filter->AddRigidLabel(2);
  filter->AddLevelLabel(3);
  filter->SetNoiseAmplitude(0.4);
  filter->SetNoiseScale(3.);
  filter->SetStrength(0.25);
  RELIEVO_CHECK(filter->GetNumberOfRigidLabels() == 1 && filter->GetNumberOfLevelLabels() == 1);
  vtkPolyData* surface = Run(filter, MakeBlocks({ 18, 9, 7 }, label));
  RELIEVO_CHECK(UnlistedEdges(surface, filter->GetOutput(1)) == 0);
  vtkDataArray* materials = surface->GetCellData()->GetArray("material");
  const auto isWhole = [](double x) { return x == std::round(x); };
  int moved[4] = {};
  ForEachTriangle(surface, [&](vtkIdType cell, vtkIdList*, const Place* corners) {
    const auto material = static_cast<int>(materials->GetComponent(cell, 0));
    for (int c = 0; c < 3; ++c)
    {
      moved[0] += material == 1 && !isWhole(corners[c][2]);
      moved[1] += material == 2 &&
        !(isWhole(corners[c][0]) && isWhole(corners[c][1]) && isWhole(corners[c][2]));
      moved[2] += material == 3 && !isWhole(corners[c][2]);
      moved[3] += material == 3 && !isWhole(corners[c][0]);
    }
  });
  RELIEVO_CHECK_THAT(moved[0] > 100, "the ground is not smooth");
  RELIEVO_CHECK_THAT(moved[1] == 0, "a rigid block moved");
  RELIEVO_CHECK_THAT(moved[2] == 0, "a level block has slopes or noise");
  RELIEVO_CHECK_THAT(moved[3] > 10, "a level block's shore is not smooth");
  filter->ClearRigidLabels();
  filter->ClearLevelLabels();
  RELIEVO_CHECK(filter->GetNumberOfRigidLabels() == 0 && filter->GetNumberOfLevelLabels() == 0);
}

void TestNoise()
{
  const auto label = [](int, int, int k) { return vtkTypeInt64(k < 2); };
  vtkSmartPointer<vtkImageData> image = MakeBlocks({ 40, 40, 4 }, label);
  std::map<std::pair<double, double>, double> heights[3];
  double sum = 0.;
  double lowest = 2.;
  double highest = 2.;
  for (int seed = 0; seed < 3; ++seed)
  {
    vtkNew<Filter> filter;
    filter->SetStrength(0.);
    filter->SetNoiseAmplitude(0.5);
    filter->SetNoiseScale(3.);
    filter->SetNoiseSeed(seed);
    filter->SetNoiseDimensions(seed == 2 ? 3 : 2);
    vtkPolyData* surface = Run(filter, image);
    bool columns = true;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      double place[3];
      surface->GetPoint(i, place);
      const double offset = place[2] - std::round(place[2] / 2.) * 2.;
      if (place[2] > 1.5)
      {
        heights[seed][{ place[0], place[1] }] = place[2] - 2.;
        sum += seed == 0 ? place[2] - 2. : 0.;
        lowest = std::min(lowest, place[2]);
        highest = std::max(highest, place[2]);
      }
      else if (place[2] < 0.6 && place[2] > -0.6)
      {
        // The bottom moves with the top where the noise does not depend on height.
        const auto top = heights[seed].find({ place[0], place[1] });
        columns = columns && (top == heights[seed].end() || std::abs(top->second - offset) < 1e-6);
      }
    }
    RELIEVO_CHECK(seed == 2 || columns);
  }
  RELIEVO_CHECK_NEAR(sum / 1681., 0., 0.1, "mean of noise");
  RELIEVO_CHECK_AT_MOST(highest - 2., 0.5, "highest noise of amplitude 0.5");
  RELIEVO_CHECK_AT_MOST(2. - highest, -0.25, "highest noise, negative");
  RELIEVO_CHECK_AT_MOST(2. - lowest, 0.5, "lowest noise, negative");
  RELIEVO_CHECK_AT_MOST(lowest - 2., -0.25, "lowest noise");
  RELIEVO_CHECK(heights[0] != heights[1] && heights[0] != heights[2]);
}

// Weights do not depend on which side of a face is the lower one: the mirror image has the same.
void TestMirroredWeights()
{
  const LabelOf any = AnyOf(11, 4);
  std::map<Place, Place> weights[2];
  for (const bool mirrored : { false, true })
  {
    vtkNew<Filter> filter;
    filter->MaterialWeightsOn();
    filter->SetSurface(Filter::BETWEEN_LABELS);
    filter->SetNormals(Filter::NO_NORMALS);
    filter->SetStrength(0.);
    vtkPolyData* surface = Run(filter, MakeBlocks({ 7, 6, 5 }, [&](int i, int j, int k) {
      return mirrored ? any(6 - i, 5 - j, 4 - k) : any(i, j, k);
    }));
    vtkDataArray* array = surface->GetPointData()->GetArray("weights");
    RELIEVO_CHECK(array && array->GetNumberOfComponents() == 3);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      Place place;
      surface->GetPoint(i, place.data());
      if (mirrored)
      {
        place = { 7. - place[0], 6. - place[1], 5. - place[2] };
      }
      Place found;
      array->GetTuple(i, found.data());
      RELIEVO_CHECK_NEAR(found[0] + found[1] + found[2], 1., 1e-6, "sum of weights");
      weights[mirrored][place] = found;
    }
  }
  RELIEVO_CHECK(weights[0].size() > 200);
  RELIEVO_CHECK_THAT(weights[0] == weights[1], "weights of the mirror image differ");
}

void TestWeights()
{
  vtkNew<Filter> filter;
  filter->MaterialWeightsOn();
  const LabelOf ball = BallOf(4.2, { 5., 5., 5. });
  vtkPolyData* surface = Run(filter, MakeBlocks({ 10, 10, 10 }, [&](int i, int j, int k) {
    return ball(i, j, k) * (k < 5 ? 7 : 300);
  }));
  vtkDataArray* weights = surface->GetPointData()->GetArray("weights");
  RELIEVO_CHECK(weights && weights->GetNumberOfComponents() == 2);
  RELIEVO_CHECK(std::string(weights->GetComponentName(0)) == "7");
  RELIEVO_CHECK(std::string(weights->GetComponentName(1)) == "300");
  int mixed = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double place[3];
    surface->GetPoint(i, place);
    const double low = weights->GetComponent(i, 0);
    RELIEVO_CHECK_NEAR(low + weights->GetComponent(i, 1), 1., 1e-6, "sum of weights");
    // Materials meet at height 5 only.
    RELIEVO_CHECK(std::abs(place[2] - 5.) < 0.4 || low == (place[2] < 5. ? 1. : 0.));
    mixed += low > 0. && low < 1.;
  }
  RELIEVO_CHECK(mixed > 20);
  // Chosen labels, also one without faces.
  filter->AddWeightedLabel(5);
  filter->AddWeightedLabel(7);
  filter->Update();
  weights = filter->GetOutput()->GetPointData()->GetArray("weights");
  RELIEVO_CHECK(weights->GetNumberOfComponents() == 2 && weights->GetRange(0)[1] == 0. &&
    weights->GetRange(1)[1] == 1.);
  // More labels than there can be components.
  filter->ClearWeightedLabels();
  filter->SetInputData(MakeBlocks({ 6, 6, 6 }, AnyOf(1, 100)));
  {
    ExpectMessage expect("at most 64");
    filter->Update();
    RELIEVO_CHECK(expect.Count() == 1 && filter->GetErrorCode() == vtkErrorCode::UserError);
  }
  RELIEVO_CHECK(filter->GetOutput()->GetNumberOfPolys() > 0);
  RELIEVO_CHECK(!filter->GetOutput()->GetPointData()->GetArray("weights"));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testSmoothBlocksOptions)
{
  relievoTest::Session session;
  TestNormals();
  TestNullNormals(0.125);
  TestNullNormals(0.07);
  TestRigidAndLevel();
  TestNoise();
  TestWeights();
  TestMirroredWeights();
  return session.Result();
}
}
