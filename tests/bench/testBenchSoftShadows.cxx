// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The bench of soft shadows, small: its rows, that more samples err less, and its chart.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <string>
#include <vector>

namespace testBenchSoftShadows
{
//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchSoftShadows)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/soft-shadows";
  vtksys::SystemTools::RemoveADirectory(folder);
  relievoBench::SoftShadowSizes sizes;
  sizes.Scenes = { "spheres" };
  sizes.Samples = { 1, 4, 16 };
  sizes.Width = 120;
  sizes.Height = 90;
  RELIEVO_CHECK(relievoBench::BenchSoftShadows(folder, sizes) == 0);
  const auto rows = relievoTest::ReadCsv(folder + "/soft-shadows.csv");
  RELIEVO_CHECK(rows.size() == 7 * 2 * 3);
  for (std::size_t i = 0; i + 2 < rows.size(); i += 3)
  {
    const double hard = relievoTest::Value(rows[i], "penumbra rms");
    const double few = relievoTest::Value(rows[i + 1], "penumbra rms");
    const double many = relievoTest::Value(rows[i + 2], "penumbra rms");
    RELIEVO_CHECK_AT_MOST(few, 0.75 * hard, "error of 4 samples in group " + std::to_string(i));
    // The map's own error at edges stays, however many samples there are.
    const double share = rows[i].at("method") == "map" ? 0.75 : 0.5;
    RELIEVO_CHECK_AT_MOST(many, share * few, "error of 16 samples in group " + std::to_string(i));
  }
  RELIEVO_CHECK(relievoBench::DrawCharts("soft-shadows", folder));
  return session.Result();
}
}
