// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Chart 6: frames by the number of lamps and the way they are found; lamps computed against lamps
// that reach a pixel.
#include "BenchCharts.h"

#include <cmath>

namespace relievoBench
{
namespace
{
struct Panel
{
  const char* Scene;
  const char* Size;
  const char* Title;
};

const Panel Panels[] = { { "bunny", "few", "bunny" }, { "motorBike", "few", "motorBike" },
  { "buildings", "few", "buildings" } };

Chart MakeChart(const CsvRows& rows, const std::string& title, const std::string& column,
  const std::string& yTitle, const std::vector<const char*>& ways)
{
  Chart chart;
  chart.Title = title;
  chart.Note =
    "1.3 to 1.8 reach a pixel from 10 lamps on. Default: quads up to 8 lamps in sight, then "
    "clusters. Grey: VTK.";
  chart.Columns = 3;
  chart.X.Log = true;
  chart.X.Title = "lamps";
  chart.X.Ticks = { { 1., "1" }, { 100., "100" }, { 1e4, "10 000" } };
  chart.Y.Title = yTitle;
  chart.Y.Log = true;
  chart.Y.Ticks = { { 1., "1" }, { 2., "2" }, { 5., "5" }, { 10., "10" }, { 100., "100" } };
  for (const Panel& each : Panels)
  {
    ChartPanel panel;
    panel.Title = each.Title;
    for (const char* way : ways)
    {
      ChartSeries series;
      series.Method = way;
      for (const CsvRow& row : rows)
      {
        const double value = NumberIn(row, column);
        if (row.at("scene") == each.Scene && row.at("size") == each.Size && row.at("way") == way &&
          std::isfinite(value) && value > 0.)
        {
          series.X.push_back(NumberIn(row, "lamps"));
          series.Y.push_back(value);
        }
      }
      if (!series.X.empty())
      {
        panel.Series.push_back(series);
      }
    }
    chart.Panels.push_back(panel);
  }
  return chart;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> LightsCharts(const std::vector<CsvRows>& files)
{
  return { { "lights-frames",
             MakeChart(files[0], "Frames with lamps that all move", "times a plain frame",
               "times a plain frame", { "quads", "clusters", "every lamp", "VTK's lights" }) },
    { "lights-computed",
      MakeChart(files[0], "Lamps computed for a pixel, against those that reach it",
        "computed / reaching", "computed / reaching", { "quads", "clusters" }) } };
}

//------------------------------------------------------------------------------
std::vector<NamedChart> DeferredCharts(const std::vector<CsvRows>& files)
{
  Chart chart;
  chart.Title = "Deferred shading by how often a pixel is drawn";
  chart.Note = "Matte surfaces that fill the window, the farthest first. Grey: VTK's own shading.";
  chart.Columns = 3;
  chart.X.Log = true;
  chart.X.Title = "surfaces behind a pixel";
  chart.X.Ticks = { { 1., "1" }, { 2., "2" }, { 4., "4" }, { 8., "8" }, { 16., "16" } };
  chart.Y.Title = "milliseconds a frame";
  chart.Y.Log = true;
  chart.Y.Ticks = { { 5., "5" }, { 10., "10" }, { 20., "20" }, { 50., "50" }, { 100., "100" },
    { 200., "200" }, { 500., "500" }, { 1000., "1000" }, { 2000., "2000" } };
  for (const char* lights : { "1", "8", "32" })
  {
    ChartPanel panel;
    panel.Title = std::string(lights) + (lights == std::string("1") ? " light" : " lights");
    for (const char* way : { "deferred", "VTK's shading" })
    {
      ChartSeries series;
      series.Method = way;
      for (const CsvRow& row : files[0])
      {
        if (row.at("surface") == "matte" && row.at("lights") == lights && row.at("way") == way)
        {
          series.X.push_back(NumberIn(row, "overdraw"));
          series.Y.push_back(NumberIn(row, "milliseconds"));
        }
      }
      if (!series.X.empty())
      {
        panel.Series.push_back(series);
      }
    }
    chart.Panels.push_back(panel);
  }
  return { { "deferred", chart } };
}
}
