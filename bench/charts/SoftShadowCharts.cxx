// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Soft shadows: the error of what is seen of a light against the samples of it.
#include "BenchCharts.h"

#include <algorithm>

namespace relievoBench
{
//------------------------------------------------------------------------------
std::vector<NamedChart> SoftShadowCharts(const std::vector<CsvRows>& files)
{
  Chart chart;
  chart.Title = "Soft shadows: error in the penumbra against samples";
  chart.Note = "Lower is better. rms of the light's share, against rays to all of the light.";
  chart.X.Title = "samples";
  chart.X.Log = true;
  chart.Y.Title = "rms error of pixels in the penumbra";
  chart.Y.Log = true;
  for (const CsvRow& row : files[0])
  {
    ChartPanel& panel = PanelOf(chart, row.at("scene") + ", " + row.at("light"));
    ChartSeries& series = SeriesOf(panel, row.at("method"));
    const double samples = NumberIn(row, "samples");
    series.X.push_back(samples);
    series.Y.push_back(NumberIn(row, "penumbra rms"));
    const auto isThis = [samples](const auto& tick) { return tick.first == samples; };
    if (std::none_of(chart.X.Ticks.begin(), chart.X.Ticks.end(), isThis))
    {
      chart.X.Ticks.emplace_back(samples, row.at("samples"));
    }
  }
  chart.Columns = std::min(3, std::max(1, static_cast<int>(chart.Panels.size())));
  return { { "soft-shadows", chart } };
}
}
