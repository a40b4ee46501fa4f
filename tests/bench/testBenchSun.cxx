// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the bench of hours of sun with a small size, and checks its CSV: errors decrease with steps
// and rays to the documented values; and its chart.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

namespace testBenchSun
{
RELIEVO_TEST_CASE(testBenchSun)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/sun";
  vtksys::SystemTools::RemoveADirectory(folder);
  relievoBench::SunSizes sizes;
  sizes.Side = 10;
  sizes.Steps = { 60., 5. };
  sizes.Samples = { 16, 4096 };
  sizes.TruthStep = 20.;
  sizes.Rounds = 1;
  RELIEVO_CHECK(relievoBench::BenchSun(folder, sizes) == 0);
  const auto rows = relievoTest::ReadCsv(folder + "/sun.csv");
  RELIEVO_CHECK(rows.size() == 4);
  const auto get = [&rows](std::size_t row, const char* column) {
    return relievoTest::Value(rows[row], column);
  };
  RELIEVO_CHECK(get(0, "rms") > 2. * get(1, "rms") && get(2, "rms") > 4. * get(3, "rms"));
  RELIEVO_CHECK_AT_MOST(get(1, "most"), 2. * 5. / 60., "hours by steps of 5 minutes");
  RELIEVO_CHECK_AT_MOST(get(3, "most"), 0.005, "share of the sky by 4096 rays");
  RELIEVO_CHECK(relievoBench::DrawCharts("sun", folder));
  return session.Result();
}
}
