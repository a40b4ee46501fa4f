// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the planner of shadows expects against what there is.
#include "BenchCharts.h"

#include <string>
#include <vector>

namespace relievoBench
{
namespace
{
const std::vector<std::pair<double, std::string>> Percents = { { 0.001, "0.001" }, { 0.01, "0.01" },
  { 0.1, "0.1" }, { 1., "1" } };

ChartSeries Diagonal(double low, double high, const std::string& name)
{
  ChartSeries series;
  series.Method = "plain";
  series.Name = name;
  series.X = { low, high };
  series.Y = { low, high };
  return series;
}

ChartSeries Marks(const CsvRows& rows, const char* method, const char* x, const char* y)
{
  ChartSeries series;
  series.Method = method;
  series.Line = false;
  for (const CsvRow& row : rows)
  {
    if (row.at("method") == method)
    {
      series.X.push_back(NumberIn(row, x));
      series.Y.push_back(NumberIn(row, y));
    }
  }
  return series;
}

Chart Scatter(const CsvRows& rows, const std::vector<const char*>& methods, const char* x,
  const char* y, double low, double high, const std::string& diagonal)
{
  Chart chart;
  chart.X.Log = true;
  chart.Y.Log = true;
  ChartPanel panel;
  for (const char* method : methods)
  {
    panel.Series.push_back(Marks(rows, method, x, y));
  }
  panel.Series.push_back(Diagonal(low, high, diagonal));
  chart.Panels.push_back(panel);
  return chart;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> PlannerCharts(const std::vector<CsvRows>& files)
{
  Chart error =
    Scatter(files[0], { "map", "warped" }, "expected wrong %", "wrong %", 0.003, 3., "as expected");
  error.Title = "Shadows: wrong verdicts against what is expected before drawing";
  error.Note =
    "Each mark is a scene, light, window and map size. Below the line: better than that.";
  error.X.Title = "expected, % of pixels";
  error.Y.Title = "measured, % of pixels";
  error.X.Ticks = error.Y.Ticks = Percents;
  Chart choice = Scatter(
    files[1], { "map", "warped", "exact" }, "tolerance %", "wrong %", 0.003, 0.3, "tolerance");
  choice.Title = "Shadows: wrong verdicts of the way that is chosen for a tolerance";
  choice.Note = "Each mark is a scene, light and window. Without an error: not shown.";
  choice.X.Title = "tolerance, % of pixels";
  choice.Y.Title = "measured, % of pixels";
  choice.X.Ticks = choice.Y.Ticks = Percents;
  Chart time = Scatter(
    files[2], { "map", "warped", "exact" }, "expected ms", "taken ms", 10., 1000., "as expected");
  time.Title = "Shadows: time of a frame against what is expected after ten frames";
  time.Note = "Each mark is a scene, light and window; the light moves.";
  time.X.Title = "expected, milliseconds";
  time.Y.Title = "taken, milliseconds";
  Chart budget =
    Scatter(files[3], { "map", "warped", "exact" }, "budget ms", "taken ms", 10., 1000., "budget");
  budget.Title = "Shadows: time of the way that is chosen for a time, after ten frames";
  budget.Note = "Each mark is a scene, light, window and time; the light moves. Below: in time.";
  budget.X.Title = "time to spend, milliseconds";
  budget.Y.Title = "taken, milliseconds";
  return { { "planner-error", error }, { "planner-choice", choice }, { "planner-time", time },
    { "planner-budget", budget } };
}
}
