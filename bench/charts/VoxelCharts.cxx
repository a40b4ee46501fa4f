// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells inside bodies: wrong cells against time, and time against the size of the grid.
#include "BenchCharts.h"

#include <algorithm>

namespace relievoBench
{
namespace
{
Chart WrongAgainstTime(const CsvRows& rows)
{
  Chart chart;
  chart.Title = "Cells inside bodies: wrong cells against time";
  chart.Note = "Lower left is better. Each mark is a grid, from coarse to fine. Ring: the default.";
  chart.X.Title = "milliseconds";
  chart.X.Log = true;
  for (const CsvRow& row : rows)
  {
    // The modeller marks cells near the surface, not those inside: it is off this scale.
    if (row.at("excess percent").empty() || row.at("method") == "vtkVoxelModeller")
    {
      continue;
    }
    ChartSeries& series = SeriesOf(PanelOf(chart, row.at("body")), row.at("method"));
    series.X.push_back(NumberIn(row, "milliseconds"));
    series.Y.push_back(NumberIn(row, "excess percent") + NumberIn(row, "missed percent"));
    series.Default = series.Method == "parity" ? static_cast<int>(series.X.size()) - 1 : -1;
  }
  chart.Y.Title = "excess and missed, % of the cells inside";
  chart.Columns = std::min(3, std::max(1, static_cast<int>(chart.Panels.size())));
  return chart;
}

Chart TimeAgainstSize(const CsvRows& rows)
{
  Chart chart;
  chart.Title = "Cells inside bodies: time by size of the grid";
  chart.Note = "Lower is better.";
  chart.X.Title = "cells along the longest side";
  chart.X.Log = true;
  chart.Y.Title = "milliseconds";
  chart.Y.Log = true;
  for (const CsvRow& row : rows)
  {
    if (row.at("excess percent").empty())
    {
      continue;
    }
    const double cells = NumberIn(row, "cells");
    const bool known = std::any_of(chart.X.Ticks.begin(), chart.X.Ticks.end(),
      [cells](const std::pair<double, std::string>& tick) { return tick.first == cells; });
    if (!known)
    {
      chart.X.Ticks.emplace_back(cells, std::to_string(static_cast<int>(cells)));
    }
    ChartSeries& series = SeriesOf(PanelOf(chart, row.at("body")), row.at("method"));
    series.X.push_back(cells);
    series.Y.push_back(NumberIn(row, "milliseconds"));
  }
  // One body is enough: the last, a real mesh where there is one.
  chart.Panels.erase(chart.Panels.begin(), chart.Panels.end() - (chart.Panels.empty() ? 0 : 1));
  return chart;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> VoxelCharts(const std::vector<CsvRows>& files)
{
  return { { "voxels-wrong", WrongAgainstTime(files[0]) },
    { "voxels-time", TimeAgainstSize(files[0]) } };
}
}
