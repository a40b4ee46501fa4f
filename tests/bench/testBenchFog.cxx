// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the bench of fog with small sizes, and checks its CSV: all rows, errors as the formulas must
// have them, and its charts.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace testBenchFog
{
namespace
{
using relievoTest::Row;
using relievoTest::Value;

void CheckFog(const std::string& folder)
{
  relievoBench::FogSizes sizes;
  sizes.Rays = 3000;
  sizes.Distances = { 10., 1e3, 1e5 };
  sizes.Meshes = { "buildings" };
  sizes.Width = 120;
  sizes.Height = 90;
  sizes.Rounds = 3;
  RELIEVO_CHECK(relievoBench::BenchFog(folder, sizes) == 0);
  const std::vector<Row> rows = relievoTest::ReadCsv(folder + "/fog.csv");
  RELIEVO_CHECK(rows.size() == 12);
  std::map<std::string, std::map<double, Row>> all;
  for (const Row& row : rows)
  {
    all[row.at("method")][Value(row, "distance / radius")] = row;
    RELIEVO_CHECK(Value(row, "error in radii median") <= Value(row, "p99") &&
      Value(row, "p99") <= Value(row, "max"));
  }
  for (const double distance : sizes.Distances)
  {
    RELIEVO_CHECK_AT_MOST(Value(all["pairs of floats"][distance], "max"), 1e-5,
      "pairs of floats, " + std::to_string(distance) + " radii");
  }
  // Squares of the distance lose the digits of a radius, and later those of the distance itself.
  RELIEVO_CHECK(Value(all["textbook, float"][1e3], "max") > 0.5);
  RELIEVO_CHECK(Value(all["textbook, float"][1e5], "error in radii median") > 0.5);
  RELIEVO_CHECK(Value(all["perpendicular, float"][1e3], "max") > 1e-4);
  RELIEVO_CHECK(Value(all["perpendicular, float"][1e3], "max") <
    0.5 * Value(all["textbook, float"][1e3], "max"));
  const std::vector<Row> frames = relievoTest::ReadCsv(folder + "/fog-frames.csv");
  RELIEVO_CHECK(frames.size() == 9 && Value(frames.front(), "times a plain frame") == 1.);
  for (const Row& row : frames)
  {
    RELIEVO_CHECK_THAT(Value(row, "milliseconds") > 0. && std::isfinite(Value(row, "milliseconds")),
      row.at("frame"));
    // Plain, or without fog in view, nothing is held; a few pixels may be none in a small picture.
    const double share = Value(row, "share of the picture each");
    const double bytes = Value(row, "bytes per pixel");
    RELIEVO_CHECK_THAT(share == 0. ? bytes == 0. : share < 0.01 || bytes > 0., row.at("frame"));
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchFog)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/fog";
  vtksys::SystemTools::RemoveADirectory(folder);
  CheckFog(folder);
  RELIEVO_CHECK(relievoBench::DrawCharts("fog", folder));
  return session.Result();
}
}
