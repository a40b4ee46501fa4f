// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChartScale.h
 * @brief What the PNG and the SVG of a chart share: places on axes, marks, colours.
 */
#ifndef relievoBenchChartScale_h
#define relievoBenchChartScale_h

#include "Chart.h"

#include <string>
#include <utility>
#include <vector>

namespace relievoBench
{
/** An axis fitted to the data: places are values, or their logarithms to base 10. */
struct ChartScale
{
  bool Log = false;
  double Low = 0.;
  double High = 1.;
  std::vector<std::pair<double, std::string>> Ticks; // place and label

  /** Whether the value has a place: finite, and positive on a logarithmic axis. */
  bool Has(double value) const;

  /** The place of a value. */
  double Place(double value) const;
};

/** The scales of a chart, with a margin around the data. */
ChartScale FitX(const Chart& chart);
ChartScale FitY(const Chart& chart);

/** The points of a series that have a place on both axes, as places. */
std::vector<std::pair<double, double>> Places(
  const ChartSeries& series, const ChartScale& x, const ChartScale& y);

/** Whether the series of a chart are bars, and the share of a group's room that they take. */
bool HasBars(const Chart& chart);
constexpr double BarShare = 0.8;

/** How a series is drawn. */
struct ChartStyle
{
  enum Shape
  {
    Circle,
    Square,
    Diamond,
    Plus,
    Cross
  };
  unsigned char Color[3];
  Shape Marker;
  bool Dashed; // later series: where two lines lie on each other, both are seen
};

/** The style of series `index`; colour and marker together repeat after 35. */
ChartStyle StyleOf(int index);

constexpr int ChartWidth = 900;
constexpr int ChartHeight = 600;
}

#endif
