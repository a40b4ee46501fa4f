// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChartSvg.h
 * @brief A chart as SVG, with its text as text.
 *
 * vtkSVGExporter (VTK 9.1 and 9.2) clips the plots of a vtkChartXY away: it places the clipping
 * rectangle in the plots' own coordinates. VTK's GL2PS exporter leaves the background out, writes
 * the date into the file, and is a module of its own that not every VTK has.
 */
#ifndef relievoBenchChartSvg_h
#define relievoBenchChartSvg_h

#include "Chart.h"

#include <string>

namespace relievoBench
{
/** The whole SVG document of a chart. */
std::string SvgOf(const Chart& chart);
}

#endif
