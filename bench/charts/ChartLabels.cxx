// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartLabels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace relievoBench
{
namespace
{
constexpr double Gap = 9.;        // between the end of a curve and its name
constexpr double MarginGap = 16.; // the same to the margin, where lines may have to slope
constexpr double MarkerRoom = 6.; // half a marker
constexpr double CoversMarker = 60.;
constexpr double CoversLine = 25.;

ChartBox LabelBox(double left, double middle, double width)
{
  return { left, middle - 0.5 * LabelHeight, left + width, middle + 0.5 * LabelHeight };
}

bool Meets(const ChartBox& box, const std::vector<ChartPoint>& leader)
{
  return leader.size() == 2 && box.Meets(leader[0], leader[1]);
}

// What the name would cover, and how far it is from its point.
double CostOf(const ChartBox& box, const ChartPoint& end, const std::vector<LabelledCurve>& curves)
{
  double cost = std::hypot(std::max({ box.Left - end.X, end.X - box.Right, 0. }),
    std::max({ box.Top - end.Y, end.Y - box.Bottom, 0. }));
  for (const LabelledCurve& curve : curves)
  {
    for (std::size_t i = 0; i < curve.Points.size(); ++i)
    {
      const ChartPoint& p = curve.Points[i];
      const double room = curve.Ring == static_cast<int>(i) ? RingRadius + 1. : MarkerRoom;
      const ChartBox marker = { p.X - room, p.Y - room, p.X + room, p.Y + room };
      cost += box.Meets(marker) ? CoversMarker : 0.;
      cost += curve.Line && i > 0 && box.Meets(curve.Points[i - 1], p) ? CoversLine : 0.;
    }
  }
  return cost;
}

// Beside, over and under a point, then farther and farther away.
std::vector<ChartBox> Candidates(const ChartPoint& end, double width)
{
  std::vector<ChartBox> boxes;
  for (double away = 0.; away <= 160.; away += 8.)
  {
    for (const double y : { end.Y - away, end.Y + away })
    {
      for (const double gap : { Gap, RingRadius + 4. })
      {
        boxes.push_back(LabelBox(end.X + gap, y, width));
        boxes.push_back(LabelBox(end.X - gap - width, y, width));
      }
      if (away >= 16.)
      {
        boxes.push_back(LabelBox(end.X - 0.5 * width, y, width));
      }
      if (away >= 8.)
      {
        boxes.push_back(LabelBox(end.X + 3. * Gap, y, width));
        boxes.push_back(LabelBox(end.X - 3. * Gap - width, y, width));
      }
    }
  }
  return boxes;
}

bool IsFree(const ChartBox& box, const ChartBox& room, const std::vector<PlacedLabel>& placed)
{
  return box.Left >= room.Left && box.Right <= room.Right && box.Top >= room.Top &&
    box.Bottom <= room.Bottom &&
    std::none_of(
      placed.begin(), placed.end(), [&box](const PlacedLabel& l) { return box.Meets(l.Box); });
}

// A line to the name where that stands apart from its point.
std::vector<ChartPoint> LeaderTo(const ChartBox& box, const ChartPoint& end)
{
  const double x = std::clamp(end.X, box.Left - 2., box.Right + 2.);
  const double y = end.X >= box.Left && end.X <= box.Right
    ? (end.Y < box.Top ? box.Top : box.Bottom)
    : 0.5 * (box.Top + box.Bottom);
  const double length = std::hypot(x - end.X, y - end.Y);
  if (length < MarkerRoom + 8.)
  {
    return {};
  }
  const double from = MarkerRoom / length;
  return { { end.X + from * (x - end.X), end.Y + from * (y - end.Y) }, { x, y } };
}
}

//------------------------------------------------------------------------------
bool EndsAtRight(const LabelledCurve& curve, const ChartBox& plot)
{
  return !curve.Points.empty() && curve.Points.back().X > plot.Right - 20.;
}

//------------------------------------------------------------------------------
std::vector<double> Spread(std::vector<double> wanted, double apart, double low, double high)
{
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&wanted](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
  // Less what must be apart, they need only not fall: neighbours that do are pooled to their mean.
  struct Pool
  {
    double Mean;
    double Count;
  };
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    pools.push_back({ wanted[order[i]] - apart * static_cast<double>(i), 1. });
    while (pools.size() > 1 && pools[pools.size() - 2].Mean > pools.back().Mean)
    {
      const Pool last = pools.back();
      pools.pop_back();
      Pool& pool = pools.back();
      pool.Mean = (pool.Mean * pool.Count + last.Mean * last.Count) / (pool.Count + last.Count);
      pool.Count += last.Count;
    }
  }
  const double top = high - apart * (static_cast<double>(order.size()) - 1.);
  std::size_t i = 0;
  for (const Pool& pool : pools)
  {
    for (double k = 0.; k < pool.Count; k += 1., ++i)
    {
      wanted[order[i]] = std::max(low, std::min(pool.Mean, top)) + apart * static_cast<double>(i);
    }
  }
  return wanted;
}

//------------------------------------------------------------------------------
std::vector<PlacedLabel> PlaceLabels(
  const std::vector<LabelledCurve>& curves, const ChartBox& plot, const ChartBox& room)
{
  std::vector<PlacedLabel> labels(curves.size());
  std::vector<double> wanted;
  for (const LabelledCurve& curve : curves)
  {
    if (EndsAtRight(curve, plot))
    {
      wanted.push_back(curve.Points.back().Y);
    }
  }
  const std::vector<double> middles =
    Spread(wanted, LabelHeight, room.Top + 0.5 * LabelHeight, room.Bottom - 0.5 * LabelHeight);
  std::size_t next = 0;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    if (EndsAtRight(curves[i], plot))
    {
      const ChartPoint& end = curves[i].Points.back();
      const double width = TextWidth(curves[i].Name, LabelSize);
      labels[i].Box = LabelBox(plot.Right + MarginGap, middles[next], width);
      const bool ringed = curves[i].Ring == static_cast<int>(curves[i].Points.size()) - 1;
      labels[i].Leader = { { end.X + (ringed ? RingRadius : MarkerRoom) + 1., end.Y },
        { plot.Right + MarginGap - 3., middles[next] } };
      ++next;
    }
  }
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    if (curves[i].Points.empty() || EndsAtRight(curves[i], plot))
    {
      continue;
    }
    const double width = TextWidth(curves[i].Name, LabelSize);
    double least = std::numeric_limits<double>::infinity();
    PlacedLabel best;
    // The beginning of a curve will do where its end is crowded.
    for (const bool atEnd : { true, false })
    {
      const ChartPoint& point = atEnd ? curves[i].Points.back() : curves[i].Points.front();
      for (const ChartBox& box : Candidates(point, width))
      {
        double cost = CostOf(box, point, curves) + (atEnd ? 0. : 15.);
        if (cost >= least || !IsFree(box, room, labels))
        {
          continue;
        }
        const std::vector<ChartPoint> leader = LeaderTo(box, point);
        for (const PlacedLabel& other : labels)
        {
          cost += Meets(box, other.Leader) || Meets(other.Box, leader) ? CoversMarker : 0.;
        }
        if (cost < least)
        {
          least = cost;
          best = { box, leader };
        }
      }
    }
    labels[i] = best;
  }
  return labels;
}
}
