// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The summary of several benches: ratios of known tables, and tables that cannot be compared.
#include "BenchRuns.h"
#include "BenchSummary.h"
#include "Check.h"
#include "Session.h"
#include "Table.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <sys/stat.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace testBenchSummary
{
namespace
{
using namespace relievoBench;

void Write(const std::string& path, const std::string& text)
{
  std::ofstream(path, std::ios::binary) << text;
}

std::string ReadAll(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

const ColumnComparison* Find(const std::vector<ColumnComparison>& all, const std::string& column)
{
  for (const ColumnComparison& each : all)
  {
    if (each.Column == column)
    {
      return &each;
    }
  }
  return nullptr;
}

void TestRatios(const std::string& here, const std::string& there)
{
  // Times 4 and 16 times as fast: 8 on average. The error is twice as large there in one row.
  const std::string columns = "scene,size,frame ms,+-,\"wrong, %\",times a plain frame,load\n";
  Write(here + "/a.csv",
    columns + "bunny,1,2,0.1,1,1.5,1\n\"town, far\",2,3,0.1,2,1.5,9\nnone,3,,,0,,\n");
  // Tables may be in rooms, which may name the renderer; folders of another renderer are none.
  RELIEVO_CHECK(MakeFolder(there + "/room") && MakeFolder(there + "/gpu"));
  Write(there + "/gpu/a.csv", columns + "bunny,1,99,0.7,2,3,2\n");
  Write(there + "/gpu/c.csv", "scene,ms\nbunny,99\n");
  Write(there + "/gpu/d.csv", "scene,ms\nbunny,99\n");
  Write(there + "/gpu/renderer.txt", "A GPU\n");
  Write(there + "/room/renderer.txt", "software OpenGL\n");
  Write(there + "/room/a.csv",
    columns + "bunny,1,8,0.7,2,3,2\n\"town, far\",2,48,0.2,2,1.5,3\nnone,3,,,0,,\n");
  // Other rows, other columns, and one that is only here.
  Write(here + "/b.csv", "scene,ms\nbunny,1\n");
  Write(there + "/b.csv", "scene,ms\ntown,1\n");
  Write(here + "/c.csv", "scene,ms\nbunny,1\n");
  Write(there + "/c.csv", "scene,seconds\nbunny,1\n");
  Write(here + "/d.csv", "scene,ms\nbunny,1\n");
  // The keys are numbers: other keys, and equal keys in another order. The other columns are
  // measured.
  Write(here + "/e.csv", "scene,lights,ms\nbunny,1,2\nbunny,2,3\n");
  Write(there + "/e.csv", "scene,lights,ms\nbunny,1,2\nbunny,4,9\n");
  Write(here + "/f.csv", "lights,size,ms\n1,8,2\n2,8,3\n");
  Write(there + "/f.csv", "lights,size,ms\n2,8,3\n1,8,2\n");
  Write(here + "/g.csv", "lights,pixels,ms\n1,999,1\n2,999,1\n");
  Write(there + "/g.csv", "lights,pixels,ms\n1,1000,1\n2,999,1\n");
  // No column tells the rows apart before the times.
  Write(here + "/h.csv", "scene,ms\nbunny,1\nbunny,2\n");
  Write(there + "/h.csv", "scene,ms\nbunny,1\nbunny,2\n");
  Write(here + "/summary.csv", "scene,ms\nbunny,1\n");
  Write(there + "/summary.csv", "scene,ms\nbunny,1\n");

  std::vector<std::string> differing;
  const std::vector<ColumnComparison> all = CompareTables(here, there, differing);
  RELIEVO_CHECK((differing == std::vector<std::string>{ "b.csv", "c.csv", "e.csv", "f.csv" }));
  RELIEVO_CHECK(all.size() == 4);
  const ColumnComparison* pixels = Find(all, "pixels");
  RELIEVO_CHECK(pixels && pixels->File == "g.csv" && pixels->Rows == 2);
  const ColumnComparison* time = Find(all, "frame ms");
  if (RELIEVO_CHECK(time != nullptr))
  {
    RELIEVO_CHECK(time->IsTime && time->Rows == 2 && time->File == "a.csv");
    RELIEVO_CHECK_NEAR(time->There / time->Here, 8., 1e-12, "There / Here");
    RELIEVO_CHECK_NEAR(time->Here, std::sqrt(6.), 1e-12, "Here");
    RELIEVO_CHECK_NEAR(time->Least, 4., 1e-12, "Least");
    RELIEVO_CHECK_NEAR(time->Most, 16., 1e-12, "Most");
  }
  const ColumnComparison* errors = Find(all, "wrong, %");
  if (RELIEVO_CHECK(errors != nullptr))
  {
    RELIEVO_CHECK(!errors->IsTime && errors->Rows == 2);
    RELIEVO_CHECK_NEAR(
      errors->There / errors->Here, std::sqrt(2.), 1e-12, "error There / error Here");
  }
  const ColumnComparison* plain = Find(all, "times a plain frame");
  RELIEVO_CHECK(plain && !plain->IsTime);
}

void TestWritten(const std::string& here, const std::string& there)
{
  const std::vector<BenchRun> runs = { { "normals", "done", 31.25 },
    { "fog", "crashed: why | where", 2. } };
  RELIEVO_CHECK(WriteSummary(here, there, { "  renderer some" }, runs));
  const std::string text = ReadAll(here + "/summary.md");
  for (const char* part :
    { "\n- renderer some\n", "| normals | done | 31.2 |", "| fog | crashed: why \\| where | 2 |",
      "| a.csv | frame ms | 2 | 2.45 | 19.6 | 8 | 4 | 16 |", "something else: b.csv" })
  {
    RELIEVO_CHECK_THAT(text.find(part) != std::string::npos, part);
  }
  std::vector<CsvRow> rows;
  RELIEVO_CHECK(ReadCsv(here + "/summary.csv", rows) && rows.size() == 4);
  RELIEVO_CHECK(NumberIn(rows[0], "there / here") == 8.);
  // Without another folder there is nothing to compare with.
  RELIEVO_CHECK(WriteSummary(here, "", {}, runs));
  RELIEVO_CHECK(ReadAll(here + "/summary.md").find("## Times") == std::string::npos);
  RELIEVO_CHECK(!WriteSummary(here + "/no-such-folder", "", {}, runs));
}
// Calls that cannot work are refused before measuring, and nothing is overwritten.
void TestRefusals(const std::string& there)
{
  const std::string fresh = relievoTest::OutputFolder() + "/fresh";
  const std::string empty = relievoTest::OutputFolder() + "/empty";
  const std::string other = relievoTest::OutputFolder() + "/other";
  RELIEVO_CHECK(MakeFolder(empty) && MakeFolder(other));
  std::remove((fresh + "/benches.csv").c_str()); // of a former run of this test
  for (const std::string& beside : { fresh + "/none", empty })
  {
    RELIEVO_CHECK(RunBenches("no-such-program", { "fog" }, fresh, beside, {}) == 2);
    RELIEVO_CHECK(!std::ifstream(fresh + "/benches.csv"));
  }
  const std::string table = "name,value\nfog,done\n";
  Write(other + "/benches.csv", table);
  RELIEVO_CHECK(RunBenches("no-such-program", { "fog" }, other, there, {}) == 2);
  RELIEVO_CHECK(ReadAll(other + "/benches.csv") == table);
  // A program that does not start is a bench that failed.
  RELIEVO_CHECK(RunBenches("no-such-program", { "fog" }, fresh, there, {}) == 1);
  RELIEVO_CHECK(ReadAll(fresh + "/benches.csv").find("fog,") != std::string::npos);
  // A bench that lacks a package is left out, with its reason; it is not a failure.
  const std::string lacks = relievoTest::OutputFolder() + "/lacks";
  Write(lacks, "#!/bin/sh\necho 'f3d is missing'\nexit 3\n");
  RELIEVO_CHECK(chmod(lacks.c_str(), 0755) == 0);
  RELIEVO_CHECK(RunBenches(lacks, { "f3d" }, fresh, there, {}) == 0);
  const std::string runs = ReadAll(fresh + "/benches.csv");
  RELIEVO_CHECK_THAT(runs.find("left out: f3d is missing") != std::string::npos, runs);
}
}

RELIEVO_TEST_CASE(testBenchSummary)
{
  relievoTest::Session session;
  const std::string here = relievoTest::OutputFolder() + "/here";
  const std::string there = relievoTest::OutputFolder() + "/there";
  for (const std::string& folder : { here, there })
  {
    // An earlier run's tables may be in other rooms.
    vtksys::SystemTools::RemoveADirectory(folder);
    RELIEVO_CHECK(MakeFolder(folder));
  }
  TestRatios(here, there);
  TestWritten(here, there);
  TestRefusals(there);
  return session.Result();
}
}
