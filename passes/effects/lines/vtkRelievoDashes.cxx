// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDashes.h"

#include <algorithm>
#include <cmath>

namespace
{
using Piece = vtkRelievoDashes::Piece;
using Joint = vtkRelievoDashes::Joint;

constexpr double Straight = 0.5; // cosine of the largest turn within one line
constexpr double Around = 16.0;  // pixels around the picture in which lines still count
constexpr int None = -1;

class Chains
{
public:
  // Only entries at the pieces' end points are written and read.
  Chains(const std::vector<Piece>& pieces, std::vector<Joint>& joints)
    : Pieces(pieces)
    , At(joints)
    , Done(pieces.size(), false)
  {
    for (const Piece& piece : pieces)
    {
      this->At[piece.Points[0]].Count = this->At[piece.Points[1]].Count = 0;
    }
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      for (const std::uint32_t point : pieces[i].Points)
      {
        Joint& here = this->At[point];
        if (here.Count < 2)
        {
          here.First[here.Count] = static_cast<int>(i);
        }
        ++here.Count;
      }
    }
  }

  // The piece that continues this one beyond its end; None if the line ends there.
  int FindNext(int piece, int end) const
  {
    const Piece& here = this->Pieces[static_cast<std::size_t>(piece)];
    const Joint& at = this->At[here.Points[end]];
    if (at.Count != 2)
    {
      return None;
    }
    const int next = at.First[0] == piece ? at.First[1] : at.First[0];
    const Piece& there = this->Pieces[static_cast<std::size_t>(next)];
    const int start = there.Points[0] == here.Points[end] ? 0 : 1;
    const glm::dvec2 before = here.Ends[end] - here.Ends[1 - end];
    const glm::dvec2 after = there.Ends[1 - start] - there.Ends[start];
    const bool goesOn = (here.Smooth && there.Smooth) ||
      glm::dot(before, after) >= Straight * glm::length(before) * glm::length(after);
    // A piece clipped at the eye does not end at its point.
    return goesOn && here.Ends[end] == there.Ends[start] ? next : None;
  }

  // Follows the line from the start of its first piece; each entry is a piece and its starting end.
  std::vector<std::pair<int, int>> Follow(int piece, int start)
  {
    std::vector<std::pair<int, int>> line;
    while (piece != None && !this->Done[static_cast<std::size_t>(piece)])
    {
      this->Done[static_cast<std::size_t>(piece)] = true;
      line.emplace_back(piece, start);
      const std::uint32_t point = this->Pieces[static_cast<std::size_t>(piece)].Points[1 - start];
      piece = this->FindNext(piece, 1 - start);
      start =
        piece != None && this->Pieces[static_cast<std::size_t>(piece)].Points[0] == point ? 0 : 1;
    }
    return line;
  }

  bool IsDone(int piece) const { return this->Done[static_cast<std::size_t>(piece)]; }

private:
  const std::vector<Piece>& Pieces;
  std::vector<Joint>& At;
  std::vector<bool> Done;
};

// Clips a segment to the picture and its surroundings, as shares of its length. False if it lies
// outside.
bool Clip(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& size, double shares[2])
{
  shares[0] = 0.0;
  shares[1] = 1.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double step = to[axis] - from[axis];
    const double low = -Around - from[axis];
    const double high = size[axis] + Around - from[axis];
    if (step == 0.0)
    {
      shares[1] = low <= 0.0 && high >= 0.0 ? shares[1] : -1.0;
      continue;
    }
    shares[0] = std::max(shares[0], std::min(low / step, high / step));
    shares[1] = std::min(shares[1], std::max(low / step, high / step));
  }
  return shares[0] <= shares[1];
}
}

//------------------------------------------------------------------------------
void vtkRelievoDashes::Append(const std::vector<Piece>& pieces, std::uint32_t points, double dash,
  const glm::dvec2& size, std::vector<float>& texels)
{
  if (pieces.empty())
  {
    return;
  }
  this->Joints.resize(std::max<std::size_t>(this->Joints.size(), points));
  Chains chains(pieces, this->Joints);
  const auto append = [&](int first, int start) {
    const auto line = chains.Follow(first, start);
    double length = 0.0;
    for (const auto& each : line)
    {
      const Piece& piece = pieces[static_cast<std::size_t>(each.first)];
      length += glm::length(piece.Ends[1] - piece.Ends[0]);
    }
    // Dashes with their gaps; a line without gaps stays at the middle of one dash.
    const double perPixel =
      length < dash ? 0.0 : std::max(1.0, std::round(length * Share / dash)) / length;
    double along = 0.0;
    for (const auto& each : line)
    {
      const Piece& piece = pieces[static_cast<std::size_t>(each.first)];
      const glm::dvec2& from = piece.Ends[each.second];
      const glm::dvec2& to = piece.Ends[1 - each.second];
      const double steps = perPixel * glm::length(to - from);
      double shares[2];
      if (Clip(from, to, size, shares))
      {
        const glm::dvec2 ends[2] = { from + shares[0] * (to - from),
          from + shares[1] * (to - from) };
        const double near = piece.Nearness[each.second];
        const double step = piece.Nearness[1 - each.second] - near;
        for (const double value :
          { ends[0].x, ends[0].y, ends[1].x, ends[1].y, near + shares[0] * step,
            near + shares[1] * step, along + shares[0] * steps, along + shares[1] * steps })
        {
          texels.push_back(static_cast<float>(value));
        }
      }
      along += steps;
      along -= std::floor(along); // keeps the floats small
    }
  };
  const auto count = static_cast<int>(pieces.size());
  for (int i = 0; i < count; ++i)
  {
    for (int end = 0; end < 2; ++end)
    {
      if (!chains.IsDone(i) && chains.FindNext(i, end) == None)
      {
        append(i, end);
      }
    }
  }
  for (int i = 0; i < count; ++i)
  {
    if (!chains.IsDone(i)) // a closed line
    {
      append(i, 0);
    }
  }
}
