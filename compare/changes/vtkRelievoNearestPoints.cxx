// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoNearestPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

namespace relievo::compare
{
namespace
{
template <std::size_t N>
using Tuple = std::array<double, N>;

constexpr std::size_t LeafSize = 8;
constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
constexpr double Infinity = std::numeric_limits<double>::infinity();

template <std::size_t N>
double GetSquare(const Tuple<N>& a, const Tuple<N>& b)
{
  double square = 0.0;
  for (std::size_t i = 0; i < N; ++i)
  {
    square += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return square;
}

// Places of files can be NaN, which has no order.
template <std::size_t N>
std::vector<Tuple<N>> MakeFinite(std::vector<Tuple<N>> points)
{
  for (Tuple<N>& point : points)
  {
    std::replace_if(
      point.begin(), point.end(), [](double each) { return !std::isfinite(each); }, 0.0);
  }
  return points;
}

// Points in a tree of boxes, from which they can be removed.
template <std::size_t N>
class Tree
{
public:
  struct Found
  {
    double Distance; // squared
    std::size_t Point;
  };

  explicit Tree(const std::vector<Tuple<N>>& points)
    : Points(points)
    , Order(points.size())
    , Leaf(points.size())
    , Removed(points.size(), false)
  {
    std::iota(this->Order.begin(), this->Order.end(), 0);
    this->Nodes.emplace_back(Node{ {}, {}, 0, points.size(), None, None, None });
    for (std::size_t i = 0; i < this->Nodes.size(); ++i) // Split adds children at the end
    {
      this->Split(i);
    }
  }

  bool Has(std::size_t point) const { return !this->Removed[point]; }

  // The nearest point that is left, except those of a list.
  Found Find(const Tuple<N>& place, const std::vector<std::size_t>& without) const;

  void Remove(std::size_t point);

private:
  struct Node
  {
    Tuple<N> Least, Most;   // corners of the box
    std::size_t Begin, End; // in Order
    std::size_t Parent;
    std::size_t Child; // the first of two; None: a leaf
    std::size_t First; // the first point that is left
  };

  void Split(std::size_t number);
  static double GetDistance(const Node& node, const Tuple<N>& place);

  const std::vector<Tuple<N>>& Points;
  std::vector<std::size_t> Order, Leaf; // points by leaf; the leaf of each point
  std::vector<bool> Removed;
  std::vector<Node> Nodes;
};

//------------------------------------------------------------------------------
template <std::size_t N>
void Tree<N>::Split(std::size_t number)
{
  Node node = this->Nodes[number];
  node.Least.fill(Infinity);
  node.Most.fill(-Infinity);
  for (std::size_t i = node.Begin; i < node.End; ++i)
  {
    const std::size_t point = this->Order[i];
    this->Leaf[point] = number;
    node.First = std::min(node.First, point);
    for (std::size_t c = 0; c < N; ++c)
    {
      node.Least[c] = std::min(node.Least[c], this->Points[point][c]);
      node.Most[c] = std::max(node.Most[c], this->Points[point][c]);
    }
  }
  if (node.End - node.Begin > LeafSize)
  {
    std::size_t axis = 0;
    for (std::size_t c = 1; c < N; ++c)
    {
      axis = node.Most[c] - node.Least[c] > node.Most[axis] - node.Least[axis] ? c : axis;
    }
    const std::size_t middle = (node.Begin + node.End) / 2;
    const auto at = [this](std::size_t i) {
      return this->Order.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(node.Begin), at(middle), at(node.End),
      [&](std::size_t a, std::size_t b) { return this->Points[a][axis] < this->Points[b][axis]; });
    node.Child = this->Nodes.size();
    this->Nodes.emplace_back(Node{ {}, {}, node.Begin, middle, number, None, None });
    this->Nodes.emplace_back(Node{ {}, {}, middle, node.End, number, None, None });
  }
  this->Nodes[number] = node;
}

//------------------------------------------------------------------------------
template <std::size_t N>
double Tree<N>::GetDistance(const Node& node, const Tuple<N>& place)
{
  Tuple<N> inside{};
  for (std::size_t c = 0; c < N; ++c)
  {
    inside[c] = std::max(node.Least[c], std::min(place[c], node.Most[c]));
  }
  return GetSquare(inside, place);
}

//------------------------------------------------------------------------------
template <std::size_t N>
typename Tree<N>::Found Tree<N>::Find(
  const Tuple<N>& place, const std::vector<std::size_t>& without) const
{
  Found found = { Infinity, None };
  std::vector<std::size_t> open = { 0 };
  while (!open.empty())
  {
    const Node& node = this->Nodes[open.back()];
    open.pop_back();
    const double distance = GetDistance(node, place);
    const auto best = std::tie(found.Distance, found.Point);
    if (node.First == None || std::tie(distance, node.First) > best)
    {
      continue;
    }
    if (node.Child != None)
    {
      const bool isFirst = GetDistance(this->Nodes[node.Child], place) <=
        GetDistance(this->Nodes[node.Child + 1], place);
      open.push_back(node.Child + (isFirst ? 1 : 0));
      open.push_back(node.Child + (isFirst ? 0 : 1)); // taken next
      continue;
    }
    for (std::size_t i = node.Begin; i < node.End; ++i)
    {
      const std::size_t point = this->Order[i];
      const double square = GetSquare(this->Points[point], place);
      if (this->Has(point) && std::find(without.begin(), without.end(), point) == without.end() &&
        std::tie(square, point) < std::tie(found.Distance, found.Point))
      {
        found = { square, point };
      }
    }
  }
  return found;
}

//------------------------------------------------------------------------------
template <std::size_t N>
void Tree<N>::Remove(std::size_t point)
{
  this->Removed[point] = true;
  for (std::size_t number = this->Leaf[point]; number != None; number = this->Nodes[number].Parent)
  {
    Node& node = this->Nodes[number];
    if (node.Child != None)
    {
      node.First = std::min(this->Nodes[node.Child].First, this->Nodes[node.Child + 1].First);
      continue;
    }
    node.First = None;
    for (std::size_t i = node.Begin; i < node.End; ++i)
    {
      node.First = this->Has(this->Order[i]) ? std::min(node.First, this->Order[i]) : node.First;
    }
  }
}

//------------------------------------------------------------------------------
template <std::size_t N>
void Pair(const std::vector<Tuple<N>>& from, const std::vector<Tuple<N>>& to, std::size_t tries,
  const std::function<bool(std::size_t, std::size_t)>& accepts)
{
  using Candidate = std::tuple<double, std::size_t, std::size_t>; // squared distance, both points
  const std::vector<Tuple<N>> places = MakeFinite(from);
  const std::vector<Tuple<N>> targets = MakeFinite(to);
  Tree<N> left(targets);
  std::vector<std::vector<std::size_t>> refused(from.size());
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> nearest;
  const auto add = [&](std::size_t a) {
    const auto found = left.Find(places[a], refused[a]);
    if (found.Point != None)
    {
      nearest.emplace(found.Distance, a, found.Point);
    }
  };
  for (std::size_t a = 0; a < from.size(); ++a)
  {
    add(a);
  }
  while (!nearest.empty())
  {
    const auto [distance, a, b] = nearest.top();
    nearest.pop();
    if (!left.Has(b))
    {
      add(a); // another point has taken it
    }
    else if (accepts(a, b))
    {
      left.Remove(b);
    }
    else if (refused[a].size() + 1 < tries)
    {
      refused[a].push_back(b);
      add(a);
    }
  }
}
}

//------------------------------------------------------------------------------
void PairNearest(const std::vector<Tuple<3>>& from, const std::vector<Tuple<3>>& to,
  std::size_t tries, const std::function<bool(std::size_t, std::size_t)>& accepts)
{
  Pair(from, to, tries, accepts);
}

//------------------------------------------------------------------------------
void PairNearest(const std::vector<Tuple<6>>& from, const std::vector<Tuple<6>>& to,
  std::size_t tries, const std::function<bool(std::size_t, std::size_t)>& accepts)
{
  Pair(from, to, tries, accepts);
}
}
