// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the bench of deferred shading with small sizes, and checks its CSV.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <string>
#include <vector>

namespace testBenchDeferred
{
RELIEVO_TEST_CASE(testBenchDeferred)
{
  relievoTest::Session session;
  using relievoTest::Value;
  const std::string folder = relievoTest::OutputFolder();
  relievoBench::DeferredSizes sizes;
  sizes.Overdraw = { 1, 3 };
  sizes.Lights = { 1, 2 };
  sizes.Pixels = 60;
  sizes.Rounds = 2;
  RELIEVO_CHECK(relievoBench::BenchDeferred(folder, sizes) == 0);
  const std::vector<relievoTest::Row> rows = relievoTest::ReadCsv(folder + "/deferred.csv");
  RELIEVO_CHECK_THAT(rows.size() == 16, "rows: " + std::to_string(rows.size()));
  for (const relievoTest::Row& row : rows)
  {
    const bool own = row.at("way") == "VTK's shading";
    RELIEVO_CHECK(Value(row, "milliseconds") > 0. && Value(row, "times VTK's") > 0.);
    // Depth, normal and colour; with highlights, more words. Textures on a GPU have four of them,
    // in software OpenGL two, and so one word less is empty.
    const double most = own ? 0. : row.at("surface") == "matte" ? 16. : 32.;
    const double bytes = Value(row, "bytes a pixel");
    RELIEVO_CHECK_THAT(bytes == most || (!own && bytes == most - 4.),
      row.at("surface") + " " + row.at("bytes a pixel"));
  }
  RELIEVO_CHECK(relievoBench::DrawCharts("deferred", folder));
  return session.Result();
}
}
