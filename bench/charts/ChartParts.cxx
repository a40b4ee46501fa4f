// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The panels and series of a chart, by their names.
#include "Chart.h"

#include <algorithm>

namespace relievoBench
{
//------------------------------------------------------------------------------
ChartPanel& PanelOf(Chart& chart, const std::string& title)
{
  auto panel = std::find_if(chart.Panels.begin(), chart.Panels.end(),
    [&title](const ChartPanel& each) { return each.Title == title; });
  if (panel == chart.Panels.end())
  {
    panel = chart.Panels.emplace(panel);
    panel->Title = title;
  }
  return *panel;
}

//------------------------------------------------------------------------------
ChartSeries& SeriesOf(ChartPanel& panel, const std::string& method)
{
  auto series = std::find_if(panel.Series.begin(), panel.Series.end(),
    [&method](const ChartSeries& each) { return each.Method == method; });
  if (series == panel.Series.end())
  {
    series = panel.Series.emplace(series);
    series->Method = method;
  }
  return *series;
}
}
