// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the bench of particles with a small size, and checks its CSV files: all rows, distances to
// the surface, and its charts.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <map>
#include <string>

namespace testBenchParticles
{
//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchParticles)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/particles";
  vtksys::SystemTools::RemoveADirectory(folder);
  relievoBench::ParticleSizes sizes;
  sizes.Numbers = { 100, 1000 };
  sizes.Rounds = 3;
  sizes.Resolution = 48;
  sizes.Chord = 2e-3;
  sizes.DriftNumber = 200;
  sizes.Steps = { 10, 100 };
  sizes.Meshes.clear();
  RELIEVO_CHECK(relievoBench::BenchParticles(folder, sizes) == 0);
  std::map<std::string, int> rows;
  for (const relievoTest::Row& row : relievoTest::ReadCsv(folder + "/particles.csv"))
  {
    ++rows[row.at("method")];
    RELIEVO_CHECK(relievoTest::Value(row, "milliseconds") > 0.);
    RELIEVO_CHECK(relievoTest::Value(row, "core milliseconds") >= 0.);
  }
  RELIEVO_CHECK(rows["depth maps"] == 2 && rows["closest point"] == 2);
  rows.clear();
  for (const relievoTest::Row& row : relievoTest::ReadCsv(folder + "/particles-drift.csv"))
  {
    const std::string& method = row.at("method");
    ++rows[method];
    const double largest = relievoTest::Value(row, "largest texels");
    RELIEVO_CHECK_THAT(
      method == "not held" ? largest > 1. : largest < 1., method + ": " + row.at("largest texels"));
  }
  RELIEVO_CHECK(rows["depth maps"] == 2 && rows["not held"] == 2);
  RELIEVO_CHECK(relievoBench::DrawCharts("particles", folder));
  return session.Result();
}
}
