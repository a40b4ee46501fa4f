// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The bench of volumes, small: its rows, that more nodes and more Fourier terms err less, and
// rays in double least; that pictures whose transparent parts are skipped are VTK's.
#include "VolumeSizes.h"

#include "BenchSizes.h"

#include "Check.h"
#include "CsvFile.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <string>

namespace testBenchVolumes
{
//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchVolumes)
{
  relievoTest::Session session;
  const std::string folder = relievoTest::OutputFolder() + "/volumes";
  vtksys::SystemTools::RemoveADirectory(folder);
  relievoBench::VolumeSizes sizes;
  sizes.Sizes = { 24 };
  sizes.Nodes = { 16, 32 };
  sizes.FourierNodes = 32;
  sizes.Places = 100;
  sizes.FrameSizes = { 16 };
  sizes.Rounds = 1;
  RELIEVO_CHECK(relievoBench::BenchVolumes(folder, sizes) == 0);
  const auto rows = relievoTest::ReadCsv(folder + "/volumes.csv");
  RELIEVO_CHECK(rows.size() == 4 * 10);
  for (std::size_t i = 0; i + 9 < rows.size(); i += 10)
  {
    const std::string scene = rows[i].at("scene");
    const double coarse = relievoTest::Value(rows[i], "rms");
    const double fine = relievoTest::Value(rows[i + 1], "rms");
    const double exact = relievoTest::Value(rows[i + 9], "rms");
    RELIEVO_CHECK_THAT(rows[i + 9].at("method") == "exact", scene);
    RELIEVO_CHECK_AT_MOST(fine, coarse, scene + ": more nodes");
    RELIEVO_CHECK(rows[i + 2].at("setting") == "7" && rows[i + 4].at("setting") == "31");
    RELIEVO_CHECK_THAT(
      relievoTest::Value(rows[i + 4], "rms") < relievoTest::Value(rows[i + 2], "rms"),
      scene + ": 31 Fourier terms against 7");
    // Rays in double are the truth of "waves". Of the ball, the voxels' own error remains.
    if (scene != "waves")
    {
      RELIEVO_CHECK_AT_MOST(exact, scene == "ball" ? 4e-3 : 1e-5, scene + ": rays in double");
    }
  }
  const auto frames = relievoTest::ReadCsv(folder + "/volume-frames.csv");
  RELIEVO_CHECK(frames.size() >= 3);
  RELIEVO_CHECK_AT_MOST(20.0 * relievoTest::Value(frames[1], "levels rms"),
    relievoTest::Value(frames[0], "levels rms"), "the ground's shadow");
  relievoBench::EmptySpaceSizes empty;
  empty.Sizes = { 24 };
  empty.Shares = { 0.1 };
  empty.Pixels = 60;
  empty.Rounds = 1;
  RELIEVO_CHECK(relievoBench::BenchEmptySpace(folder, empty) == 0);
  const auto shapes = relievoTest::ReadCsv(folder + "/empty-space.csv");
  RELIEVO_CHECK(shapes.size() == 3 * 2 && shapes[0].at("stage") == "ran");
  for (const auto& row : shapes)
  {
    RELIEVO_CHECK_AT_MOST(
      relievoTest::Value(row, "levels"), 0.0, row.at("shape") + ": the picture");
  }
  return session.Result();
}
}
