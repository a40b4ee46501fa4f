// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChartLabels.h
 * @brief Where the names of curves stand: at their ends, apart from each other.
 */
#ifndef relievoBenchChartLabels_h
#define relievoBenchChartLabels_h

#include "ChartDrawing.h"

#include <string>
#include <vector>

namespace relievoBench
{
constexpr double LabelSize = 12.;
constexpr double LabelHeight = 15.;
constexpr double RingRadius = 9.;

/** A curve, in pixels, and the name that it wants. */
struct LabelledCurve
{
  std::string Name;
  std::vector<ChartPoint> Points;
  bool Line = true;
  /** Which point has a ring; -1: none. */
  int Ring = -1;
};

struct PlacedLabel
{
  ChartBox Box;
  /** From the end of the curve to the name, if that is not beside it; else empty. */
  std::vector<ChartPoint> Leader;
};

/** Whether the curve ends at the right side of the plot: its name stands in the margin there. */
bool EndsAtRight(const LabelledCurve& curve, const ChartBox& plot);

/**
 * A place for each name: of curves that end at the right side of the plot in the margin beyond it,
 * of others in the plot, where they cover as little as can be. Curves without points get an empty
 * box. `room` is the plot with its margin.
 */
std::vector<PlacedLabel> PlaceLabels(
  const std::vector<LabelledCurve>& curves, const ChartBox& plot, const ChartBox& room);

/**
 * Centres at least `apart` from each other between low and high, in the order of what they want and
 * as near to that as can be: least squares, by pooling neighbours.
 */
std::vector<double> Spread(std::vector<double> wanted, double apart, double low, double high);
}

#endif
