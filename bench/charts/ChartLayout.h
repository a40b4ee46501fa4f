// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef relievoBenchChartLayout_h
#define relievoBenchChartLayout_h

#include "Chart.h"
#include "ChartDrawing.h"

namespace relievoBench
{
constexpr double ChartWidth = 900.; // as wide as a page shows a README

/** The drawing of a chart; every method must be in ChartMethods.h. */
ChartDrawing DrawChart(const Chart& chart);
}

#endif
