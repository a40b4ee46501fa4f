// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Particles on surfaces: time of a step by their number, and distance to the surface by steps.
#include "BenchCharts.h"

#include <algorithm>

namespace relievoBench
{
namespace
{
// A panel for each body, a series for each method.
Chart PerBody(const CsvRows& rows, const std::string& x, const std::string& y)
{
  Chart chart;
  for (const CsvRow& row : rows)
  {
    if (!(NumberIn(row, y) > 0.))
    {
      continue; // on the surface itself: not on a logarithmic scale
    }
    ChartSeries& series = SeriesOf(PanelOf(chart, row.at("body")), row.at("method"));
    series.X.push_back(NumberIn(row, x));
    series.Y.push_back(NumberIn(row, y));
  }
  chart.X.Log = true;
  chart.Y.Log = true;
  chart.Columns = std::max(1, static_cast<int>(chart.Panels.size()));
  return chart;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> ParticleCharts(const std::vector<CsvRows>& files)
{
  Chart time = PerBody(files[0], "particles", "core milliseconds");
  time.Title = "Particles on surfaces: time of a step";
  time.Note = "Lower is better. Of all cores together.";
  time.X.Title = "particles";
  time.Y.Title = "milliseconds of cores";
  Chart drift = PerBody(files[1], "steps", "largest texels");
  drift.Title = "Particles on surfaces: largest distance to the surface";
  drift.Note = "Lower is better. By vtkStaticCellLocator.";
  drift.X.Title = "steps";
  drift.Y.Title = "texels";
  return { { "particles-time", time }, { "particles-drift", drift } };
}
}
