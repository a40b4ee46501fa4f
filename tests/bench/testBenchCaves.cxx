// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The measurements of the bench of caves, on shapes with known numbers; and the bench itself,
// small: its rows, equal masks from all orders, and its charts.
#include "BenchSizes.h"
#include "CaveShape.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace testBenchCaves
{
namespace
{
using relievoTest::Row;
using relievoTest::Value;

relievoBench::CaveShape ShapeOf(const std::function<bool(int, int, int)>& isAir)
{
  constexpr int Size = 24;
  std::vector<unsigned char> mask;
  for (int k = 0; k < Size; ++k)
  {
    for (int j = 0; j < Size; ++j)
    {
      for (int i = 0; i < Size; ++i)
      {
        mask.push_back(isAir(i, j, k));
      }
    }
  }
  return relievoBench::MeasureCaves(mask, { Size, Size, Size });
}

void TestShapes()
{
  const auto ball =
    ShapeOf([](int i, int j, int k) { return std::hypot(i - 11.2, j - 11.4, k - 11.6) < 7.; });
  RELIEVO_CHECK(ball.Components == 1 && ball.Euler == 1 && ball.Largest == 1.);
  // 4 V / S of a ball is 4 / 3 of its radius.
  RELIEVO_CHECK_NEAR(ball.LevelWidth, 4. / 3. * 7., 0.5, "mean length in a ball");
  RELIEVO_CHECK_NEAR(ball.UprightWidth, 4. / 3. * 7., 0.5, "mean length in a ball, upright");
  const auto ring = ShapeOf([](int i, int j, int k) {
    return std::hypot(std::hypot(i - 11., j - 11.) - 7., k - 11.) < 2.6;
  });
  RELIEVO_CHECK(ring.Components == 1 && ring.Euler == 0);
  const auto hollow = ShapeOf([](int i, int j, int k) {
    const double away = std::hypot(i - 11., j - 11., k - 11.);
    return away < 9. && away > 5.;
  });
  RELIEVO_CHECK(hollow.Components == 1 && hollow.Euler == 2);
  // Two cubes that touch at a corner are one; two apart are two.
  const auto touching = ShapeOf([](int i, int j, int k) {
    return (i == 3 && j == 3 && k == 3) || (i == 4 && j == 4 && k == 4);
  });
  RELIEVO_CHECK(touching.Components == 1 && touching.Euler == 1);
  const auto apart = ShapeOf([](int i, int j, int k) { return j == 3 && k == 3 && i % 4 == 1; });
  RELIEVO_CHECK(apart.Components == 6 && apart.Euler == 6);
  RELIEVO_CHECK_NEAR(apart.Largest, 1. / 6., 1e-12, "share of the largest");
  RELIEVO_CHECK_NEAR(apart.Air, 6. / 13824., 1e-12, "share of air");
}

void TestBench(const std::string& folder)
{
  relievoBench::CaveSizes sizes;
  sizes.Side = 48;
  sizes.Scales = { 16., 64. };
  sizes.Widths = { 0.2, 0.4 };
  sizes.Across = 5.;
  sizes.Rounds = 1;
  sizes.Seeds = 12;
  RELIEVO_CHECK(relievoBench::BenchCaves(folder, sizes) == 0);
  const std::vector<Row> rows = relievoTest::ReadCsv(folder + "/caves.csv");
  RELIEVO_CHECK(rows.size() == 6);
  for (const Row& row : rows)
  {
    RELIEVO_CHECK(Value(row, "different") == 0. && Value(row, "ns per sample") > 0.);
    const double most = row.at("method") == "naive" ? 2. : 1.3;
    RELIEVO_CHECK_AT_MOST(
      Value(row, "evaluations per sample"), most, row.at("method") + ", evaluations");
  }
  const std::vector<Row> widths = relievoTest::ReadCsv(folder + "/caves-width.csv");
  RELIEVO_CHECK(widths.size() == 2);
  for (const Row& row : widths)
  {
    RELIEVO_CHECK_NEAR(Value(row, "level over asked"), 1., 0.2, "width, of few tunnels");
  }
  RELIEVO_CHECK(relievoBench::DrawCharts("caves", folder));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchCaves)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/caves";
  vtksys::SystemTools::RemoveADirectory(folder);
  TestShapes();
  TestBench(folder);
  return session.Result();
}
}
