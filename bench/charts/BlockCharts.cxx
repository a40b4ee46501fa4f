// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces of labels: errors against time, of the largest images, by shape.
#include "BenchCharts.h"

#include <algorithm>

namespace relievoBench
{
namespace
{
Chart ErrorAgainstTime(
  const CsvRows& rows, const std::string& column, const std::string& title, const std::string& unit)
{
  Chart chart;
  chart.Kind = Chart::Curves;
  chart.Title = title;
  double largest = 0.;
  for (const CsvRow& row : rows)
  {
    largest = std::max(largest, NumberIn(row, "blocks"));
  }
  chart.Note = "Lower left is better. Ring: the default. One thread, " +
    std::to_string(static_cast<int>(largest)) + " blocks each way.";
  chart.X.Title = "milliseconds per million blocks";
  chart.X.Log = true;
  chart.Y.Title = unit;
  for (const CsvRow& row : rows)
  {
    if (NumberIn(row, "blocks") < largest)
    {
      continue;
    }
    ChartSeries& series = SeriesOf(PanelOf(chart, row.at("shape")), row.at("method"));
    series.X = { NumberIn(row, "ms per million blocks") };
    series.Y = { NumberIn(row, column) };
    series.Line = false;
    series.Default = series.Method == "smooth blocks" ? 0 : -1;
  }
  chart.Columns = static_cast<int>(chart.Panels.size());
  return chart;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> BlockCharts(const std::vector<CsvRows>& files)
{
  return { { "blocks-distance",
             ErrorAgainstTime(files[0], "hausdorff blocks",
               "Surfaces of blocks: largest distance to the shape", "Hausdorff distance, blocks") },
    { "blocks-normals",
      ErrorAgainstTime(files[0], "rms normal degrees", "Surfaces of blocks: error of normals",
        "rms error, degrees") } };
}
}
