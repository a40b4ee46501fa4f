// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the bench of tones without its frames, and checks its CSV: all rows, and the required
// accuracy of operators and dithering.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <map>
#include <string>
#include <vector>

namespace testBenchTone
{
namespace
{
using relievoTest::Row;
using relievoTest::Value;

std::map<std::string, Row> ReadBy(const std::string& path, const std::string& column)
{
  std::map<std::string, Row> rows;
  for (const Row& row : relievoTest::ReadCsv(path))
  {
    rows[row.at(column)] = row;
  }
  return rows;
}

void CheckOperators(const std::string& folder)
{
  auto rows = ReadBy(folder + "/tone.csv", "operator");
  RELIEVO_CHECK(rows.size() == 5);
  for (const auto& [name, row] : rows)
  {
    // The nearest byte; float's rounding as in testFormulasTone.
    RELIEVO_CHECK_AT_MOST(
      Value(row, "picture, largest error, steps of 255"), 0.501, name + ", picture");
    RELIEVO_CHECK_AT_MOST(Value(row, "formula in float, largest error"), 1.7e-6, name + ", float");
  }
  for (const char* name : { "reinhard", "neutral" })
  {
    RELIEVO_CHECK_AT_MOST(Value(rows[name], "hue turned, most degrees"), 1e-9, name);
  }
  for (const char* name : { "clamp", "simple", "reinhard_rgb" })
  {
    RELIEVO_CHECK_THAT(Value(rows[name], "hue turned, most degrees") > 10., name);
  }
}

void CheckCurves(const std::string& folder)
{
  const std::vector<Row> rows = relievoTest::ReadCsv(folder + "/tone-curves.csv");
  RELIEVO_CHECK(rows.size() == 5 * 25);
  for (const Row& row : rows)
  {
    const std::string what = row.at("operator") + " at " + row.at("stops");
    const double grey = Value(row, "grey, steps of 255");
    if (row.at("operator") == "neutral")
    {
      // Light of 1 is 1 - 0.24^2 / 0.44 = 0.8691, in sRGB 240 of 255.
      RELIEVO_CHECK_THAT(Value(row, "stops") != 0. || grey == 240., what);
    }
    else if (row.at("operator") != "simple")
    {
      const double white = row.at("operator") == "clamp" ? 0. : 2.;
      RELIEVO_CHECK_THAT((grey == 255.) == (Value(row, "stops") >= white), what);
    }
    else
    {
      RELIEVO_CHECK_THAT(grey < 255., what);
    }
  }
}

void CheckDithering(const std::string& folder)
{
  auto rows = ReadBy(folder + "/tone-dither.csv", "dither");
  RELIEVO_CHECK(rows.size() == 3);
  const std::string mean = "mean of 16 x 16, largest error, steps of 255";
  const std::string pixel = "pixel, largest error";
  const std::string run = "longest run of one value, pixels";
  RELIEVO_CHECK(Value(rows["none"], mean) > 0.4 && Value(rows["none"], run) > 100.);
  RELIEVO_CHECK_AT_MOST(Value(rows["none"], pixel), 0.501, "no dithering, a pixel");
  for (const char* name : { "ordered", "blue_noise" })
  {
    RELIEVO_CHECK_AT_MOST(Value(rows[name], mean), 0.05, std::string(name) + ", mean");
    RELIEVO_CHECK_AT_MOST(Value(rows[name], pixel), 1., std::string(name) + ", a pixel");
    RELIEVO_CHECK_AT_MOST(Value(rows[name], run), 64., std::string(name) + ", run");
  }
  RELIEVO_CHECK(relievoTest::ReadCsv(folder + "/tone-bands.csv").size() == 3 * 32);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchTone)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/tone";
  vtksys::SystemTools::RemoveADirectory(folder);
  relievoBench::ToneSizes sizes;
  sizes.Side = 96;
  sizes.Rounds = 0;
  RELIEVO_CHECK(relievoBench::BenchTone(folder, sizes) == 0);
  CheckOperators(folder);
  CheckCurves(folder);
  CheckDithering(folder);
  RELIEVO_CHECK(relievoBench::DrawCharts("tone", folder));
  return session.Result();
}
}
