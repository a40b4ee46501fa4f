// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartDrawing.h"

#include <algorithm>
#include <cmath>

namespace relievoBench
{
//------------------------------------------------------------------------------
bool ChartBox::Meets(const ChartBox& other) const
{
  return this->Left < other.Right && other.Left < this->Right && this->Top < other.Bottom &&
    other.Top < this->Bottom;
}

//------------------------------------------------------------------------------
bool ChartBox::Meets(const ChartPoint& a, const ChartPoint& b) const
{
  // The share of the segment that is within the box (Liang and Barsky).
  double from = 0.;
  double to = 1.;
  const double starts[2] = { a.X, a.Y };
  const double runs[2] = { b.X - a.X, b.Y - a.Y };
  const double lows[2] = { this->Left, this->Top };
  const double highs[2] = { this->Right, this->Bottom };
  for (int axis = 0; axis < 2; ++axis)
  {
    if (runs[axis] == 0.)
    {
      if (starts[axis] < lows[axis] || starts[axis] > highs[axis])
      {
        return false;
      }
      continue;
    }
    const double one = (lows[axis] - starts[axis]) / runs[axis];
    const double other = (highs[axis] - starts[axis]) / runs[axis];
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return from <= to;
}

//------------------------------------------------------------------------------
double TextWidth(const std::string& text, double size)
{
  // Hundredths of the size from ' ' to '~': the wider of Helvetica and what VTK draws.
  static const unsigned char widths[] = { 28, 30, 36, 56, 56, 89, 76, 20, 37, 37, 43, 61, 28, 34,
    28, 44, 56, 56, 56, 56, 56, 56, 56, 56, 56, 56, 28, 28, 61, 61, 61, 59, 102, 74, 67, 81, 74, 67,
    62, 87, 73, 28, 50, 67, 56, 92, 74, 87, 67, 87, 73, 67, 62, 73, 70, 96, 67, 67, 62, 35, 61, 35,
    61, 56, 38, 68, 68, 65, 69, 65, 31, 67, 61, 23, 23, 50, 23, 94, 61, 66, 68, 68, 34, 50, 34, 61,
    55, 83, 50, 54, 50, 35, 67, 35, 61 };
  double width = 0.;
  for (const char c : text)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' && byte <= '~')
    {
      width += widths[byte - ' '];
    }
    else if (byte >= 0xc0) // the first byte of a character beyond ASCII
    {
      width += 100.;
    }
  }
  return 0.01 * size * width;
}

//------------------------------------------------------------------------------
ChartBox BoxOf(const ChartMark& text)
{
  const double width = TextWidth(text.Text, text.Size);
  const double left = text.Anchor == ChartMark::Start ? 0.
    : text.Anchor == ChartMark::Middle                ? -0.5 * width
                                                      : -width;
  const double up = 0.5 * text.Size;
  const ChartPoint at = text.Points.front();
  if (text.Upright)
  {
    return { at.X - up, at.Y - left - width, at.X + up, at.Y - left };
  }
  return { at.X + left, at.Y - up, at.X + left + width, at.Y + up };
}
}
