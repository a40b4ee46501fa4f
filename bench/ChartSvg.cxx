// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartSvg.h"

#include "ChartScale.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace relievoBench
{
namespace
{
constexpr double Left = 75.;
constexpr double Top = 45.;
constexpr double Bottom = ChartHeight - 60.;
constexpr double LegendLine = 20.;

std::string Fixed(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", value);
  return text;
}

std::string Escaped(const std::string& text)
{
  std::string safe;
  for (char c : text)
  {
    safe += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return safe;
}

std::string ColorOf(const ChartStyle& style)
{
  char text[16];
  std::snprintf(
    text, sizeof(text), "#%02x%02x%02x", style.Color[0], style.Color[1], style.Color[2]);
  return text;
}

void Line(std::ostream& out, double x1, double y1, double x2, double y2, const char* color)
{
  out << "<path stroke=\"" << color << "\" d=\"M" << Fixed(x1) << ' ' << Fixed(y1) << 'L'
      << Fixed(x2) << ' ' << Fixed(y2) << "\"/>\n";
}

void Text(std::ostream& out, double x, double y, int size, const char* anchor,
  const std::string& text, const char* more = "")
{
  out << "<text x=\"" << Fixed(x) << "\" y=\"" << Fixed(y) << "\" font-size=\"" << size
      << "\" text-anchor=\"" << anchor << "\"" << more << ">" << Escaped(text) << "</text>\n";
}

void Marker(std::ostream& out, double x, double y, const ChartStyle& style)
{
  const double r = 4.5;
  const std::string color = ColorOf(style);
  const auto at = [x, y](double dx, double dy) { return Fixed(x + dx) + ' ' + Fixed(y + dy); };
  switch (style.Marker)
  {
    case ChartStyle::Circle:
      out << "<circle fill=\"" << color << "\" cx=\"" << Fixed(x) << "\" cy=\"" << Fixed(y)
          << "\" r=\"" << r << "\"/>\n";
      return;
    case ChartStyle::Square:
      out << "<rect fill=\"" << color << "\" x=\"" << Fixed(x - r) << "\" y=\"" << Fixed(y - r)
          << "\" width=\"" << 2. * r << "\" height=\"" << 2. * r << "\"/>\n";
      return;
    case ChartStyle::Diamond:
      out << "<path fill=\"" << color << "\" d=\"M" << at(0., -1.3 * r) << 'L' << at(1.3 * r, 0.)
          << 'L' << at(0., 1.3 * r) << 'L' << at(-1.3 * r, 0.) << "z\"/>\n";
      return;
    case ChartStyle::Plus:
      out << "<path stroke=\"" << color << "\" stroke-width=\"1.5\" d=\"M" << at(0., -1.3 * r)
          << 'L' << at(0., 1.3 * r) << 'M' << at(-1.3 * r, 0.) << 'L' << at(1.3 * r, 0.)
          << "\"/>\n";
      return;
    case ChartStyle::Cross:
      out << "<path stroke=\"" << color << "\" stroke-width=\"1.5\" d=\"M" << at(-r, -r) << 'L'
          << at(r, r) << 'M' << at(-r, r) << 'L' << at(r, -r) << "\"/>\n";
      return;
  }
}

void Polyline(
  std::ostream& out, const std::vector<std::pair<double, double>>& points, const ChartStyle& style)
{
  out << "<path fill=\"none\" stroke=\"" << ColorOf(style) << "\" stroke-width=\"1.5\""
      << (style.Dashed ? " stroke-dasharray=\"6 5\"" : "") << " d=\"";
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    out << (i ? 'L' : 'M') << Fixed(points[i].first) << ' ' << Fixed(points[i].second);
  }
  out << "\"/>\n";
}

void Bar(std::ostream& out, double left, double right, double top, const ChartStyle& style)
{
  out << "<rect fill=\"" << ColorOf(style) << "\" x=\"" << Fixed(left) << "\" y=\"" << Fixed(top)
      << "\" width=\"" << Fixed(right - left) << "\" height=\"" << Fixed(Bottom - top) << "\"/>\n";
}

// Right end of the data; the legend stands beyond it. Letters are about 7 wide at size 13.
double RightEnd(const Chart& chart)
{
  std::size_t longest = 0;
  for (const ChartSeries& series : chart.Series)
  {
    longest = std::max(longest, series.Name.size());
  }
  return ChartWidth - 60. - 7. * static_cast<double>(longest);
}
}

//------------------------------------------------------------------------------
std::string SvgOf(const Chart& chart)
{
  const ChartScale x = FitX(chart);
  const ChartScale y = FitY(chart);
  const double right = RightEnd(chart);
  const auto pixelX = [&](double place) {
    return Left + (place - x.Low) / (x.High - x.Low) * (right - Left);
  };
  const auto pixelY = [&](double place) {
    return Bottom - (place - y.Low) / (y.High - y.Low) * (Bottom - Top);
  };
  std::ostringstream out;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << ChartWidth << "\" height=\""
      << ChartHeight << "\" viewBox=\"0 0 " << ChartWidth << ' ' << ChartHeight
      << "\" font-family=\"Helvetica, Arial, sans-serif\">\n<title>" << Escaped(chart.Title)
      << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const auto& tick : x.Ticks)
  {
    Line(out, pixelX(tick.first), Top, pixelX(tick.first), Bottom, "#e1e1e1");
    Text(out, pixelX(tick.first), Bottom + 20., 13, "middle", tick.second);
  }
  for (const auto& tick : y.Ticks)
  {
    Line(out, Left, pixelY(tick.first), right, pixelY(tick.first), "#e1e1e1");
    Text(out, Left - 8., pixelY(tick.first) + 4.5, 13, "end", tick.second);
  }
  Line(out, Left, Bottom, right, Bottom, "#000000");
  Line(out, Left, Top, Left, Bottom, "#000000");
  const double middleX = 0.5 * (Left + right);
  const double middleY = 0.5 * (Top + Bottom);
  Text(out, middleX, 26., 17, "middle", chart.Title);
  Text(out, middleX, ChartHeight - 16., 15, "middle", chart.X.Title);
  const std::string turn = " transform=\"rotate(-90 20 " + Fixed(middleY) + ")\"";
  Text(out, 20., middleY, 15, "middle", chart.Y.Title, turn.c_str());

  for (std::size_t i = 0; i < chart.Series.size(); ++i)
  {
    const ChartStyle style = StyleOf(static_cast<int>(i));
    std::vector<std::pair<double, double>> points = Places(chart.Series[i], x, y);
    for (auto& point : points)
    {
      point = { pixelX(point.first), pixelY(point.second) };
    }
    if (chart.Series[i].Bars)
    {
      const double width =
        BarShare / static_cast<double>(chart.Series.size()) * (pixelX(1.) - pixelX(0.));
      const double offset = static_cast<double>(i) - 0.5 * static_cast<double>(chart.Series.size());
      for (const auto& point : points)
      {
        const double left = point.first + offset * width;
        Bar(out, left, left + width, point.second, style);
      }
    }
    const double legendY = Top + 8. + LegendLine * static_cast<double>(i);
    if (chart.Series[i].Line && !chart.Series[i].Bars && points.size() > 1)
    {
      Polyline(out, points, style);
      Polyline(out, { { right + 12., legendY }, { right + 38., legendY } }, style);
    }
    for (std::size_t k = 0; k < points.size() && !chart.Series[i].Bars; ++k)
    {
      Marker(out, points[k].first, points[k].second, style);
    }
    Marker(out, right + 25., legendY, style);
    Text(out, right + 45., legendY + 4.5, 13, "start", chart.Series[i].Name);
  }
  out << "</svg>\n";
  return out.str();
}
}
