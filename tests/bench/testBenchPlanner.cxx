// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The bench of shadows' planner, small: its rows tell of ways that were measured, the best of them
// is the best, and choices for a tolerance are within what the planner promises.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"

#include <vtksys/SystemTools.hxx>

#include <map>
#include <string>
#include <utility>
#include <vector>

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

//------------------------------------------------------------------------------
int main()
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
  return session.Result();
}
