// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartMarkers.h"

#include <initializer_list>

namespace relievoBench
{
//------------------------------------------------------------------------------
ChartMark MarkerMark(const ChartMethod& method, const ChartPoint& at)
{
  ChartMark mark;
  mark.Kind = ChartMark::Area;
  mark.Color = HexOf(method.Color);
  mark.Method = method.Name;
  const auto shape = [&mark, &at](std::initializer_list<ChartPoint> offsets) {
    for (const ChartPoint& offset : offsets)
    {
      mark.Points.push_back({ at.X + offset.X, at.Y + offset.Y });
    }
  };
  constexpr double t = 1.2; // half a bar of a cross
  constexpr double a = 5.5;
  constexpr double d = 0.7071 * t;
  constexpr double e = 0.7071 * a;
  switch (method.Marker)
  {
    case ChartMarker::Circle:
      mark.Kind = ChartMark::Disc;
      mark.Radius = 4.5;
      mark.Points = { at };
      break;
    case ChartMarker::Square:
      shape({ { -4.2, -4.2 }, { 4.2, -4.2 }, { 4.2, 4.2 }, { -4.2, 4.2 } });
      break;
    case ChartMarker::Diamond:
      shape({ { 0., -5.8 }, { 5.8, 0. }, { 0., 5.8 }, { -5.8, 0. } });
      break;
    case ChartMarker::Up:
      shape({ { 0., -5.6 }, { 5.2, 4. }, { -5.2, 4. } });
      break;
    case ChartMarker::Down:
      shape({ { 0., 5.6 }, { 5.2, -4. }, { -5.2, -4. } });
      break;
    case ChartMarker::Plus:
      shape({ { -t, -a }, { t, -a }, { t, -t }, { a, -t }, { a, t }, { t, t }, { t, a }, { -t, a },
        { -t, t }, { -a, t }, { -a, -t }, { -t, -t } });
      break;
    case ChartMarker::Cross:
      shape({ { -e - d, -e + d }, { -e + d, -e - d }, { 0., -2. * d }, { e - d, -e - d },
        { e + d, -e + d }, { 2. * d, 0. }, { e + d, e - d }, { e - d, e + d }, { 0., 2. * d },
        { -e + d, e + d }, { -e - d, e - d }, { -2. * d, 0. } });
      break;
  }
  return mark;
}
}
