// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Charts 7 and 8: methods of relief, and maps of environments.
#include "BenchCharts.h"

#include <cmath>

namespace relievoBench
{
namespace
{
// "relief 16" and "relief, by texels (default)" are both relief.
std::string ReliefMethod(const std::string& name)
{
  return name.substr(0, name.find_first_of(" ,"));
}

bool IsByTexels(const std::string& name)
{
  return name.find("by texels") != std::string::npos;
}

bool IsDefault(const std::string& name)
{
  return name.find("(default)") != std::string::npos;
}

// Waves at 60 degrees: a curve per method, through its numbers of steps, and the default.
Chart ReliefErrors(const CsvRows& rows, bool overTime)
{
  Chart chart;
  chart.Title = overTime ? "Relief: depth error against frame time, waves at 60 degrees"
                         : "Relief: depth error against looks, waves at 60 degrees";
  chart.Note =
    "Along a curve: 16, 32, 64 steps. Ring: the default, steps by the texels passed over.";
  chart.X.Title =
    overTime ? "times a plain frame, software OpenGL" : "looks at the heights per pixel";
  chart.X.Log = !overTime;
  if (!overTime)
  {
    chart.X.Ticks = { { 1., "1" }, { 2., "2" }, { 5., "5" }, { 10., "10" }, { 20., "20" },
      { 50., "50" } };
  }
  chart.Y.Title = "mean depth error, share of the relief's height";
  chart.Y.Log = true;
  chart.Panels.resize(1);
  for (const char* method : { "parallax", "steep", "occlusion", "relief" })
  {
    for (const bool byTexels : { false, true })
    {
      ChartSeries series;
      series.Method = method;
      series.Name = byTexels ? std::string(method) + ", by texels" : "";
      for (const CsvRow& row : rows)
      {
        const std::string& name = row.at("method");
        if (row.at("field") != "waves" || row.at("degrees") != "60" ||
          ReliefMethod(name) != method || IsByTexels(name) != byTexels)
        {
          continue;
        }
        series.Default = IsDefault(name) ? 0 : -1;
        // What is missed is off by more than 5 % of the height, and counts as that.
        const double missed = 0.01 * NumberIn(row, "missed %");
        series.X.push_back(NumberIn(row, overTime ? "times a plain frame (waves, 60)" : "looks"));
        series.Y.push_back(
          0.01 * NumberIn(row, "depth error % of height") * (1. - missed) + 0.05 * missed);
      }
      chart.Panels[0].Series.push_back(series);
    }
  }
  return chart;
}

// Thin posts: a curve per way.
Chart ReliefMissed(const CsvRows& rows)
{
  Chart chart;
  chart.Title = "Relief: thin posts that are missed";
  chart.Note = "Posts 4 texels thin. Ring: the default.";
  chart.X.Title = "degrees off the normal";
  for (const double angle : { 0., 15., 30., 45., 60., 75. })
  {
    chart.X.Ticks.emplace_back(angle, Number(angle));
  }
  chart.Y.Title = "% of pixels";
  chart.Panels.resize(1);
  std::string last;
  for (const CsvRow& row : rows)
  {
    const std::string& name = row.at("method");
    const std::string method = ReliefMethod(name);
    if (row.at("field") == "waves" || (method != "relief" && !IsByTexels(name)))
    {
      continue;
    }
    std::vector<ChartSeries>& all = chart.Panels[0].Series;
    if (name != last)
    {
      all.emplace_back();
      all.back().Method = method;
      all.back().Name = IsByTexels(name) ? method + ", by texels" : name + " steps";
      last = name;
    }
    all.back().Default = IsDefault(name) ? static_cast<int>(all.back().X.size()) : -1;
    all.back().X.push_back(NumberIn(row, "degrees"));
    all.back().Y.push_back(NumberIn(row, "missed %"));
  }
  return chart;
}

std::string MapMethod(const std::string& map)
{
  return map == "octahedral" ? "octahedral map" : map; // normals have an octahedral format
}

// A panel per environment, a curve per map.
Chart EnvironmentChart(const CsvRows& rows, const std::string& x)
{
  Chart chart;
  chart.Note = "Ring: the default.";
  chart.Y.Title = "RMS error / mean light";
  chart.Y.Log = true;
  for (const CsvRow& row : rows)
  {
    const std::string method = MapMethod(row.at("map"));
    ChartSeries& series = SeriesOf(PanelOf(chart, row.at("environment")), method);
    series.Default = method == "cube" ? static_cast<int>(series.X.size()) : -1;
    series.X.push_back(NumberIn(row, x));
    series.Y.push_back(NumberIn(row, "RMS error / mean light"));
  }
  chart.Columns = static_cast<int>(chart.Panels.size());
  return chart;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> ReliefCharts(const std::vector<CsvRows>& files)
{
  return { { "relief-error", ReliefErrors(files[0], false) },
    { "relief-cost", ReliefErrors(files[0], true) }, { "relief-missed", ReliefMissed(files[0]) } };
}

//------------------------------------------------------------------------------
std::vector<NamedChart> EnvironmentCharts(const std::vector<CsvRows>& files)
{
  Chart texels = EnvironmentChart(files[0], "texels");
  texels.Title = "Environments: error against texels";
  texels.X.Title = "texels";
  texels.X.Log = true;
  Chart angle = EnvironmentChart(files[1], "degrees");
  angle.Title = "Environments: error by angle";
  if (!files[1].empty())
  {
    angle.Title += ", " + files[1][0].at("texels") + " texels";
  }
  angle.X.Title = "degrees from the map's axis (of lat-long: from its pole)";
  for (int ticks = 0; ticks <= 180; ticks += 30)
  {
    angle.X.Ticks.emplace_back(ticks, std::to_string(ticks));
  }
  return { { "environment-texels", texels }, { "environment-angle", angle } };
}
}
