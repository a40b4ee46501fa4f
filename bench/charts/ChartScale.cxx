// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartScale.h"

#include "Table.h"

#include <algorithm>
#include <cmath>
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

// As people write it where that is short.
std::string PowerOfTen(int power)
{
  return power < -3 || power > 4 ? "1e" + std::to_string(power) : Number(std::pow(10., power), 6);
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
  const bool powers = axis.Log && axis.Ticks.empty();
  if (powers && std::floor(scale.High) - std::ceil(scale.Low) < 1.)
  {
    // Less than two powers of ten are within the data.
    scale.Low = std::floor(scale.Low);
    scale.High = std::ceil(scale.High);
  }
  const double margin = scale.High > scale.Low ? 0.05 * (scale.High - scale.Low) : 0.5;
  scale.Low -= margin;
  scale.High += margin;
  for (int power = static_cast<int>(std::ceil(scale.Low)); powers && power <= scale.High; ++power)
  {
    scale.Ticks.emplace_back(power, PowerOfTen(power));
  }
  if (scale.Ticks.empty())
  {
    AddEvenTicks(scale);
  }
  return scale;
}

std::vector<double> ValuesOf(const Chart& chart, std::vector<double> ChartSeries::*which)
{
  std::vector<double> values;
  for (const ChartPanel& panel : chart.Panels)
  {
    for (const ChartSeries& series : panel.Series)
    {
      values.insert(values.end(), (series.*which).begin(), (series.*which).end());
    }
  }
  if (chart.Kind == Chart::Bars)
  {
    values.push_back(0.);
  }
  return values;
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
double ChartScale::Share(double value) const
{
  return (this->Place(value) - this->Low) / (this->High - this->Low);
}

//------------------------------------------------------------------------------
ChartScale FitX(const Chart& chart)
{
  ChartScale scale = Fit(chart.X, ValuesOf(chart, &ChartSeries::X));
  if (chart.Kind == Chart::Bars)
  {
    scale.Low = 0.;
  }
  return scale;
}

//------------------------------------------------------------------------------
ChartScale FitY(const Chart& chart)
{
  return Fit(chart.Y, ValuesOf(chart, &ChartSeries::Y));
}
}
