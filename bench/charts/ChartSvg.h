// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChartSvg.h
 * @brief A drawing as SVG, with its text as text.
 */
#ifndef relievoBenchChartSvg_h
#define relievoBenchChartSvg_h

#include "ChartDrawing.h"

#include <string>

namespace relievoBench
{
/** The whole SVG document. */
std::string SvgOf(const ChartDrawing& drawing);
}

#endif
