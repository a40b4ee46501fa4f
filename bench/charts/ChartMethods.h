// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChartMethods.h
 * @brief Every method that charts show, with the one look that it has in all of them.
 */
#ifndef relievoBenchChartMethods_h
#define relievoBenchChartMethods_h

#include <string>
#include <vector>

namespace relievoBench
{
/** Colours of Okabe and Ito, told apart by all kinds of colour vision; grey is for peers. */
enum class ChartColor
{
  Blue,
  Vermillion,
  Green,
  Purple,
  Orange,
  Sky,
  Black,
  Grey
};

enum class ChartMarker
{
  Circle,
  Square,
  Diamond,
  Up,
  Down,
  Plus,
  Cross
};

enum class ChartDash
{
  Solid,
  Dashed,
  Dotted,
  DashDotted
};

struct ChartMethod
{
  std::string Name;  ///< as the CSV files have it
  std::string Label; ///< as the charts have it
  ChartColor Color;  ///< grey: a peer, or what Relievo does not offer
  ChartMarker Marker;
  ChartDash Dash;
};

/** All methods; each name once. */
const std::vector<ChartMethod>& ChartMethods();

/** The method of this name; null, if there is none. */
const ChartMethod* FindChartMethod(const std::string& name);

/** "#0072b2" and the like. */
const char* HexOf(ChartColor color);

/** The same, darker: for text on white. */
const char* DarkHexOf(ChartColor color);
}

#endif
