// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoColorBar.h"

#include "vtkRelievoAnnotation.h"
#include "vtkRelievoOverlayPen.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace
{
constexpr double LinesOfText = 45.0;  // lines per shorter side of the picture
constexpr double SmallestText = 11.0; // pixels; lengths below are in units of the text's size
constexpr double Margin = 0.9;        // to the picture's edges
constexpr double Thickness = 1.2;     // of the bar
constexpr double Line = 0.08;
constexpr double Halo = 0.06;
constexpr double Tick = 0.4;
constexpr double MinorTick = 0.2;
constexpr double Gap = 0.35;         // between tick and text, bar and box
constexpr double TitleGap = 0.8;     // between bar and title
constexpr double BoxGap = 0.8;       // between bar and boxes
constexpr double Rows = 2.2;         // between values of a vertical bar, at least
constexpr double Columns = 1.5;      // free between values of a horizontal bar, at least
constexpr double Widest = 0.45;      // share of the picture's width that a title takes at most
constexpr double LongTitle = 2.0;    // of the width of bar and values
constexpr double Dark = 0.08;        // grey of the backdrop
constexpr double Opacity = 0.75;     // of the backdrop
constexpr int MostWrittenSteps = 13; // where colours change
constexpr int MostTicks = 11;

using Color = vtkRelievoOverlayPen::Color;
using Ticks = vtkRelievoAnnotation::Ticks;

// A box beside the bar, for values outside the map's range.
struct Box
{
  double From; // along the bar
  Color Shown;
  std::string Text;
};

// In pixels. Along the bar is upwards, or to the right if it is flat; positions along and across it
// are from the left bottom corner of its colours.
struct Layout
{
  bool IsFlat;
  double Size; // of the font
  double Thick, Line, Gap, Tick, MinorTick, Halo;
  double BoxStep; // from one box to the next
  double Length;  // of the bar
  Ticks Values;
  std::vector<Box> Boxes;
  std::string Title;
  double TitleSize;
  std::array<double, 2> At, Extent; // of all: the left bottom corner, width and height
  std::array<double, 2> Bar;        // the left bottom corner of the colours
  std::array<double, 2> TitleAt;
};
}

//------------------------------------------------------------------------------
struct vtkRelievoColorBar::Internals
{
  vtkSmartPointer<vtkScalarsToColors> Map;
  std::string Title, First, Last;
  vtkRelievoOverlayPen& Pen;
  const std::string& Unit;

  Internals(vtkRelievoOverlayPen& pen, const std::string& unit)
    : Pen(pen)
    , Unit(unit)
  {
  }

  double GetValueAt(double share) const
  {
    const double* range = this->Map->GetRange();
    return this->Map->UsingLogScale() ? range[0] * std::pow(range[1] / range[0], share)
                                      : range[0] + share * (range[1] - range[0]);
  }

  double GetShareOf(double value) const
  {
    const double* range = this->Map->GetRange();
    const double share = this->Map->UsingLogScale()
      ? std::log(value / range[0]) / std::log(range[1] / range[0])
      : (value - range[0]) / (range[1] - range[0]);
    return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
  }

  Color GetColor(double value) const
  {
    Color color;
    this->Map->GetColor(value, color.data());
    return color;
  }

  double GetWidest(const std::vector<std::string>& texts, double size)
  {
    double wide = 0.0;
    for (const std::string& text : texts)
    {
      wide = std::max(wide, this->Pen.Measure(text, size)[0]);
    }
    return wide;
  }

  // Values where the colours of a map in steps change.
  Ticks MakeStepTicks(int steps) const
  {
    Ticks ticks;
    for (int i = 0; i <= steps; ++i)
    {
      ticks.Values.push_back(this->GetValueAt(static_cast<double>(i) / steps));
    }
    if (this->Map->UsingLogScale())
    {
      for (const double value : ticks.Values)
      {
        ticks.Texts.push_back(vtkRelievoAnnotation::WriteValue(value));
      }
    }
    else
    {
      ticks.Texts = vtkRelievoAnnotation::WriteValues(ticks.Values);
    }
    return ticks;
  }

