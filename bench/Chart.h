// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Chart.h
 * @brief Charts of measured series: PNG by VTK's charts, drawn off-screen, and SVG.
 */
#ifndef relievoBenchChart_h
#define relievoBenchChart_h

#include <string>
#include <utility>
#include <vector>

namespace relievoBench
{
/** One axis of a chart. */
struct ChartAxis
{
  std::string Title;
  /** Powers of ten evenly spaced; values that are not positive are left out. */
  bool Log = false;
  /** Where to put marks and what to write there; empty: powers of ten, or even steps. */
  std::vector<std::pair<double, std::string>> Ticks;
};

/** Points of one method, joined in their order unless Line is off; or bars from 0. */
struct ChartSeries
{
  std::string Name;
  std::vector<double> X;
  std::vector<double> Y;
  bool Line = true;
  /** Bars stand side by side around X, which must count 1, 2, 3 ... in every series of bars. */
  bool Bars = false;
};

/** A chart of 900 x 600 pixels, its legend beside the data; each series has a marker of its own. */
struct Chart
{
  std::string Title;
  ChartAxis X;
  ChartAxis Y;
  std::vector<ChartSeries> Series;
};

/**
 * Writes STEM.png and STEM.svg; the folder must be there. Needs a display. False, with a message
 * on the standard error, when a file cannot be written.
 */
bool WriteChart(const Chart& chart, const std::string& stem);
}

#endif
