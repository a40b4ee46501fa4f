// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The bench of exact shadows where edges lie densely, small: that no more is wrong than is
// expected, that the expectation follows the edges, and its chart.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <map>
#include <string>

namespace testBenchExactHard
{
//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchExactHard)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/exact-hard";
  vtksys::SystemTools::RemoveADirectory(folder);
  relievoBench::ExactHardSizes sizes;
  sizes.Scenes = { "fins", "arrows", "tree" };
  sizes.Width = 500;
  sizes.Height = 400;
  RELIEVO_CHECK(relievoBench::BenchExactHard(folder, sizes) == 0);
  const auto rows = relievoTest::ReadCsv(folder + "/exact-hard.csv");
  RELIEVO_CHECK(rows.size() == 3 * 3);
  std::map<std::string, double> expected;
  for (const auto& row : rows)
  {
    const std::string what = row.at("scene") + ", " + row.at("light");
    const double error = relievoTest::Value(row, "wrong %");
    const double share = relievoTest::Value(row, "expected %");
    RELIEVO_CHECK_THAT(relievoTest::Value(row, "pixels") > 20000., what);
    RELIEVO_CHECK_AT_MOST(error, 1.5 * share, what + ": % wrong");
    RELIEVO_CHECK_AT_MOST(
      relievoTest::Value(row, "wrong without ties %"), 0.5 * share, what + ": % without ties");
    expected[row.at("scene")] += share;
  }
  RELIEVO_CHECK(expected["arrows"] > 2. * expected["tree"]);
  RELIEVO_CHECK(expected["tree"] > expected["fins"]);
  RELIEVO_CHECK(relievoBench::DrawCharts("exact-hard", folder));
  return session.Result();
}
}
