// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the bench of blocks with a small size, and checks its CSV: all rows, errors within the
// limits of blocks, and its charts.
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

namespace testBenchBlocks
{
namespace
{
using relievoTest::Row;
using relievoTest::Value;

void CheckBlocks(const std::string& folder)
{
  relievoBench::BlockSizes sizes;
  sizes.Sizes = { 32 };
  sizes.Rounds = 3;
  sizes.Data.clear();
  RELIEVO_CHECK(relievoBench::BenchBlocks(folder, sizes) == 0);
  const std::vector<Row> rows = relievoTest::ReadCsv(folder + "/blocks.csv");
  std::map<std::string, std::map<std::string, Row>> all;
  for (const Row& row : rows)
  {
    all[row.at("shape")][row.at("method")] = row;
    const std::string name = row.at("shape") + ", " + row.at("method");
    RELIEVO_CHECK_THAT(Value(row, "milliseconds") > 0. && Value(row, "triangles") > 100., name);
    RELIEVO_CHECK_AT_MOST(Value(row, "hausdorff blocks"), 1.5, name + ", distance");
    RELIEVO_CHECK_AT_MOST(
      Value(row, "rms distance blocks"), Value(row, "hausdorff blocks"), name + ", rms");
  }
  RELIEVO_CHECK(all.size() == 3);
  for (const Row& row : relievoTest::ReadCsv(folder + "/blocks-threads.csv"))
  {
    RELIEVO_CHECK(Value(row, "milliseconds") > 0. && Value(row, "triangles") > 100.);
    all["threads " + row.at("labels")][row.at("threads")] = row;
  }
  RELIEVO_CHECK(all.erase("threads ball") == 1 && all.erase("threads sponge") == 1);
  for (auto& shape : all)
  {
    RELIEVO_CHECK(shape.second.size() >= 5);
    Row& cubes = shape.second["cubes"];
    Row& smooth = shape.second["smooth blocks"];
    RELIEVO_CHECK(cubes.at("triangles") == smooth.at("triangles"));
    RELIEVO_CHECK_AT_MOST(Value(smooth, "rms normal degrees"),
      0.4 * Value(cubes, "rms normal degrees"), shape.first + ", normals, degrees");
    RELIEVO_CHECK_AT_MOST(Value(smooth, "rms distance blocks"),
      0.5 * Value(cubes, "rms distance blocks"), shape.first + ", rms distance");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchBlocks)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/blocks";
  vtksys::SystemTools::RemoveADirectory(folder);
  CheckBlocks(folder);
  RELIEVO_CHECK(relievoBench::DrawCharts("blocks", folder));
  return session.Result();
}
}
