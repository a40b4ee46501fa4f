// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the bench of effects on a small picture, and checks its CSV: every frame exists, effects
// hold the memory of the linear colour, and frames without requests hold none.
#include "BenchSizes.h"
#include "Charts.h"
#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <map>
#include <string>

namespace testBenchEffects
{
RELIEVO_TEST_CASE(testBenchEffects)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/effects";
  vtksys::SystemTools::RemoveADirectory(folder);
  relievoBench::EffectSizes sizes;
  sizes.Meshes = { "bunny" };
  sizes.Width = 120;
  sizes.Height = 80;
  sizes.Rounds = 2;
  RELIEVO_CHECK(relievoBench::BenchEffects(folder, sizes) == 0);
  std::map<std::string, double> bytes;
  for (const auto& row : relievoTest::ReadCsv(folder + "/effects.csv"))
  {
    RELIEVO_CHECK(relievoTest::Value(row, "times a plain frame") > 0.);
    RELIEVO_CHECK(relievoTest::Value(row, "times the plain frame's") > 0.);
    bytes[row.at("frame")] = relievoTest::Value(row, "bytes per pixel");
  }
  RELIEVO_CHECK(bytes.size() == 15);
  for (const char* frame : { "plain", "attached, nothing asked", "vtkToneMappingPass" })
  {
    RELIEVO_CHECK_THAT(bytes.at(frame) == 0., frame);
  }
  // Three times four half floats, or floats, and a depth; the layers of a lamp beside it.
  RELIEVO_CHECK(bytes["tone"] >= 3 * 8 + 4 && bytes["tone"] <= 3 * 16 + 4);
  RELIEVO_CHECK(bytes["the first lamp"] >= bytes["tone"] + 3 * 4);
  RELIEVO_CHECK(bytes["five layers"] > 0. && bytes["five layers"] < bytes["tone"]);
  RELIEVO_CHECK(relievoBench::DrawCharts("effects", folder));
  return session.Result();
}
}