  // The largest number of ticks that fits.
  Ticks MakeTicks(double length, double size, bool flat, int steps)
  {
    if (!this->First.empty() || !this->Last.empty())
    {
      const double* range = this->Map->GetRange();
      return { { range[0], range[1] }, { this->First, this->Last }, {}, "" };
    }
    const auto fits = [&](const Ticks& ticks) {
      const double room = flat ? this->GetWidest(ticks.Texts, size) + Columns * size : Rows * size;
      return ticks.Values.size() < 2 ||
        room * static_cast<double>(ticks.Values.size() - 1) <= length;
    };
    if (steps > 0 && steps < MostWrittenSteps)
    {
      Ticks ticks = this->MakeStepTicks(steps);
      if (fits(ticks))
      {
        return ticks;
      }
    }
    for (int most = MostTicks;; --most)
    {
      Ticks ticks = vtkRelievoAnnotation::MakeTicks(
        this->Map->GetRange(), this->Map->UsingLogScale() != 0, most);
      if (most == 2 || fits(ticks))
      {
        return ticks;
      }
    }
  }

  std::string WriteTitle(const std::string& factor) const
  {
    const std::string unit =
      factor + (factor.empty() || this->Unit.empty() ? "" : " ") + this->Unit;
    return this->Title +
      (unit.empty() ? "" : (this->Title.empty() ? "" : " ") + ("(" + unit + ")"));
  }

  // Boxes lie beyond the bar's ends: values above and below its range, then NaN.
  std::vector<Box> MakeBoxes(vtkRelievoColorBar* bar, const Layout& layout) const
  {
    std::vector<Box> boxes;
    const double* range = this->Map->GetRange();
    const double span = range[1] - range[0];
    const bool log = this->Map->UsingLogScale() != 0;
    const double step = layout.BoxStep;
    // Beside a flat bar there is no room for the numbers.
    const auto name = [&](const char* sign, double value) {
      return sign + (layout.IsFlat ? "" : " " + vtkRelievoAnnotation::WriteValue(value));
    };
    if (bar->AboveBox)
    {
      boxes.push_back({ layout.Length + step - layout.Thick,
        this->GetColor(log ? 2.0 * range[1] : range[1] + span), name(">", range[1]) });
    }
    if (bar->BelowBox)
    {
      boxes.push_back(
        { -step, this->GetColor(log ? range[0] / 2.0 : range[0] - span), name("<", range[0]) });
    }
    if (bar->NanBox)
    {
      boxes.push_back({ bar->BelowBox ? -2.0 * step : -step,
        this->GetColor(std::numeric_limits<double>::quiet_NaN()), "NaN" });
    }
    return boxes;
  }

  // Breaks a title at spaces, and then writes it smaller, to a width.
  void SetTitle(Layout& layout, const std::string& title, double widest)
  {
    layout.Title.clear();
    std::string line;
    std::istringstream words(title);
    for (std::string word; words >> word;)
    {
      const std::string longer = line.empty() ? word : line + ' ' + word;
      const bool fits = line.empty() || this->Pen.Measure(longer, layout.Size)[0] <= widest;
      layout.Title += fits ? "" : line + '\n';
      line = fits ? longer : word;
    }
    layout.Title += line;
    const double wide = this->Pen.Measure(layout.Title, layout.Size)[0];
    layout.TitleSize =
      wide > widest ? std::max(1.0, std::floor(layout.Size * widest / wide)) : layout.Size;
  }

