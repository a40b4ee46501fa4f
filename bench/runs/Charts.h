// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Charts.h
 * @brief Draws the charts of a bench with charts.py.
 */
#ifndef relievoBenchCharts_h
#define relievoBenchCharts_h

#include <string>

namespace relievoBench
{
/**
 * Draws the charts of a bench, if it has any, from a folder's CSV files into that folder. If
 * charts.py, its Python or matplotlib is missing, prints how to draw them elsewhere. False, with a
 * message on the standard error, if drawing fails for another reason.
 */
bool DrawCharts(const std::string& bench, const std::string& folder);
}

#endif
