// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChartDrawing.h
 * @brief What a chart is made of: lines, areas and text, in pixels, y down.
 */
#ifndef relievoBenchChartDrawing_h
#define relievoBenchChartDrawing_h

#include "ChartMethods.h"

#include <string>
#include <vector>

namespace relievoBench
{
struct ChartPoint
{
  double X = 0.;
  double Y = 0.;
};

struct ChartBox
{
  double Left = 0.;
  double Top = 0.;
  double Right = 0.;
  double Bottom = 0.;

  bool Meets(const ChartBox& other) const;
  /** Whether the segment from a to b passes through. */
  bool Meets(const ChartPoint& a, const ChartPoint& b) const;
};

/** A thing drawn. */
struct ChartMark
{
  enum Shape
  {
    Line, ///< through Points
    Area, ///< within Points
    Disc, ///< about Points[0]
    Ring,
    Words
  };
  enum Side
  {
    Start,
    Middle,
    End
  };
  Shape Kind = Line;
  std::vector<ChartPoint> Points;
  std::string Color = "#000000";
  /** Of the method that it shows; empty: of none. */
  std::string Method;
  /** Of lines and rings: the width of the line. */
  double Width = 1.;
  ChartDash Dash = ChartDash::Solid;
  /** Of discs and rings. */
  double Radius = 0.;
  /** Of words: Points[0] is half way up, at this side of them. Size in pixels. */
  std::string Text;
  double Size = 0.;
  Side Anchor = Start;
  /** Read from below upwards. */
  bool Upright = false;
};

struct ChartDrawing
{
  std::string Title;
  double Width = 0.;
  double Height = 0.;
  std::vector<ChartMark> Marks; ///< later ones lie over earlier ones
};

/** The width of UTF-8 text in pixels, at least. */
double TextWidth(const std::string& text, double size);

/** The room of words. */
ChartBox BoxOf(const ChartMark& text);
}

#endif