  Layout LayOut(vtkRelievoColorBar* bar, vtkRenderer* renderer)
  {
    const std::array<double, 2> picture = { static_cast<double>(renderer->GetSize()[0]),
      static_cast<double>(renderer->GetSize()[1]) };
    Layout layout;
    layout.IsFlat = bar->Place == PLACE_BOTTOM || bar->Place == PLACE_TOP;
    layout.Size = bar->TextSize > 0.0
      ? bar->TextSize
      : std::max(SmallestText, std::floor(std::min(picture[0], picture[1]) / LinesOfText));
    const auto scaled = [&](double length) {
      return std::max(1.0, std::round(length * layout.Size));
    };
    const double margin = scaled(Margin);
    layout.Thick = scaled(Thickness);
    layout.Line = scaled(::Line);
    layout.Gap = scaled(::Gap);
    layout.Tick = scaled(::Tick);
    layout.MinorTick = scaled(::MinorTick);
    layout.Halo = scaled(::Halo);

    const double row = this->Pen.Measure("0", layout.Size)[1];
    const double side = picture[layout.IsFlat ? 0 : 1];
    const double widest = (layout.IsFlat ? 1.0 : Widest) * picture[0] - 2.0 * margin;
    const auto fit = [&] {
      // Texts beside boxes keep clear of each other and of the last values.
      const double wide = layout.IsFlat ? this->GetWidest(layout.Values.Texts, layout.Size) : 0.0;
      layout.BoxStep = layout.Thick + std::max(scaled(BoxGap), scaled(0.5) + 0.5 * wide);
      this->SetTitle(layout, this->WriteTitle(layout.Values.Factor), widest);
    };
    fit();
    const double boxes =
      (bar->AboveBox ? 1.0 : 0.0) + (bar->BelowBox ? 1.0 : 0.0) + (bar->NanBox ? 1.0 : 0.0);
    const double head = this->Pen.Measure(layout.Title, layout.TitleSize)[1] + scaled(TitleGap);
    const double room =
      side - 2.0 * margin - boxes * (layout.Thick + scaled(BoxGap)) - (layout.IsFlat ? 0.0 : head);
    layout.Length = std::max(2.0, std::round(std::min(bar->Share * side, room)));
    layout.Values = this->MakeTicks(layout.Length, layout.Size, layout.IsFlat, bar->Steps);
    fit();
    layout.Boxes = this->MakeBoxes(bar, layout);
    const double above = bar->AboveBox ? layout.BoxStep : 0.0;
    const double below = boxes * layout.BoxStep - above;
    const double titled = this->Pen.Measure(layout.Title, layout.TitleSize)[0];
    double wide = this->GetWidest(layout.Values.Texts, layout.Size);
    for (const Box& box : layout.Boxes)
    {
      wide = std::max(wide, this->Pen.Measure(box.Text, layout.Size)[0]);
    }
    const double across = layout.Thick + layout.Tick + layout.Gap + wide;
    const double along = below + layout.Length + above;
    layout.Extent = layout.IsFlat
      ? std::array<double, 2>{ std::max(along, titled) + wide, // values are centred at their ticks
          row + layout.Gap + layout.Tick + layout.Thick + head }
      : std::array<double, 2>{ std::max(across, titled), along + head };
    for (std::size_t i = 0; i < 2; ++i)
    {
      const double last = picture[i] - margin - layout.Extent[i];
      const bool isAlong = layout.IsFlat == (i == 0);
      const bool isFirst = bar->Place == PLACE_LEFT || bar->Place == PLACE_BOTTOM;
      layout.At[i] =
        std::round(isAlong ? std::clamp(bar->Middle * picture[i] - 0.5 * layout.Extent[i],
                               std::min(margin, last), std::max(margin, last))
            : isFirst      ? margin
                           : last);
    }
    // Beneath a long title, bar and values stay at the picture's edge.
    const bool isLong = layout.Extent[0] > LongTitle * across;
    const double shift = bar->Place == PLACE_RIGHT && isLong ? layout.Extent[0] - across : 0.0;
    layout.Bar = layout.IsFlat
      ? std::array<double, 2>{ layout.At[0] + below + 0.5 * wide,
          layout.At[1] + row + layout.Gap + layout.Tick }
      : std::array<double, 2>{ layout.At[0] + shift, layout.At[1] + below };
    layout.TitleAt = { layout.IsFlat ? layout.Bar[0] : layout.At[0],
      layout.At[1] + layout.Extent[1] - head + scaled(TitleGap) };
    return layout;
  }

  void AddAll(const Layout& layout, double ink, bool hasBackdrop)
  {
    const Color inkColor = { ink, ink, ink };
    const Color edge = { 1.0 - ink, 1.0 - ink, 1.0 - ink };
    const double halo = hasBackdrop ? 0.0 : layout.Halo;
    if (hasBackdrop)
    {
      const double pad = 2.0 * layout.Gap;
      this->Pen.AddRectangle(
        { layout.At[0] - pad, layout.At[1] - pad, layout.At[0] + layout.Extent[0] + pad,
          layout.At[1] + layout.Extent[1] + pad },
        { Dark, Dark, Dark }, Opacity);
    }
    const std::array<double, 2>& bar = layout.Bar;
    const auto add = [&](double from, double low, double to, double high, const Color& color) {
      this->Pen.AddRectangle(layout.IsFlat
          ? std::array<double, 4>{ bar[0] + from, bar[1] + low, bar[0] + to, bar[1] + high }
          : std::array<double, 4>{ bar[0] + low, bar[1] + from, bar[0] + high, bar[1] + to },
        color);
    };
    const auto write = [&](double along, const std::string& text) {
      const std::array<double, 2> extent = this->Pen.Measure(text, layout.Size);
      const double outside = layout.Tick + layout.Gap;
      this->Pen.AddText(layout.IsFlat
          ? std::array<double, 2>{ bar[0] + along - 0.5 * extent[0], bar[1] - outside - extent[1] }
          : std::array<double, 2>{ bar[0] + layout.Thick + outside,
              bar[1] + along - 0.5 * extent[1] },
        text, layout.Size, inkColor, edge, halo);
    };
    const double line = layout.Line;
    add(-line, -line, layout.Length + line, layout.Thick + line, inkColor);
    for (int i = 0; i < static_cast<int>(layout.Length); ++i)
    {
      add(
        i, 0.0, i + 1.0, layout.Thick, this->GetColor(this->GetValueAt((i + 0.5) / layout.Length)));
    }
    const auto mark = [&](double value, double reach) {
      const double along = std::round(this->GetShareOf(value) * layout.Length - 0.5 * line);
      const double from = layout.IsFlat ? -reach : layout.Thick;
      add(along, from, along + line, from + reach, inkColor);
    };
    for (const double value : layout.Values.Minor)
    {
      mark(value, layout.MinorTick);
    }
    for (std::size_t i = 0; i < layout.Values.Values.size(); ++i)
    {
      const double value = layout.Values.Values[i];
      mark(value, layout.Tick);
      write(this->GetShareOf(value) * layout.Length, layout.Values.Texts[i]);
    }
    for (const Box& box : layout.Boxes)
    {
      add(box.From - line, -line, box.From + layout.Thick + line, layout.Thick + line, inkColor);
      add(box.From, 0.0, box.From + layout.Thick, layout.Thick, box.Shown);
      write(box.From + 0.5 * layout.Thick, box.Text);
    }
    if (!layout.Title.empty())
    {
      this->Pen.AddText(layout.TitleAt, layout.Title, layout.TitleSize, inkColor, edge, halo);
    }
  }
};

