// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the bench of bones, small, and checks its CSV: the errors that are known in closed form.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <string>
#include <vector>

namespace testBenchSkin
{
//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchSkin)
{
  using relievoTest::Row;
  using relievoTest::Value;
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/skin";
  vtksys::SystemTools::RemoveADirectory(folder);
  relievoBench::SkinSizes sizes;
  sizes.Points = 5000;
  sizes.Rounds = 1;
  sizes.Bones = { 4, 100 };
  RELIEVO_CHECK(relievoBench::BenchSkin(folder, sizes) == 0);
  const double pi = std::acos(-1.);
  for (const Row& row : relievoTest::ReadCsv(folder + "/skin-keys.csv"))
  {
    const double step = 2. * pi / Value(row, "keys per second");
    const double off = Value(row, "largest error of the arm's end, arm's lengths");
    if (row.at("motion") == "a screw" && row.at("method") == "slerp" && step < 2.)
    {
      // The joint is an arm's length from the axis: linear positions cut the arc by its sagitta.
      RELIEVO_CHECK_NEAR(off, 1. - std::cos(step / 2.), 0.01 * off, "a screw's chord");
    }
    if (row.at("motion") == "one turn a second" && row.at("method") == "slerp")
    {
      RELIEVO_CHECK_AT_MOST(off, 1e-12, "slerp is this motion");
    }
    if (row.at("motion") == "one turn a second" && row.at("method") == "key-matrix" && step < 2.)
    {
      // The arm is across the axis of the turn: the sagitta of its arc, and a little along it.
      RELIEVO_CHECK_NEAR(off, 1. - std::cos(step / 2.), 0.03 * off, "blended matrices");
    }
  }
  int twists = 0;
  for (const Row& row : relievoTest::ReadCsv(folder + "/skin-volume.csv"))
  {
    const double volume = Value(row, "volume, % of the rest");
    if (row.at("motion") == "twist" && row.at("method") == "dual quaternion")
    {
      RELIEVO_CHECK_AT_MOST(std::abs(volume - 100.), 1., "volume of a twist");
      ++twists;
    }
    if (row.at("motion") == "twist" && row.at("method") == "linear" && row.at("degrees") == "180")
    {
      // Half of the tube has the squared radius (1 - 2 s)^2, of mean 1/3.
      RELIEVO_CHECK_NEAR(volume, 100. * (0.5 + 0.5 / 3.), 1., "volume at half a turn");
    }
  }
  RELIEVO_CHECK(twists == 13);
  const auto times = relievoTest::ReadCsv(folder + "/skin.csv");
  RELIEVO_CHECK(times.size() == 12); // of two numbers of bones, three on the CPU and three frames
  for (const Row& row : times)
  {
    RELIEVO_CHECK(Value(row, "ms per million points") > 0.);
  }
  RELIEVO_CHECK(!vtksys::SystemTools::FileExists(folder + "/skin-peer.glb"));
  RELIEVO_CHECK(relievoBench::DrawCharts("skin", folder));
  return session.Result();
}
}
