// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Chart.h
 * @brief Charts of measured methods, one panel per scene, as PNG and SVG.
 *
 * A method has the same colour, marker and dash in every chart (ChartMethods.h), and its name
 * stands at the end of its curve, so that no legend is needed and none of it hangs on colour.
 */
#ifndef relievoBenchChart_h
#define relievoBenchChart_h

#include <string>
#include <utility>
#include <vector>

namespace relievoBench
{
/** One axis, the same in all panels. */
struct ChartAxis
{
  std::string Title;
  /** Powers of ten evenly spaced; values that are not positive are left out. */
  bool Log = false;
  /** Where to put marks and what to write there; empty: powers of ten, or even steps. */
  std::vector<std::pair<double, std::string>> Ticks;
};

/** What was measured of one method. */
struct ChartSeries
{
  /** A method of ChartMethods.h: it gives the style. */
  std::string Method;
  /** Written at the end of the curve, or before the row; empty: the method's own label. */
  std::string Name;
  std::vector<double> X;
  /** Of curves; rows have none. */
  std::vector<double> Y;
  /** Joins the points in their order. */
  bool Line = true;
  /** The point of the default settings, which gets a ring; -1: none. */
  int Default = -1;
};

struct ChartPanel
{
  std::string Title;
  std::vector<ChartSeries> Series;
};

/** A chart, 900 pixels wide. */
struct Chart
{
  enum Form
  {
    Curves, ///< Y over X
    Bars,   ///< a row per series, with a bar from 0 to each X
    Dots    ///< a row per series, with a mark at each X; an infinite one is written as such
  };
  Form Kind = Curves;
  std::string Title;
  /** A line under the title: what the marks mean. */
  std::string Note;
  ChartAxis X;
  ChartAxis Y;
  /** In rows from left to right, `Columns` in each. In bars and dots the first names the rows. */
  std::vector<ChartPanel> Panels;
  int Columns = 1;
};

/** The panel with a title: the first of them, or a new one after the others. */
ChartPanel& PanelOf(Chart& chart, const std::string& title);

/** The series of a method in a panel: the first of them, or a new one after the others. */
ChartSeries& SeriesOf(ChartPanel& panel, const std::string& method);

/**
 * Writes STEM.png and STEM.svg; the folder must be there. Needs a display. False, with a message
 * on the standard error, when a file cannot be written or a method is not in ChartMethods.h.
 */
bool WriteChart(const Chart& chart, const std::string& stem);
}

#endif
