// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The bench of the shadow planner, small: its rows refer to measured methods, the best of them is
// the best, and choices for a tolerance are within the planner's promise.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace testBenchPlanner
{
namespace
{
using relievoTest::Row;
using relievoTest::Value;
using Ways = std::map<std::pair<std::string, std::string>, Row>;

const Row& Find(const Ways& ways, const Row& row, const std::string& prefix)
{
  return ways.at({ row.at(prefix + "method"), row.at(prefix + "map") });
}

void TestChoices(const std::vector<Row>& choices, const Ways& ways)
{
  RELIEVO_CHECK(choices.size() == 5);
  for (const Row& row : choices)
  {
    const double tolerance = Value(row, "tolerance %");
    const std::string what = "tolerance " + row.at("tolerance %");
    RELIEVO_CHECK_THAT(Find(ways, row, "").at("wrong %") == row.at("wrong %"), what);
    RELIEVO_CHECK_AT_MOST(Value(row, "wrong %"), 3. * tolerance, what);
    if (row.at("best method") != "none")
    {
      const Row& best = Find(ways, row, "best ");
      RELIEVO_CHECK_AT_MOST(Value(best, "wrong %"), tolerance, what + ": the best way");
      for (const auto& way : ways)
      {
        RELIEVO_CHECK_THAT(Value(way.second, "wrong %") > tolerance ||
            Value(way.second, "frame ms") >= Value(best, "frame ms"),
          what + ": a better way than the best");
      }
    }
  }
}

void TestBudgets(const std::vector<Row>& budgets, const Ways& ways)
{
  RELIEVO_CHECK(budgets.size() == 3);
  for (const Row& row : budgets)
  {
    const std::string what = "budget " + row.at("budget ms");
    RELIEVO_CHECK_THAT(Find(ways, row, "").at("wrong %") == row.at("wrong %"), what);
    const Row& best = Find(ways, row, "best ");
    RELIEVO_CHECK_AT_MOST(Value(best, "frame ms"), Value(row, "budget ms"), what);
    RELIEVO_CHECK(Value(row, "taken ms") > 0.);
    for (const auto& way : ways)
    {
      RELIEVO_CHECK_THAT(Value(way.second, "frame ms") > Value(row, "budget ms") ||
          Value(way.second, "wrong %") >= Value(best, "wrong %"),
        what + ": a more accurate way than the best");
    }
  }
}
}

// Cases by lot: the promise holds, and both maps and rays are chosen.
void TestCases(const std::string& folder)
{
  relievoBench::PlannerCaseSizes sizes;
  sizes.Scenes = 6;
  sizes.Seed = 4;
  sizes.Width = 320;
  sizes.Height = 240;
  RELIEVO_CHECK(relievoBench::BenchPlannerCases(folder, sizes) == 0);
  const auto rows = relievoTest::ReadCsv(folder + "/planner-cases.csv");
  RELIEVO_CHECK(rows.size() == 30);
  int over = 0;
  std::map<std::string, int> methods;
  for (const Row& row : rows)
  {
    const double times = Value(row, "wrong %") / Value(row, "tolerance %");
    RELIEVO_CHECK_NEAR(Value(row, "wrong / tolerance"), times, 1e-3 * times, "times the tolerance");
    RELIEVO_CHECK_AT_MOST(times, 3., "scene " + row.at("scene") + ": times the tolerance");
    over += times > 1.5 ? 1 : 0;
    ++methods[row.at("method")];
  }
  RELIEVO_CHECK_AT_MOST(over, 2, "of 30 cases, over 1.5 times the tolerance");
  RELIEVO_CHECK(methods["exact"] > 0 && methods["map"] > 0);
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchPlanner)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/planner";
  vtksys::SystemTools::RemoveADirectory(folder);
  relievoBench::PlannerSizes sizes;
  sizes.Scenes = { "spheres" };
  sizes.Windows = { { 240, 180 } };
  sizes.Lights = 1;
  sizes.Rounds = 3;
  RELIEVO_CHECK(relievoBench::BenchPlanner(folder, sizes) == 0);
  Ways ways;
  for (const Row& row : relievoTest::ReadCsv(folder + "/planner.csv"))
  {
    RELIEVO_CHECK(Value(row, "wrong %") >= 0. && Value(row, "frame ms") > 0.);
    ways[{ row.at("method"), row.at("map") }] = row;
  }
  RELIEVO_CHECK_THAT(ways.size() == 2 * sizes.Maps.size() + 1,
    std::to_string(ways.size()) + " ways: map and warped of each size, and exact");
  TestChoices(relievoTest::ReadCsv(folder + "/planner-choices.csv"), ways);
  TestBudgets(relievoTest::ReadCsv(folder + "/planner-budgets.csv"), ways);
  RELIEVO_CHECK(relievoBench::DrawCharts("planner", folder));
  TestCases(folder);
  return session.Result();
}
}
