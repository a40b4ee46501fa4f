// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef relievoBenchChartMarkers_h
#define relievoBenchChartMarkers_h

#include "ChartDrawing.h"

namespace relievoBench
{
/** The marker of a method about a point. */
ChartMark MarkerMark(const ChartMethod& method, const ChartPoint& at);
}

#endif