vtkStandardNewMacro(vtkRelievoColorBar);

//------------------------------------------------------------------------------
vtkRelievoColorBar::vtkRelievoColorBar()
  : Internal(new Internals(*this->Pen, this->Unit))
{
}

//------------------------------------------------------------------------------
vtkRelievoColorBar::~vtkRelievoColorBar() = default;

//------------------------------------------------------------------------------
void vtkRelievoColorBar::SetLookupTable(vtkScalarsToColors* map)
{
  if (this->Internal->Map != map)
  {
    this->Internal->Map = map;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkScalarsToColors* vtkRelievoColorBar::GetLookupTable()
{
  return this->Internal->Map;
}

//------------------------------------------------------------------------------
void vtkRelievoColorBar::SetTitle(RELIEVO_TEXT title)
{
  if (this->Internal->Title != title)
  {
    this->Internal->Title = title;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoColorBar::GetTitle()
{
  return this->Internal->Title;
}

//------------------------------------------------------------------------------
void vtkRelievoColorBar::SetEnds(RELIEVO_TEXT first, RELIEVO_TEXT last)
{
  if (this->Internal->First != first || this->Internal->Last != last)
  {
    this->Internal->First = first;
    this->Internal->Last = last;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoColorBar::SetFallbackFont(RELIEVO_TEXT file)
{
  vtkRelievoAnnotation::SetFallbackFont(file);
}

//------------------------------------------------------------------------------
std::string vtkRelievoColorBar::GetTexts(vtkRenderer* renderer)
{
  Internals& own = *this->Internal;
  if (!renderer || !renderer->GetRenderWindow() || !own.Map)
  {
    return "";
  }
  own.Pen.Begin(renderer);
  const Layout layout = own.LayOut(this, renderer);
  std::string texts = layout.Title;
  for (const std::string& text : layout.Values.Texts)
  {
    texts += '\n' + text;
  }
  for (const Box& box : layout.Boxes)
  {
    texts += '\n' + box.Text;
  }
  return texts;
}

//------------------------------------------------------------------------------
int vtkRelievoColorBar::RenderOverlay(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  Internals& own = *this->Internal;
  if (!renderer || !own.Map || renderer->GetSize()[0] < 1 || renderer->GetSize()[1] < 1)
  {
    return 0;
  }
  own.Pen.Begin(viewport);
  const double ink = this->Backdrop ? 1.0 : this->GetShownInk(renderer);
  own.AddAll(own.LayOut(this, renderer), ink, this->Backdrop);
  own.Pen.Draw();
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoColorBar::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LookupTable: " << this->Internal->Map << "\n";
  os << indent << "Title: " << this->Internal->Title << "\n";
  os << indent << "Place: " << this->Place << "\n";
  os << indent << "Share: " << this->Share << "\n";
  os << indent << "Middle: " << this->Middle << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  os << indent << "BelowBox: " << this->BelowBox << "\n";
  os << indent << "AboveBox: " << this->AboveBox << "\n";
  os << indent << "NanBox: " << this->NanBox << "\n";
  os << indent << "Backdrop: " << this->Backdrop << "\n";
}
