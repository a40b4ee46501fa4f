// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the bench of lamps with small sizes, and checks its CSV: all rows; the same lamps reach a
// pixel however they are found, and no way computes fewer.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <cmath>
#include <string>
#include <vector>

namespace testBenchLights
{
RELIEVO_TEST_CASE(testBenchLights)
{
  relievoTest::Session session;
  using relievoTest::Value;
  const std::string folder = relievoTest::OutputFolder();
  relievoBench::LightSizes sizes;
  sizes.Scenes = { "bunny" };
  sizes.Lamps = { 1, 30 };
  sizes.MostAll = 30;
  sizes.MostPeer = 1;
  sizes.Pixels = 100;
  sizes.Rounds = 2;
  RELIEVO_CHECK(relievoBench::BenchLights(folder, sizes) == 0);
  const std::vector<relievoTest::Row> rows = relievoTest::ReadCsv(folder + "/lights.csv");
  // One lamp in three ways and as VTK's, thirty small and large ones in three.
  RELIEVO_CHECK_THAT(rows.size() == 10, "rows: " + std::to_string(rows.size()));
  double reaching = 0.;
  for (const relievoTest::Row& row : rows)
  {
    const std::string way = row.at("way");
    const std::string name = row.at("lamps") + " " + row.at("size") + ", " + way;
    RELIEVO_CHECK_THAT(
      Value(row, "milliseconds") > 0. && Value(row, "times a plain frame") > 0., name);
    if (way == "VTK's lights")
    {
      RELIEVO_CHECK(row.at("computed").empty());
      continue;
    }
    RELIEVO_CHECK_THAT(Value(row, "computed") >= Value(row, "reaching"), name);
    reaching = way == "quads" ? Value(row, "reaching") : reaching;
    RELIEVO_CHECK_NEAR(Value(row, "reaching"), reaching, 1e-6, name);
    RELIEVO_CHECK_THAT(row.at("list ms").empty() == (way != "clusters"), name);
    if (way == "every lamp" && row.at("lamps") == "1")
    {
      RELIEVO_CHECK_AT_MOST(Value(row, "computed"), 1., name);
    }
  }

  sizes.Lamps = { 2 };
  sizes.Casting = { 0, 1 };
  RELIEVO_CHECK(relievoBench::BenchLightsPeer(folder, sizes) == 0);
  const std::vector<relievoTest::Row> peers = relievoTest::ReadCsv(folder + "/lights-peer.csv");
  RELIEVO_CHECK(peers.size() == 2 && peers[1].at("way") == "VTK's lights");
  RELIEVO_CHECK(relievoBench::BenchLampShadows(folder, sizes) == 0);
  const std::vector<relievoTest::Row> shadows = relievoTest::ReadCsv(folder + "/lamp-shadows.csv");
  RELIEVO_CHECK(shadows.size() == 4 && Value(shadows[3], "times without") > 0.);
  RELIEVO_CHECK(relievoBench::DrawCharts("lights", folder));
  return session.Result();
}
}
