// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bones: error by keys per second, and the volume that a tube keeps.
#include "BenchCharts.h"

#include <algorithm>

namespace relievoBench
{
namespace
{
// A panel per motion and a curve per method, in the order of the rows.
void AddCurves(Chart& chart, const CsvRows& rows, const std::string& x, const std::string& y)
{
  for (const CsvRow& row : rows)
  {
    ChartSeries& series = SeriesOf(PanelOf(chart, row.at("motion")), row.at("method"));
    series.X.push_back(NumberIn(row, x));
    series.Y.push_back(NumberIn(row, y));
  }
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> SkinCharts(const std::vector<CsvRows>& files)
{
  Chart keys;
  keys.Title = "A turning arm, by the keys of its motion";
  keys.Note = "Lower is better. Slerp's error of one turn a second is rounding, and not drawn.";
  keys.X.Title = "keys per second";
  keys.X.Log = true;
  for (const int tick : { 4, 8, 15, 30, 60, 120 })
  {
    keys.X.Ticks.emplace_back(tick, std::to_string(tick));
  }
  keys.Y.Title = "largest error of the arm's end, arm's lengths";
  keys.Y.Log = true;
  CsvRows visible;
  for (const CsvRow& row : files[0])
  {
    if (NumberIn(row, "largest error of the arm's end, arm's lengths") > 1e-9)
    {
      visible.push_back(row);
    }
  }
  AddCurves(keys, visible, "keys per second", "largest error of the arm's end, arm's lengths");
  keys.Columns = 3;
  Chart volume;
  volume.Title = "Volume of a tube between two bones";
  volume.Note = "100 is right. The bones share the middle half of the tube.";
  volume.X.Title = "degrees";
  for (const int tick : { 0, 45, 90, 135, 180 })
  {
    volume.X.Ticks.emplace_back(tick, std::to_string(tick));
  }
  volume.Y.Title = "volume, % of the rest";
  AddCurves(volume, files[1], "degrees", "volume, % of the rest");
  volume.Columns = 2;
  Chart time;
  time.Title = "Skinning a million points, by the number of bones";
  time.Note = "Lower is better. Four weights a point, points and normals.";
  time.X.Title = "bones";
  time.X.Log = true;
  for (const int tick : { 4, 32, 100, 1000 })
  {
    time.X.Ticks.emplace_back(tick, std::to_string(tick));
  }
  time.Y.Title = "ms";
  time.Y.Log = true;
  time.Panels.emplace_back();
  for (const CsvRow& row : files[2])
  {
    const std::string method =
      row.at("method") + (row.at("on") == "CPU" ? "" : ", " + row.at("on"));
    std::vector<ChartSeries>& series = time.Panels.back().Series;
    auto own = std::find_if(series.begin(), series.end(),
      [&method](const ChartSeries& each) { return each.Method == method; });
    if (own == series.end())
    {
      series.emplace_back();
      series.back().Method = method;
      own = series.end() - 1;
    }
    own->X.push_back(NumberIn(row, "bones"));
    own->Y.push_back(NumberIn(row, "ms per million points"));
  }
  return { { "skin-keys", keys }, { "skin-volume", volume }, { "skin", time } };
}
}
