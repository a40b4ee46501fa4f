// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs one of the benches of formats, small, and checks its CSV against the required accuracies.
//   testBenchFormats normals|depth|position
//   testBenchFormats normals long             all directions of the chart
#include "BenchSizes.h"
#include "Check.h"
#include "CsvFile.h"
#include "RelievoBench.h"
#include "Session.h"
#include "TestCase.h"

#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace testBenchFormats
{
namespace
{
using relievoTest::Row;
using relievoTest::Value;

// Each row of a format is within the limits of its columns; there must be `count` rows.
void Check(const std::vector<Row>& rows, const std::string& format, int count,
  const std::map<std::string, double>& limits)
{
  int found = 0;
  for (const Row& row : rows)
  {
    if (row.at("format") != format)
    {
      continue;
    }
    ++found;
    for (const auto& limit : limits)
    {
      RELIEVO_CHECK_AT_MOST(Value(row, limit.first), limit.second, format + ": " + limit.first);
    }
  }
  RELIEVO_CHECK_THAT(found == count, "rows of " + format + ": " + std::to_string(found));
}

void CheckNormals(const std::vector<Row>& rows)
{
  const std::string seams = "max at axes and seams";
  Check(rows, "octahedral precise 2x16", 1,
    { { "max", 0.0026 }, { seams, 0.0026 }, { "mean degrees", 0.00125 } });
  Check(rows, "octahedral 2x16", 1, { { "max", 0.00372 }, { seams, 0.00372 } });
  Check(rows, "octahedral 2x8", 1, { { "max", 0.9571 }, { "mean degrees", 0.34 } });
  Check(rows, "octahedral precise 2x8", 1, { { "max", 0.6381 }, { "mean degrees", 0.318 } });
  Check(rows, "0.5n+0.5 RGB8", 1, { { "max", 0.3892 }, { "mean degrees", 0.1715 } });
  Check(rows, "0.5n+0.5 RGB10A2", 1, { { "max", 0.0971 }, { "mean degrees", 0.0427 } });
  Check(rows, "half xyz", 1, { { "max", 0.0243 }, { "mean degrees", 0.0062 } });
  Check(rows, "float xyz", 1, { { "max", 4e-6 }, { seams, 4e-6 } });
}

void CheckDepth(const std::vector<Row>& rows)
{
  const std::string largest = "max";
  Check(rows, "R32F, linear", 5,
    { { largest, 6e-8 }, { "neighbours equal", 0. }, { "neighbours swapped", 0. } });
  Check(rows, "reversed z, 32F", 5,
    { { largest, 5e-7 }, { "neighbours equal", 0. }, { "neighbours swapped", 0. } });
  Check(rows, "R16F, scaled by 2^k", 5, { { largest, 0x1p-11 }, { "neighbours swapped", 0. } });
  Check(rows, "window z, 24 bits", 5, { { largest, 0.032 }, { "neighbours swapped", 0. } });
  Check(rows, "window z, 32F", 5, { { largest, 0.032 }, { "neighbours swapped", 0. } });
  Check(rows, "RGBA8 alpha, linear", 5, { { largest, 1. }, { "neighbours swapped", 0. } });
}

// Errors in pixels: perspective and parallel, at the origin and far from it.
void CheckPosition(const std::vector<Row>& rows)
{
  Check(rows, "depth R32F + id, refined", 4, { { "max", 0.01 } });
  for (const char* format : { "depth R32F", "reversed z, 32F", "window z, 24 bits",
         "window z, 32F *", "eye space RGBA32F *" })
  {
    Check(rows, format, 4, { { "p99", 0.01 }, { "max of the format alone", 0.01 } });
  }
  Check(rows, "depth R16F", 4, { { "max", 2. } });
  for (const Row& row : rows)
  {
    const bool far = row.at("scene at") != "origin";
    const double worst = Value(row, "max");
    if (row.at("format") == "world RGBA32F *")
    {
      RELIEVO_CHECK(far ? worst > 10. && worst < 100. : worst < 0.01);
    }
    else if (row.at("format") == "world RGBA16F *")
    {
      RELIEVO_CHECK(far ? std::isinf(worst) : worst < 1.);
    }
    RELIEVO_CHECK(Value(row, "pixels") > 100000. && Value(row, "left out on edges") < 5000.);
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testBenchFormats)
{
  relievoTest::Session session;
  const std::string name = argc > 1 ? argv[1] : "";
  const std::string folder = relievoTest::OutputFolder() + "/" + name;
  vtksys::SystemTools::RemoveADirectory(folder);
  relievoBench::NormalSizes normals;
  if (argc < 3)
  {
    normals.Uniform = 500000;
    normals.Special = 60000;
  }
  relievoBench::PositionSizes position;
  position.Rounds = 1;
  RELIEVO_CHECK((name == "normals"       ? relievoBench::BenchNormals(folder, normals)
                    : name == "position" ? relievoBench::BenchPosition(folder, position)
                                         : RelievoBench(name, folder)) == 0);
  const std::vector<Row> rows = relievoTest::ReadCsv(folder + "/" + name + ".csv");
  if (name == "normals")
  {
    CheckNormals(rows);
  }
  else if (name == "position")
  {
    CheckPosition(rows);
  }
  else
  {
    CheckDepth(rows);
  }
  return session.Result();
}
}
