// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartScale.h"

#include "Table.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace relievoBench
{
namespace
{
// Marks at 1, 2 or 5 times a power of ten, six or so of them.
void AddEvenTicks(ChartScale& scale)
{
  const double rough = (scale.High - scale.Low) / 6.;
  const double power = std::pow(10., std::floor(std::log10(rough)));
  const double times = rough / power;
  const double step = power * (times < 1.5 ? 1. : times < 3.5 ? 2. : times < 7.5 ? 5. : 10.);
  const double first = std::ceil(scale.Low / step - 1e-9);
  for (double i = first; i * step <= scale.High + 1e-9 * step; i += 1.)
  {
    const double place = i * step + 0.; // not -0
    scale.Ticks.emplace_back(place, Number(place));
  }
}

ChartScale Fit(const ChartAxis& axis, const std::vector<double>& values)
{
  ChartScale scale;
  scale.Log = axis.Log;
  scale.Low = std::numeric_limits<double>::infinity();
  scale.High = -scale.Low;
  for (double value : values)
  {
    if (scale.Has(value))
    {
      scale.Low = std::min(scale.Low, scale.Place(value));
      scale.High = std::max(scale.High, scale.Place(value));
    }
  }
  if (!(scale.Low <= scale.High))
  {
    scale.Low = 0.;
    scale.High = 1.;
  }
  for (const auto& tick : axis.Ticks)
  {
    const double place = scale.Place(tick.first);
    scale.Ticks.emplace_back(place, tick.second);
    scale.Low = std::min(scale.Low, place);
    scale.High = std::max(scale.High, place);
  }
  if (axis.Log && axis.Ticks.empty())
  {
    scale.Low = std::floor(scale.Low);
    scale.High = std::ceil(scale.High);
    for (int power = static_cast<int>(scale.Low); power <= static_cast<int>(scale.High); ++power)
    {
      scale.Ticks.emplace_back(power, "1e" + std::to_string(power));
    }
  }
  const double margin = scale.High > scale.Low ? 0.03 * (scale.High - scale.Low) : 0.5;
  scale.Low -= margin;
  scale.High += margin;
  if (scale.Ticks.empty())
  {
    AddEvenTicks(scale);
  }
  return scale;
}
}

//------------------------------------------------------------------------------
bool ChartScale::Has(double value) const
{
  return std::isfinite(value) && (!this->Log || value > 0.);
}

//------------------------------------------------------------------------------
double ChartScale::Place(double value) const
{
  return this->Log ? std::log10(value) : value;
}

//------------------------------------------------------------------------------
ChartScale FitX(const Chart& chart)
{
  std::vector<double> values;
  for (const ChartSeries& series : chart.Series)
  {
    for (double x : series.X)
    {
      // A group of bars has half a step of room on either side.
      values.insert(values.end(), { x - (series.Bars ? 0.5 : 0.), x + (series.Bars ? 0.5 : 0.) });
    }
  }
  return Fit(chart.X, values);
}

//------------------------------------------------------------------------------
ChartScale FitY(const Chart& chart)
{
  std::vector<double> values;
  for (const ChartSeries& series : chart.Series)
  {
    values.insert(values.end(), series.Y.begin(), series.Y.end());
  }
  if (!HasBars(chart))
  {
    return Fit(chart.Y, values);
  }
  values.push_back(0.);
  ChartScale scale = Fit(chart.Y, values);
  scale.Low = 0.;
  return scale;
}

//------------------------------------------------------------------------------
std::vector<std::pair<double, double>> Places(
  const ChartSeries& series, const ChartScale& x, const ChartScale& y)
{
  std::vector<std::pair<double, double>> places;
  for (std::size_t i = 0; i < std::min(series.X.size(), series.Y.size()); ++i)
  {
    if (x.Has(series.X[i]) && y.Has(series.Y[i]))
    {
      places.emplace_back(x.Place(series.X[i]), y.Place(series.Y[i]));
    }
  }
  return places;
}

//------------------------------------------------------------------------------
bool HasBars(const Chart& chart)
{
  return std::any_of(chart.Series.begin(), chart.Series.end(),
    [](const ChartSeries& series) { return series.Bars; });
}

//------------------------------------------------------------------------------
ChartStyle StyleOf(int index)
{
  // Okabe and Ito's colours, told apart by all kinds of colour vision; without their yellow, which
  // is too light for lines on white.
  static const unsigned char colors[][3] = { { 0, 114, 178 }, { 213, 94, 0 }, { 0, 158, 115 },
    { 204, 121, 167 }, { 0, 0, 0 }, { 230, 159, 0 }, { 86, 180, 233 } };
  static const ChartStyle::Shape shapes[] = { ChartStyle::Circle, ChartStyle::Square,
    ChartStyle::Diamond, ChartStyle::Plus, ChartStyle::Cross };
  ChartStyle style;
  std::copy_n(colors[index % std::size(colors)], 3, style.Color);
  style.Marker = shapes[index % std::size(shapes)];
  style.Dashed = index >= 4;
  return style;
}
}
