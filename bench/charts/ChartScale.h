// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChartScale.h
 * @brief An axis fitted to what all panels of a chart show.
 */
#ifndef relievoBenchChartScale_h
#define relievoBenchChartScale_h

#include "Chart.h"

#include <string>
#include <utility>
#include <vector>

namespace relievoBench
{
/** Places are values, or their logarithms to base 10. */
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

  /** The same from 0 at Low to 1 at High. */
  double Share(double value) const;
};

/** The scales of a chart, with a margin around the data of all panels. */
ChartScale FitX(const Chart& chart);
ChartScale FitY(const Chart& chart);
}

#endif
