// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the bench of environments or of relief with small sizes, and checks its CSV: all rows, the
// columns as the charts' page names them, and errors as the methods must have them.
//   testBenchMaterials environment|relief
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
#include <utility>
#include <vector>

namespace testBenchMaterials
{
namespace
{
using relievoTest::Row;
using relievoTest::Value;

// Errors of a map by its texels, fewest first.
using Curve = std::map<double, double>;

void CheckEnvironment(const std::string& folder)
{
  relievoBench::EnvironmentSizes sizes;
  sizes.Looks = 5000;
  sizes.Turns = 2;
  sizes.Sides = { 8, 16, 32 };
  sizes.Detail = 300.;
  sizes.RealWorlds = false;
  sizes.Sky = 32;
  sizes.Width = 160;
  sizes.Height = 90;
  sizes.Rounds = 3;
  RELIEVO_CHECK(relievoBench::BenchEnvironment(folder, sizes) == 0);
  const std::vector<Row> rows = relievoTest::ReadCsv(folder + "/environment.csv");
  RELIEVO_CHECK_THAT(rows.size() == 15, "rows: " + std::to_string(rows.size()));
  std::map<std::string, Curve> curves;
  for (const Row& row : rows)
  {
    const std::string name = row.at("map") + ", " + row.at("texels");
    const double texels = Value(row, "texels");
    const double error = Value(row, "RMS error / mean light");
    RELIEVO_CHECK(row.at("environment") == "sky and lobes");
    curves[row.at("map")][texels] = error;
    // The whole lies between the best and the worst belt.
    double least = INFINITY;
    double most = 0.;
    for (const char* belt : { "0 to 30 degrees", "60 to 120 degrees", "150 to 180 degrees" })
    {
      least = std::min(least, Value(row, belt));
      most = std::max(most, Value(row, belt));
    }
    RELIEVO_CHECK_THAT(least > 0.2 * error && most < 5. * error && least <= most, name);
  }
  RELIEVO_CHECK(curves.size() == 5);
  for (const auto& [map, curve] : curves)
  {
    if (!RELIEVO_CHECK_THAT(curve.size() == 3, map))
    {
      continue;
    }
    double last = INFINITY;
    double lastTexels = 0.;
    for (const auto& [texels, error] : curve)
    {
      // Texels half as wide: lobes that are met better and better, by up to a quarter.
      RELIEVO_CHECK_THAT(error < 0.65 * last && error > 0.2 * (std::isinf(last) ? 0. : last),
        map + ", " + std::to_string(texels) + " texels: " + std::to_string(error));
      RELIEVO_CHECK(texels > 3. * lastTexels);
      last = error;
      lastTexels = texels;
    }
    // The narrowest lobe, 3 degrees, is less than a texel of the first.
    RELIEVO_CHECK_AT_MOST(curve.begin()->second, 0.3, map + ", fewest texels");
    RELIEVO_CHECK_AT_MOST(last, 0.05, map + ", most texels");
  }
  const auto finest = [&curves](const char* map) { return curves[map].rbegin()->second; };
  RELIEVO_CHECK(finest("cube") < finest("lat-long") && finest("cube") < finest("sphere map"));
  const std::vector<Row> frames = relievoTest::ReadCsv(folder + "/environment-frames.csv");
  RELIEVO_CHECK(frames.size() == 4 && Value(frames.front(), "times a plain frame") == 1.);
  for (const Row& row : frames)
  {
    RELIEVO_CHECK_THAT(Value(row, "ms") > 0. && std::isfinite(Value(row, "ms")) &&
        Value(row, "times a plain frame") > 0.,
      row.at("frame"));
  }
}

void CheckGeometry(const std::string& folder)
{
  const std::vector<Row> rows = relievoTest::ReadCsv(folder + "/relief-geometry.csv");
  RELIEVO_CHECK(rows.size() == 6);
  for (const Row& row : rows)
  {
    const double time = Value(row, "ms");
    RELIEVO_CHECK_THAT(time > 0. && std::isfinite(time) && Value(row, "times the plane") > 0. &&
        Value(row, "times the full geometry") > 0.,
      row.at("drawn"));
  }
  RELIEVO_CHECK(rows.back().at("drawn") == "full geometry, 32768 triangles");
  RELIEVO_CHECK(Value(rows.front(), "times the plane") == 1.);
}

void CheckRelief(const std::string& folder)
{
  relievoBench::ReliefSizes sizes;
  sizes.Texels = 128;
  sizes.FullCells = 128;
  sizes.Width = 150;
  sizes.Height = 112;
  sizes.Rounds = 2;
  sizes.Angles = { 60., 75. };
  RELIEVO_CHECK(relievoBench::BenchRelief(folder, sizes) == 0);
  const std::vector<Row> rows = relievoTest::ReadCsv(folder + "/relief.csv");
  RELIEVO_CHECK_THAT(rows.size() == 48, "rows: " + std::to_string(rows.size()));
  std::map<std::string, Row> waves;
  std::map<std::string, Row> posts; // at 75 degrees
  for (const Row& row : rows)
  {
    const bool steep = Value(row, "degrees") == 75.;
    if (row.at("field") == "waves" && !steep)
    {
      waves[row.at("method")] = row;
    }
    else if (row.at("field") == "posts 4 texels thin" && steep)
    {
      posts[row.at("method")] = row;
    }
    RELIEVO_CHECK(Value(row, "times a plain frame (waves, 60)") > 0.);
    RELIEVO_CHECK(Value(row, "missed %") >= 0. && Value(row, "missed %") <= 100.);
  }
  RELIEVO_CHECK(waves.size() == 12 && posts.size() == 12);
  const auto depth = [&waves](const std::string& method) {
    return Value(waves[method], "depth error % of height");
  };
  const auto looks = [&waves](const std::string& method) { return Value(waves[method], "looks"); };
  const auto missed = [&posts](
                        const std::string& method) { return Value(posts[method], "missed %"); };
  // Doubling the steps halves the misses; a line between two steps quarters them and more.
  for (const auto& [fine, coarse] : { std::pair<const char*, const char*>("steep 32", "steep 16"),
         std::pair<const char*, const char*>("steep 64", "steep 32") })
  {
    RELIEVO_CHECK_AT_MOST(depth(fine), 0.7 * depth(coarse), std::string(fine) + ": depth error %");
    RELIEVO_CHECK(looks(fine) > 1.5 * looks(coarse));
  }
  for (const char* steps : { " 16", " 32", " 64" })
  {
    const std::string all = steps;
    RELIEVO_CHECK_AT_MOST(
      depth("occlusion" + all), 0.5 * depth("steep" + all), "occlusion" + all + ": depth error %");
    RELIEVO_CHECK_AT_MOST(
      depth("relief" + all), depth("occlusion" + all), "relief" + all + ": depth error %");
    RELIEVO_CHECK(std::abs(looks("relief" + all) - looks("occlusion" + all) - 6.) < 0.01);
  }
  const std::string chosen = "relief, by texels (default)";
  RELIEVO_CHECK_AT_MOST(depth(chosen), 0.12, "default: depth error %");
  RELIEVO_CHECK_AT_MOST(Value(waves[chosen], "missed %"), 1., "default: missed % of waves");
  RELIEVO_CHECK_AT_MOST(Value(waves[chosen], "normal error degrees"), 1., "default: normals");
  RELIEVO_CHECK(Value(waves["parallax"], "missed %") > 10. && looks("parallax") == 1.);
  RELIEVO_CHECK_AT_MOST(missed(chosen), missed("relief 16"), "default: posts missed, %");
  RELIEVO_CHECK(missed("relief 64") < missed("relief 16") && missed("relief 16") < 50.);
  CheckGeometry(folder);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchMaterials)
{
  relievoTest::Session session;
  const std::string name = argc > 1 ? argv[1] : "";
  const std::string folder = relievoTest::OutputFolder() + "/" + name;
  vtksys::SystemTools::RemoveADirectory(folder);
  const bool relief = name == "relief";
  (relief ? CheckRelief : CheckEnvironment)(folder);
  RELIEVO_CHECK(relievoBench::DrawCharts(name, folder));
  return session.Result();
}
}
