// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the benches of voxels and of rays with a small size, and checks their CSV: all rows, errors
// of parity and views, number of hits, and their charts.
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

namespace testBenchVoxels
{
namespace
{
using relievoTest::Row;
using relievoTest::Value;

void CheckVoxels(const std::string& folder)
{
  relievoBench::VoxelSizes sizes;
  sizes.Sizes = { 10, 16 };
  sizes.Slow = 16;
  sizes.Chord = 2e-3;
  sizes.Rounds = 3;
  sizes.Meshes.clear();
  sizes.Large = 0;
  RELIEVO_CHECK(relievoBench::BenchVoxels(folder, sizes) == 0);
  std::map<std::string, int> methods;
  std::map<std::string, std::map<std::string, double>> error;
  for (const Row& row : relievoTest::ReadCsv(folder + "/voxels.csv"))
  {
    const std::string& method = row.at("method");
    const std::string name = row.at("body") + ", " + row.at("cells") + ", " + method;
    const double excess = Value(row, "excess percent");
    const double missed = Value(row, "missed percent");
    ++methods[method];
    RELIEVO_CHECK_THAT(Value(row, "milliseconds") > 0., name);
    error[row.at("body") + row.at("cells")][method] = excess + missed;
    if (method.rfind("vtk", 0) != 0)
    {
      // The triangles lie within the bodies' surfaces.
      RELIEVO_CHECK_AT_MOST(missed, 2., name + ", missed cells, %");
    }
    if (method == "two views" && row.at("body") != "ball")
    {
      RELIEVO_CHECK_THAT(excess > 5., name);
    }
  }
  for (auto& grid : error)
  {
    // Another way to the same triangles' inside.
    RELIEVO_CHECK_NEAR(grid.second["parity"], grid.second["vtkSelectEnclosedPoints"], 1e-3,
      grid.first + ", wrong, %");
  }
  RELIEVO_CHECK(methods.size() >= 6);
  for (const auto& method : methods)
  {
    RELIEVO_CHECK_THAT(method.second == 8, method.first);
  }
}

void CheckRays(const std::string& folder)
{
  relievoBench::RaySizes sizes;
  sizes.Rays = 2000;
  sizes.Rounds = 2;
  sizes.Meshes = { "bunny" };
  sizes.Divisions = 1;
  RELIEVO_CHECK(relievoBench::BenchRays(folder, sizes) == 0);
  const std::vector<Row> rows = relievoTest::ReadCsv(folder + "/rays.csv");
  RELIEVO_CHECK(rows.size() == 10);
  for (const Row& row : rows)
  {
    const std::string name = row.at("method") + ", " + row.at("triangles");
    RELIEVO_CHECK_THAT(Value(row, "million rays per second") > 0., name);
    RELIEVO_CHECK_THAT(Value(row, "bytes per triangle") > 12., name);
    // The divided mesh, which is that surface, has as many for each triangle.
    RELIEVO_CHECK_NEAR(
      Value(row, "hit percent"), Value(rows[0], "hit percent"), 0.1, name + ", hits, %");
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchVoxels)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/voxels";
  vtksys::SystemTools::RemoveADirectory(folder);
  CheckVoxels(folder);
  RELIEVO_CHECK(relievoBench::DrawCharts("voxels", folder));
  CheckRays(folder);
  RELIEVO_CHECK(relievoBench::DrawCharts("rays", folder));
  return session.Result();
}
}
