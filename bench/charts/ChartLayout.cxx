// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartLayout.h"

#include "ChartLabels.h"
#include "ChartMarkers.h"
#include "ChartScale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace relievoBench
{
namespace
{
constexpr double TitleSize = 16.;
constexpr double PanelTitleSize = 14.;
constexpr double TickSize = 12.;
constexpr double AxisSize = 13.;
constexpr double Edge = 12.;      // of the picture
constexpr double PanelHead = 26.; // over a panel, with its title
constexpr double BareHead = 8.;   // over one without
constexpr double PanelFoot = 24.; // under it, with the marks of its axis
constexpr double RowHeight = 26.;
constexpr const char* GridColor = "#e1e1e1";
constexpr const char* AxisColor = "#404040";
constexpr const char* NoteColor = "#404040";

ChartMark Words(const std::string& text, double x, double y, double size, ChartMark::Side anchor,
  const char* color = "#000000")
{
  ChartMark mark;
  mark.Kind = ChartMark::Words;
  mark.Text = text;
  mark.Points = { { x, y } };
  mark.Size = size;
  mark.Anchor = anchor;
  mark.Color = color;
  return mark;
}

ChartMark Line(std::vector<ChartPoint> points, const char* color, double width = 1.)
{
  ChartMark mark;
  mark.Points = std::move(points);
  mark.Color = color;
  mark.Width = width;
  return mark;
}

ChartMark Ring(const ChartPoint& at)
{
  ChartMark mark;
  mark.Kind = ChartMark::Ring;
  mark.Points = { at };
  mark.Radius = RingRadius;
  mark.Width = 1.5;
  return mark;
}

const std::string& NameOf(const ChartSeries& series)
{
  const ChartMethod* method = FindChartMethod(series.Method);
  return series.Name.empty() && method ? method->Label : series.Name;
}

class Layout
{
public:
  explicit Layout(const Chart& chart);
  ChartDrawing Draw();

private:
  void DrawHead();
  void DrawFrame(std::size_t panel, const ChartBox& plot);
  void DrawCurves(const ChartPanel& panel, const ChartBox& plot);
  void DrawRows(const ChartPanel& panel, const ChartBox& plot, bool first);
  void DrawAxisTitles(const ChartBox& all);
  ChartBox PlotOf(std::size_t panel) const;
  bool IsRows() const { return this->Wanted.Kind != Chart::Curves; }
  std::size_t Rows() const;

  const Chart& Wanted;
  ChartScale X;
  ChartScale Y;
  ChartDrawing Drawing;
  double Left;   // of the first panel's plot
  double Margin; // right of each plot, for names
  double Gap;    // between a margin and the next plot
  double Top;
  double Head;
  double Width;
  double Height;
};

//------------------------------------------------------------------------------
Layout::Layout(const Chart& chart)
  : Wanted(chart)
  , X(FitX(chart))
  , Y(FitY(chart))
{
  double names = 0.;
  double ticks = 0.;
  std::size_t rows = 0;
  for (const ChartPanel& panel : chart.Panels)
  {
    rows = std::max(rows, panel.Series.size());
    for (const ChartSeries& series : panel.Series)
    {
      const bool atEnd = this->IsRows() ||
        (!series.X.empty() && this->X.Has(series.X.back()) &&
          this->X.Share(series.X.back()) > 0.85);
      names = std::max(names, atEnd ? TextWidth(NameOf(series), LabelSize) : 0.);
    }
  }
  for (const auto& tick : this->Y.Ticks)
  {
    ticks = std::max(ticks, TextWidth(tick.second, TickSize));
  }
  const double columns = std::max(1, chart.Columns);
  this->Left = Edge + (this->IsRows() ? names + 10. : AxisSize + 10. + ticks + 8.);
  this->Margin = this->IsRows() ? 14. : names > 0. ? names + 18. : 6.;
  this->Gap = 12.;
  this->Top = Edge + TitleSize + 8. + (chart.Note.empty() ? 0. : TickSize + 8.);
  this->Head = std::any_of(chart.Panels.begin(), chart.Panels.end(),
                 [](const ChartPanel& panel) { return !panel.Title.empty(); })
    ? PanelHead
    : BareHead;
  this->Width =
    (ChartWidth - Edge - this->Left - columns * this->Margin - (columns - 1.) * this->Gap) /
    columns;
  this->Height = this->IsRows() ? RowHeight * static_cast<double>(rows)
    : this->Rows() > 1          ? (columns > 1 ? 180. : 230.)
                                : (columns > 2 ? 300. : 340.);
}

//------------------------------------------------------------------------------
std::size_t Layout::Rows() const
{
  const auto columns = static_cast<std::size_t>(std::max(1, this->Wanted.Columns));
  return (this->Wanted.Panels.size() + columns - 1) / columns;
}

//------------------------------------------------------------------------------
ChartBox Layout::PlotOf(std::size_t panel) const
{
  const auto columns = static_cast<std::size_t>(std::max(1, this->Wanted.Columns));
  const auto column = static_cast<double>(panel % columns);
  const auto row = static_cast<double>(panel / columns);
  const double left = this->Left + column * (this->Width + this->Margin + this->Gap);
  const double top = this->Top + this->Head + row * (this->Head + this->Height + PanelFoot);
  return { left, top, left + this->Width, top + this->Height };
}

//------------------------------------------------------------------------------
void Layout::DrawHead()
{
  auto& marks = this->Drawing.Marks;
  marks.push_back(
    Words(this->Wanted.Title, Edge, Edge + 0.5 * TitleSize, TitleSize, ChartMark::Start));
  if (!this->Wanted.Note.empty())
  {
    marks.push_back(Words(this->Wanted.Note, Edge, Edge + TitleSize + 8. + 0.5 * TickSize, TickSize,
      ChartMark::Start, NoteColor));
  }
}

//------------------------------------------------------------------------------
void Layout::DrawFrame(std::size_t panel, const ChartBox& plot)
{
  auto& marks = this->Drawing.Marks;
  if (const std::string& title = this->Wanted.Panels[panel].Title; !title.empty())
  {
    marks.push_back(Words(title, plot.Left, plot.Top - 12., PanelTitleSize, ChartMark::Start));
  }
  for (const auto& tick : this->X.Ticks)
  {
    const double share = (tick.first - this->X.Low) / (this->X.High - this->X.Low);
    const double x = plot.Left + share * (plot.Right - plot.Left);
    marks.push_back(Line({ { x, plot.Top }, { x, plot.Bottom } }, GridColor));
    marks.push_back(Words(tick.second, x, plot.Bottom + 12., TickSize, ChartMark::Middle));
  }
  const bool first = panel % static_cast<std::size_t>(std::max(1, this->Wanted.Columns)) == 0;
  for (const auto& tick : this->Y.Ticks)
  {
    if (this->IsRows())
    {
      break;
    }
    const double share = (tick.first - this->Y.Low) / (this->Y.High - this->Y.Low);
    const double y = plot.Bottom - share * (plot.Bottom - plot.Top);
    marks.push_back(Line({ { plot.Left, y }, { plot.Right, y } }, GridColor));
    if (first)
    {
      marks.push_back(Words(tick.second, plot.Left - 7., y, TickSize, ChartMark::End));
    }
  }
  marks.push_back(Line({ { plot.Left, plot.Bottom }, { plot.Right, plot.Bottom } }, AxisColor));
  marks.push_back(Line({ { plot.Left, plot.Top }, { plot.Left, plot.Bottom } }, AxisColor));
}

//------------------------------------------------------------------------------
void Layout::DrawCurves(const ChartPanel& panel, const ChartBox& plot)
{
  auto& marks = this->Drawing.Marks;
  std::vector<LabelledCurve> curves;
  std::vector<ChartMark> over; // markers and rings lie over all lines
  const std::size_t begin = marks.size();
  for (const ChartSeries& series : panel.Series)
  {
    const ChartMethod& method = *FindChartMethod(series.Method);
    LabelledCurve curve{ NameOf(series), {}, series.Line, -1 };
    for (std::size_t i = 0; i < std::min(series.X.size(), series.Y.size()); ++i)
    {
      if (this->X.Has(series.X[i]) && this->Y.Has(series.Y[i]))
      {
        curve.Points.push_back({ plot.Left + this->X.Share(series.X[i]) * (plot.Right - plot.Left),
          plot.Bottom - this->Y.Share(series.Y[i]) * (plot.Bottom - plot.Top) });
        over.push_back(MarkerMark(method, curve.Points.back()));
        if (series.Default == static_cast<int>(i))
        {
          curve.Ring = static_cast<int>(curve.Points.size()) - 1;
          over.push_back(Ring(curve.Points.back()));
        }
      }
    }
    if (series.Line && curve.Points.size() > 1)
    {
      ChartMark line = Line(curve.Points, HexOf(method.Color), 1.8);
      line.Method = method.Name;
      line.Dash = method.Dash;
      marks.push_back(line);
    }
    curves.push_back(curve);
  }
  // Where two curves lie on each other, the dashes of one show both.
  const auto first = marks.begin() + static_cast<std::ptrdiff_t>(begin);
  std::stable_partition(
    first, marks.end(), [](const ChartMark& mark) { return mark.Dash == ChartDash::Solid; });
  marks.insert(marks.end(), over.begin(), over.end());
  const ChartBox room = { plot.Left + 2., plot.Top - 4., plot.Right + this->Margin,
    plot.Bottom - 2. };
  const std::vector<PlacedLabel> labels = PlaceLabels(curves, plot, room);
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    if (curves[i].Points.empty())
    {
      continue;
    }
    const ChartMethod& method = *FindChartMethod(panel.Series[i].Method);
    if (!labels[i].Leader.empty())
    {
      marks.push_back(Line(labels[i].Leader, DarkHexOf(method.Color), 0.8));
    }
    ChartMark name =
      Words(curves[i].Name, labels[i].Box.Left, 0.5 * (labels[i].Box.Top + labels[i].Box.Bottom),
        LabelSize, ChartMark::Start, DarkHexOf(method.Color));
    name.Method = method.Name;
    marks.push_back(name);
  }
}

//------------------------------------------------------------------------------
void Layout::DrawRows(const ChartPanel& panel, const ChartBox& plot, bool first)
{
  auto& marks = this->Drawing.Marks;
  double y = plot.Top + 0.5 * RowHeight;
  for (const ChartSeries& series : panel.Series)
  {
    const ChartMethod& method = *FindChartMethod(series.Method);
    std::vector<ChartPoint> points;
    int chosen = -1;
    bool infinite = false;
    for (std::size_t i = 0; i < series.X.size(); ++i)
    {
      infinite = infinite || std::isinf(series.X[i]);
      if (this->X.Has(series.X[i]))
      {
        chosen = series.Default == static_cast<int>(i) ? static_cast<int>(points.size()) : chosen;
        points.push_back({ plot.Left + this->X.Share(series.X[i]) * (plot.Right - plot.Left), y });
      }
    }
    const bool bars = this->Wanted.Kind == Chart::Bars;
    for (const ChartPoint& point : points)
    {
      if (bars)
      {
        ChartMark bar;
        bar.Kind = ChartMark::Area;
        bar.Points = { { plot.Left, y - 8. }, { point.X, y - 8. }, { point.X, y + 8. },
          { plot.Left, y + 8. } };
        bar.Color = HexOf(method.Color);
        bar.Method = method.Name;
        marks.push_back(bar);
      }
    }
    if (!bars && series.Line && points.size() > 1)
    {
      ChartMark line = Line(points, HexOf(method.Color), 1.8);
      line.Method = method.Name;
      line.Dash = method.Dash;
      marks.push_back(line);
    }
    for (std::size_t i = 0; i < points.size() && !bars; ++i)
    {
      marks.push_back(MarkerMark(method, points[i]));
    }
    if (chosen >= 0)
    {
      marks.push_back(Ring(points[static_cast<std::size_t>(chosen)]));
    }
    if (infinite)
    {
      marks.push_back(
        Words("infinite", plot.Right - 3., y, TickSize, ChartMark::End, DarkHexOf(method.Color)));
    }
    if (first)
    {
      ChartMark name = Words(
        NameOf(series), plot.Left - 9., y, LabelSize, ChartMark::End, DarkHexOf(method.Color));
      name.Method = method.Name;
      marks.push_back(name);
    }
    y += RowHeight;
  }
}

//------------------------------------------------------------------------------
void Layout::DrawAxisTitles(const ChartBox& all)
{
  auto& marks = this->Drawing.Marks;
  marks.push_back(Words(this->Wanted.X.Title, 0.5 * (all.Left + all.Right),
    all.Bottom + PanelFoot + 0.5 * AxisSize + 2., AxisSize, ChartMark::Middle));
  if (!this->Wanted.Y.Title.empty())
  {
    ChartMark title = Words(this->Wanted.Y.Title, Edge + 0.5 * AxisSize,
      0.5 * (all.Top + all.Bottom), AxisSize, ChartMark::Middle);
    title.Upright = true;
    marks.push_back(title);
  }
}

//------------------------------------------------------------------------------
ChartDrawing Layout::Draw()
{
  this->Drawing.Title = this->Wanted.Title;
  this->Drawing.Width = ChartWidth;
  this->DrawHead();
  ChartBox all = this->PlotOf(0);
  for (std::size_t i = 0; i < this->Wanted.Panels.size(); ++i)
  {
    const ChartBox plot = this->PlotOf(i);
    all.Right = std::max(all.Right, plot.Right);
    all.Bottom = std::max(all.Bottom, plot.Bottom);
    this->DrawFrame(i, plot);
    if (this->IsRows())
    {
      this->DrawRows(this->Wanted.Panels[i], plot, i == 0);
    }
    else
    {
      this->DrawCurves(this->Wanted.Panels[i], plot);
    }
  }
  this->DrawAxisTitles(all);
  this->Drawing.Height = all.Bottom + PanelFoot + AxisSize + 4. + Edge;
  return this->Drawing;
}
}

//------------------------------------------------------------------------------
ChartDrawing DrawChart(const Chart& chart)
{
  return Layout(chart).Draw();
}
}
