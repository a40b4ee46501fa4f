// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fog: errors of a sphere's chord by distance, and frames by the number of spheres.
#include "BenchCharts.h"

namespace relievoBench
{
namespace
{
Chart ChordErrors(const CsvRows& rows)
{
  Chart chart;
  chart.Title = "Fog: largest error of a sphere's chord";
  chart.Note = "All rays that meet the sphere, its outline included.";
  chart.X.Title = "distance of the eye, in radii";
  chart.X.Log = true;
  chart.Y.Title = "error, in radii";
  chart.Y.Log = true;
  chart.Panels.resize(1);
  for (const CsvRow& row : rows)
  {
    ChartSeries& series = SeriesOf(chart.Panels[0], row.at("method"));
    series.X.push_back(NumberIn(row, "distance / radius"));
    series.Y.push_back(NumberIn(row, "max"));
  }
  return chart;
}

Chart FogFrames(const CsvRows& rows)
{
  Chart chart;
  chart.Title = "Frames with fog, by the number of spheres";
  chart.Note = "Each sphere covers a hundredth of the picture. Software OpenGL.";
  chart.X.Title = "spheres";
  chart.X.Log = true;
  chart.X.Ticks = { { 1., "1" }, { 10., "10" }, { 100., "100" }, { 1000., "1000" } };
  chart.Y.Title = "times a plain frame";
  for (const CsvRow& row : rows)
  {
    ChartSeries& series = SeriesOf(PanelOf(chart, row.at("scene")), "pairs of floats");
    series.Name = "fog";
    if (NumberIn(row, "share of the picture each") == 0.01)
    {
      series.X.push_back(NumberIn(row, "spheres"));
      series.Y.push_back(NumberIn(row, "times a plain frame"));
    }
  }
  chart.Columns = static_cast<int>(chart.Panels.size());
  return chart;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> FogCharts(const std::vector<CsvRows>& files)
{
  return { { "fog-error", ChordErrors(files[0]) }, { "fog-frames", FogFrames(files[1]) } };
}
}
