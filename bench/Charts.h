// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Charts.h
 * @brief The charts of a bench, which charts.py draws.
 */
#ifndef relievoBenchCharts_h
#define relievoBenchCharts_h

#include <string>

namespace relievoBench
{
/**
 * Draws the charts of a bench, if it has any, from a folder's CSV files into that folder. Where
 * charts.py, its Python or matplotlib is missing, it says on the standard output how to draw them
 * elsewhere. False, with a message on the standard error, if they cannot be drawn otherwise.
 */
bool DrawCharts(const std::string& bench, const std::string& folder);
}

#endif
