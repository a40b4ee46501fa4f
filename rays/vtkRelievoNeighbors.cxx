// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoNeighbors.h"

#include "vtkRelievoMeshTree.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace
{
// For each corner the first one at the same position.
std::vector<std::uint32_t> Join(const vtkRelievoStoredArray<glm::dvec3>& places)
{
  std::size_t size = 16;
  while (size < 2 * places.size())
  {
    size *= 2;
  }
  constexpr auto none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> table(size, none);
  std::vector<std::uint32_t> first(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const glm::dvec3 at = places[i] + 0.0; // one zero
    std::uint64_t bits[3];
    std::memcpy(bits, &at, sizeof(bits));
    std::uint64_t hash = 0;
    for (const std::uint64_t each : bits)
    {
      hash = (hash ^ each) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    std::size_t slot = hash & (size - 1);
    while (table[slot] != none && !(places[table[slot]] == places[i]))
    {
      slot = (slot + 1) & (size - 1);
    }
    if (table[slot] == none)
    {
      table[slot] = static_cast<std::uint32_t>(i);
    }
    first[i] = table[slot];
  }
  return first;
}
}

//------------------------------------------------------------------------------
vtkRelievoNeighbors::vtkRelievoNeighbors(const vtkRelievoMeshTree& mesh)
{
  const std::size_t edges = 3 * static_cast<std::size_t>(mesh.GetNumberOfTriangles());
  this->Others.assign(edges, -1);
  const std::vector<std::uint32_t> joined = Join(mesh.GetPlaces());
  const std::uint32_t* corners = mesh.GetCorners(0);
  const auto getEnds = [&](std::size_t edge) {
    return std::minmax(
      { joined[corners[edge]], joined[corners[edge % 3 == 2 ? edge - 2 : edge + 1]] });
  };
  // Edges by their first end.
  std::vector<std::size_t> begins(joined.size() + 1);
  for (std::size_t edge = 0; edge < edges; ++edge)
  {
    ++begins[getEnds(edge).first];
  }
  std::size_t sum = 0;
  for (std::size_t& begin : begins)
  {
    sum += std::exchange(begin, sum);
  }
  std::vector<std::pair<std::uint32_t, std::int32_t>> ends(edges);
  for (std::size_t edge = 0; edge < edges; ++edge)
  {
    const auto [first, last] = getEnds(edge);
    ends[begins[first]++] = { last, static_cast<std::int32_t>(edge) };
  }
  std::size_t from = 0;
  for (const std::size_t to : begins)
  {
    std::sort(ends.begin() + static_cast<std::ptrdiff_t>(from),
      ends.begin() + static_cast<std::ptrdiff_t>(to));
    for (std::size_t i = from; i < to;)
    {
      std::size_t after = i + 1;
      while (after < to && ends[after].first == ends[i].first)
      {
        ++after;
      }
      if (after == i + 2)
      {
        this->Others[static_cast<std::size_t>(ends[i].second)] = ends[i + 1].second;
        this->Others[static_cast<std::size_t>(ends[i + 1].second)] = ends[i].second;
      }
      i = after;
    }
    from = to;
  }
}
