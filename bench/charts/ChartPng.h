// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef relievoBenchChartPng_h
#define relievoBenchChartPng_h

#include "ChartDrawing.h"

#include <string>

namespace relievoBench
{
/** Draws off screen by VTK; needs a display. False, if the file cannot be written. */
bool WritePng(const ChartDrawing& drawing, const std::string& path);
}

#endif
