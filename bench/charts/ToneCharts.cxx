// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tone operators, and the bands of a gradient.
#include "BenchCharts.h"

namespace relievoBench
{
namespace
{
// A curve per method, in the order of the rows.
ChartPanel MakePanel(const CsvRows& rows, const std::string& method, const std::string& x,
  const std::string& y, const std::string& title)
{
  ChartPanel panel;
  panel.Title = title;
  for (const CsvRow& row : rows)
  {
    ChartSeries& series = SeriesOf(panel, row.at(method));
    series.X.push_back(NumberIn(row, x));
    series.Y.push_back(NumberIn(row, y));
  }
  return panel;
}
}

//------------------------------------------------------------------------------
std::vector<NamedChart> ToneCharts(const std::vector<CsvRows>& files)
{
  Chart curves;
  curves.Title = "Tone operators: what light is shown as";
  curves.Note = "White at 4, where the Reinhard curves end: 2 stops.";
  curves.X.Title = "light, stops above 1";
  for (int stops = -6; stops <= 6; stops += 2)
  {
    curves.X.Ticks.emplace_back(stops, std::to_string(stops));
  }
  curves.Y.Title = "shown, steps of 255";
  curves.Panels = { MakePanel(files[0], "operator", "stops", "grey, steps of 255", "grey light"),
    MakePanel(files[0], "operator", "stops", "red's green, steps of 255",
      "red light: how much green is shown") };
  curves.Columns = 2;
  Chart bands;
  bands.Title = "A gradient of four steps of 255";
  bands.Note = "Means over 16 x 64 pixels.";
  bands.X.Title = "value, steps of 255";
  bands.Y.Title = "mean of the picture - value, steps of 255";
  bands.Panels = { MakePanel(
    files[1], "dither", "value, steps of 255", "mean error, steps of 255", "") };
  return { { "tone-curves", curves }, { "tone-bands", bands } };
}
}
