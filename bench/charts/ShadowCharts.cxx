// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Charts 4 and 5: wrong verdicts of shadows by method, map, light and time, and by the bias.
#include "BenchCharts.h"

#include <algorithm>
#include <iterator>

namespace relievoBench
{
namespace
{
const char* const Peer = "vtkShadowMapPass";

// Of wrong verdicts, in percent: two or three pixels of a picture, and fewer.
const double Hardly = 1e-3;

struct LitScene
{
  const char* Scene;
  const char* Light;
  const char* Title;
};

// A panel per scene and light, a curve per method; x by the map's size or by the time of a frame
// whose light moves.
Chart ShadowsChart(
  const std::string& title, const std::vector<LitScene>& scenes, const CsvRows& rows, bool overTime)
{
  Chart chart;
  chart.Title = title;
  chart.Note =
    std::string("Ring: the default, a map of 2048. exact has no map. Grey, VTK: ") + Peer + ".";
  chart.Columns = static_cast<int>(scenes.size());
  chart.X.Log = true;
  chart.X.Title = overTime ? "milliseconds of a frame whose light moves, maps of 512 to 4096"
                           : "side of the map, texels";
  if (overTime)
  {
    chart.X.Ticks = { { 10., "10" }, { 100., "100" }, { 1000., "1000" } };
  }
  else
  {
    chart.X.Ticks = { { 512., "512" }, { 1024., "1024" }, { 2048., "2048" }, { 4096., "4096" } };
  }
  chart.Y.Title = "wrong verdicts, % of pixels";
  chart.Y.Log = true;
  chart.Y.Ticks = { { Hardly, "< 0.001" }, { 0.01, "0.01" }, { 0.1, "0.1" }, { 1., "1" },
    { 10., "10" } };
  for (const LitScene& scene : scenes)
  {
    ChartPanel panel;
    panel.Title = scene.Title;
    for (const char* method : { "map", "warped", "forward", "exact", Peer })
    {
      ChartSeries series;
      series.Method = method;
      for (const CsvRow& row : rows)
      {
        if (row.at("scene") == scene.Scene && row.at("light") == scene.Light &&
          row.at("method") == method && row.at("window") == "600x600" &&
          row.at("shading") == "flat")
        {
          const double size = NumberIn(row, "map");
          series.Default = series.Method == "map" && size == 2048.
            ? static_cast<int>(series.X.size())
            : series.Default;
          series.X.push_back(overTime ? NumberIn(row, "moving ms") : size);
          series.Y.push_back(std::max(Hardly, NumberIn(row, "wrong %")));
        }
      }
      panel.Series.push_back(series);
    }
    chart.Panels.push_back(panel);
  }
  return chart;
}

const char* const BiasScenes[] = { "bunny", "motorBike", "slabs" };
const char* const BiasSuns[] = { "45", "10", "3" };
const char* const BiasNote = "Ring: the default, 1.5 texels. Grey, VTK: vtkShadowMapPass, which "
                             "has no bias to set. Maps of 2048.";

// The rows of a method in a panel.
CsvRows RowsOf(
  const CsvRows& rows, const std::string& scene, const std::string& sun, const std::string& method)
{
  CsvRows own;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(own), [&](const CsvRow& row) {
    return row.at("scene") == scene && row.at("sun, degrees") == sun && row.at("method") == method;
  });
  return own;
}

Chart WrongChart(const CsvRows& rows)
{
  Chart chart;
  chart.Title = "Wrong shadows against the bias";
  chart.Note = BiasNote;
  chart.Columns = 3;
  chart.X.Title = "bias, texels";
  chart.X.Log = true;
  for (double bias : { 0.25, 0.5, 1., 2., 4., 8., 16. })
  {
    chart.X.Ticks.emplace_back(bias, Number(bias));
  }
  chart.Y.Title = "wrong verdicts, % of pixels";
  chart.Y.Log = true;
  for (const char* sun : BiasSuns)
  {
    for (const char* scene : BiasScenes)
    {
      ChartPanel panel;
      panel.Title = std::string(scene) + ", sun at " + sun + "°";
      for (const char* method : { "map", "constant, computed" })
      {
        ChartSeries series;
        series.Method = method;
        for (const CsvRow& row : RowsOf(rows, scene, sun, method))
        {
          const double bias = NumberIn(row, "bias, texels");
          series.Default = series.Method == "map" && bias == 1.5 ? static_cast<int>(series.X.size())
                                                                 : series.Default;
          if (bias > 0.) // none has no place on this axis
          {
            series.X.push_back(bias);
            series.Y.push_back(NumberIn(row, "wrong %"));
          }
        }
        panel.Series.push_back(series);
      }
      for (const CsvRow& row : RowsOf(rows, scene, sun, Peer))
      {
        ChartSeries series;
        series.Method = Peer;
        series.X = { 0.25, 16. };
        series.Y.assign(2, NumberIn(row, "wrong %"));
        panel.Series.push_back(series);
      }
      chart.Panels.push_back(panel);
    }
  }
  return chart;
}

// Percent on a logarithmic axis; none, and hardly any, at its end.
constexpr double Least = 1e-3;

ChartAxis PercentAxis(const std::string& title)
{
  ChartAxis axis;
  axis.Title = title;
  axis.Log = true;
  axis.Ticks = { { Least, "0" }, { 1e-2, "0.01" }, { 0.1, "0.1" }, { 1., "1" }, { 10., "10" },
    { 100., "100" } };
  return axis;
}

Chart TradeChart(const std::string& sun, const CsvRows& rows)
{
  Chart chart;
  chart.Title = "False shadow against leak, sun at " + sun + "°, bias from 0 to 16 texels";
  chart.Note = BiasNote;
  chart.Columns = 3;
  chart.X = PercentAxis("leak, % of what is dark");
  chart.X.Ticks.erase(chart.X.Ticks.begin()); // at the end of this axis nothing is measured
  chart.Y = PercentAxis("false shadow, % of what is lit");
  for (const char* scene : BiasScenes)
  {
    ChartPanel panel;
    panel.Title = scene;
    for (const char* method : { "map", "constant, computed", Peer })
    {
      ChartSeries series;
      series.Method = method;
      for (const CsvRow& row : RowsOf(rows, scene, sun, method))
      {
        series.Default = series.Method == "map" && NumberIn(row, "bias, texels") == 1.5
          ? static_cast<int>(series.X.size())
          : series.Default;
        series.X.push_back(std::max(Least, NumberIn(row, "leak % of dark")));
        series.Y.push_back(std::max(Least, NumberIn(row, "false shadow % of lit")));
      }
      panel.Series.push_back(series);
    }
    chart.Panels.push_back(panel);
  }
  return chart;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> ShadowsCharts(const std::vector<CsvRows>& files)
{
  const CsvRows& rows = files[0];
  const char* const low = "sun at 10 degrees";
  return {
    { "shadows-meshes",
      ShadowsChart("Wrong shadows under the sun, real meshes",
        { { "bunny", "sun", "bunny" }, { "motorBike", "sun", "motorBike" },
          { "buildings", "sun", "buildings" } },
        rows, false) },
    { "shadows-lights",
      ShadowsChart("Wrong shadows of other lights, motorBike",
        { { "motorBike", low, "sun at 10°" }, { "motorBike", "spot", "spot" },
          { "motorBike", "point", "point" } },
        rows, false) },
    { "shadows-coded",
      ShadowsChart("Wrong shadows under the sun, scenes made by code",
        { { "spheres", "sun", "spheres" }, { "horizon", "sun", "poles to the horizon" },
          { "horizon", low, "the same, sun at 10°" } },
        rows, false) },
    { "shadows-time",
      ShadowsChart("Wrong shadows under the sun against frame time, software OpenGL",
        { { "bunny", "sun", "bunny" }, { "motorBike", "sun", "motorBike" },
          { "horizon", low, "horizon, sun at 10°" } },
        rows, true) },
  };
}

//------------------------------------------------------------------------------
std::vector<NamedChart> BiasCharts(const std::vector<CsvRows>& files)
{
  std::vector<NamedChart> charts = { { "bias-wrong", WrongChart(files[0]) } };
  for (const char* sun : BiasSuns)
  {
    charts.push_back({ std::string("bias-") + sun, TradeChart(sun, files[0]) });
  }
  return charts;
}
}
