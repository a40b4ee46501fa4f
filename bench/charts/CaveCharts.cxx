// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Caves: evaluations of noise by how fine the samples are, and the width of tunnels against what
// was asked.
#include "BenchCharts.h"

#include <string>

namespace relievoBench
{
namespace
{
Chart Evaluations(const CsvRows& rows)
{
  Chart chart;
  chart.Kind = Chart::Curves;
  chart.Title = "Caves: evaluations of noise";
  chart.Note = "Lower is better. Same masks; tunnels a tenth of a cell wide. Ring: the default.";
  chart.X.Title = "samples across a cell of the noise (Scale)";
  chart.X.Log = true;
  chart.X.Ticks = { { 16., "16" }, { 32., "32" }, { 64., "64" }, { 128., "128" }, { 256., "256" } };
  chart.Y.Title = "evaluations a sample";
  chart.Panels.resize(1);
  for (const std::string method : { "naive", "classic", "skipping" })
  {
    ChartSeries series;
    series.Method = method;
    for (const CsvRow& row : rows)
    {
      if (row.at("method") == method)
      {
        series.X.push_back(NumberIn(row, "scale samples"));
        series.Y.push_back(NumberIn(row, "evaluations per sample"));
        const bool isDefault = method == "skipping" && series.X.back() == 64.;
        series.Default = isDefault ? static_cast<int>(series.X.size()) - 1 : series.Default;
      }
    }
    chart.Panels[0].Series.push_back(series);
  }
  return chart;
}

Chart Widths(const CsvRows& rows)
{
  Chart chart;
  chart.Kind = Chart::Curves;
  chart.Title = "Caves: width of tunnels";
  chart.Note =
    "1: as asked. Mean length of air along level lines, and twice that along upright ones.";
  chart.X.Title = "width asked, part of Scale";
  chart.Y.Title = "measured over asked";
  chart.Panels.resize(1);
  const std::pair<const char*, const char*> columns[] = { { "level lines", "level over asked" },
    { "upright lines", "twice upright over asked" } };
  for (const auto& column : columns)
  {
    ChartSeries series;
    series.Method = column.first;
    for (const CsvRow& row : rows)
    {
      series.X.push_back(NumberIn(row, "width asked"));
      series.Y.push_back(NumberIn(row, column.second));
    }
    chart.Panels[0].Series.push_back(series);
  }
  return chart;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> CaveCharts(const std::vector<CsvRows>& files)
{
  return { { "caves-evaluations", Evaluations(files[0]) }, { "caves-width", Widths(files[1]) } };
}
}
