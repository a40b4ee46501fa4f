// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartSvg.h"

#include <cstdio>
#include <sstream>

namespace relievoBench
{
namespace
{
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

const char* DashOf(ChartDash dash)
{
  switch (dash)
  {
    case ChartDash::Dashed:
      return " stroke-dasharray=\"7 4\"";
    case ChartDash::Dotted:
      return " stroke-dasharray=\"2 3\"";
    case ChartDash::DashDotted:
      return " stroke-dasharray=\"8 3 2 3\"";
    case ChartDash::Solid:
      break;
  }
  return "";
}

std::string PathOf(const ChartMark& mark)
{
  std::string path;
  for (const ChartPoint& point : mark.Points)
  {
    path += (path.empty() ? "M" : "L") + Fixed(point.X) + ' ' + Fixed(point.Y);
  }
  return path;
}

// Half way up capitals and digits; SVG places text by its baseline.
constexpr double HalfHeight = 0.35;

void Write(std::ostream& out, const ChartMark& mark)
{
  const ChartPoint at = mark.Points.front();
  switch (mark.Kind)
  {
    case ChartMark::Line:
      out << "<path fill=\"none\" stroke=\"" << mark.Color << "\" stroke-width=\""
          << Fixed(mark.Width) << "\"" << DashOf(mark.Dash) << " d=\"" << PathOf(mark) << "\"/>\n";
      return;
    case ChartMark::Area:
      out << "<path fill=\"" << mark.Color << "\" d=\"" << PathOf(mark) << "z\"/>\n";
      return;
    case ChartMark::Disc:
      out << "<circle fill=\"" << mark.Color << "\" cx=\"" << Fixed(at.X) << "\" cy=\""
          << Fixed(at.Y) << "\" r=\"" << Fixed(mark.Radius) << "\"/>\n";
      return;
    case ChartMark::Ring:
      out << "<circle fill=\"none\" stroke=\"" << mark.Color << "\" stroke-width=\""
          << Fixed(mark.Width) << "\" cx=\"" << Fixed(at.X) << "\" cy=\"" << Fixed(at.Y)
          << "\" r=\"" << Fixed(mark.Radius) << "\"/>\n";
      return;
    case ChartMark::Words:
      break;
  }
  static const char* const anchors[] = { "start", "middle", "end" };
  out << "<text fill=\"" << mark.Color << "\" x=\"" << Fixed(at.X) << "\" y=\"" << Fixed(at.Y)
      << "\" dy=\"" << Fixed(HalfHeight * mark.Size) << "\" font-size=\"" << mark.Size
      << "\" text-anchor=\"" << anchors[mark.Anchor] << "\"";
  if (mark.Upright)
  {
    out << " transform=\"rotate(-90 " << Fixed(at.X) << ' ' << Fixed(at.Y) << ")\"";
  }
  out << ">" << Escaped(mark.Text) << "</text>\n";
}
}

//------------------------------------------------------------------------------
std::string SvgOf(const ChartDrawing& drawing)
{
  std::ostringstream out;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << drawing.Width << "\" height=\""
      << drawing.Height << "\" viewBox=\"0 0 " << drawing.Width << ' ' << drawing.Height
      << "\" font-family=\"Helvetica, Arial, sans-serif\">\n<title>" << Escaped(drawing.Title)
      << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  for (const ChartMark& mark : drawing.Marks)
  {
    Write(out, mark);
  }
  out << "</svg>\n";
  return out.str();
}
}
