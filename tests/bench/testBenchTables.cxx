// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Benches' tables keep their values, and report write errors; a folder of tables names its
// renderer.
#include "Check.h"
#include "RelievoBench.h"
#include "Renderer.h"
#include "Session.h"
#include "Table.h"
#include "TestCase.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace testBenchTables
{
namespace
{
using namespace relievoBench;

std::string Read(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

void TestTable()
{
  Table table({ "format", "max" });
  table.AddRow({ "a, b", Number(1. / 3.) });
  table.AddRow({ "with \"quotes\"", Number(1e-7, 2) });
  const std::string path = relievoTest::OutputFolder() + "/table.csv";
  RELIEVO_CHECK(table.WriteCsv(path));
  RELIEVO_CHECK(Read(path) == "format,max\n\"a, b\",0.3333\n\"with \"\"quotes\"\"\",1e-07\n");
  std::vector<CsvRow> rows;
  RELIEVO_CHECK(ReadCsv(path, rows) && rows.size() == 2);
  RELIEVO_CHECK(rows[0].at("format") == "a, b" && NumberIn(rows[0], "max") == 0.3333);
  RELIEVO_CHECK(rows[1].at("format") == "with \"quotes\"" && NumberIn(rows[1], "max") == 1e-7);
  RELIEVO_CHECK(std::isnan(NumberIn(rows[0], "format of old")));
  std::ofstream(path, std::ios::app) << "too,many,fields\n";
  RELIEVO_CHECK(!ReadCsv(path, rows) && !ReadCsv(path + ".not", rows));
  RELIEVO_CHECK(!table.WriteCsv(relievoTest::OutputFolder() + "/no-such-folder/table.csv"));
}

void TestRenderer()
{
  const std::string folder = relievoTest::OutputFolder() + "/renderer";
  RELIEVO_CHECK(RelievoBench("depth", folder) == 0);
  RELIEVO_CHECK(std::ifstream(folder + "/renderer.txt").good());
  const std::string drawn = ReadRenderer(folder); // one of the two, and never a software's name
  RELIEVO_CHECK(!drawn.empty() && drawn.find("pipe") == std::string::npos);
  std::ofstream(folder + "/renderer.txt") << "NVIDIA H200/PCIe/SSE2\n";
  RELIEVO_CHECK(ReadRenderer(folder) == "NVIDIA H200/PCIe/SSE2");
  RELIEVO_CHECK(ReadRenderer(folder + "/none") == "software OpenGL");
  RELIEVO_CHECK(FindRenderer("OpenGL vendor string:  A\nOpenGL renderer string:  B C\nD") == "B C");
  RELIEVO_CHECK(FindRenderer("OpenGL renderer string:\nD").empty() && FindRenderer("").empty());
}

void TestNames()
{
  RELIEVO_CHECK(RelievoBench("no such bench", relievoTest::OutputFolder()) == 2);
  RELIEVO_CHECK(RelievoBenchEntries().size() >= 2);
  RELIEVO_CHECK(RelievoBench("depth", relievoTest::OutputFolder() + "/table.csv/under") == 1);
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchTables)
{
  relievoTest::Session session;
  TestTable();
  TestRenderer();
  TestNames();
  return session.Result();
}
}
