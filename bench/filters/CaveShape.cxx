// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CaveShape.h"

#include <algorithm>
#include <cstddef>

namespace relievoBench
{
namespace
{
class Mask
{
public:
  Mask(const std::vector<unsigned char>& values, const std::array<int, 3>& size)
    : Values(values)
    , Size(size)
  {
  }
  std::size_t IndexOf(int i, int j, int k) const
  {
    return i +
      static_cast<std::size_t>(this->Size[0]) * (j + static_cast<std::size_t>(this->Size[1]) * k);
  }
  bool IsAir(int i, int j, int k) const
  {
    const bool inside =
      i >= 0 && j >= 0 && k >= 0 && i < this->Size[0] && j < this->Size[1] && k < this->Size[2];
    return inside && this->Values[this->IndexOf(i, j, k)];
  }

private:
  const std::vector<unsigned char>& Values;
  const std::array<int, 3> Size;
};

// The Euler number's contribution of a corner, edges, faces and cube, counted once for eight cubes
// of which some are air: bit x + 2 y + 4 z.
int EulerOf(unsigned int air)
{
  const auto any = [air](unsigned int bits) { return (air & bits) ? 1 : 0; };
  constexpr unsigned int X = 0xaa;
  constexpr unsigned int Y = 0xcc;
  constexpr unsigned int Z = 0xf0;
  return any(0xff) - any(X) - any(Y) - any(Z) + any(X & Y) + any(Y & Z) + any(X & Z) -
    any(X & Y & Z);
}

std::size_t RootOf(std::vector<std::size_t>& parents, std::size_t i)
{
  while (parents[i] != i)
  {
    parents[i] = parents[parents[i]];
    i = parents[i];
  }
  return i;
}

// Joins each sample of air with its 13 preceding neighbours.
void CountComponents(const Mask& mask, const std::array<int, 3>& size, CaveShape& shape)
{
  std::vector<std::size_t> parents(mask.IndexOf(size[0] - 1, size[1] - 1, size[2] - 1) + 1);
  std::vector<std::size_t> air;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        if (!mask.IsAir(i, j, k))
        {
          continue;
        }
        const std::size_t here = mask.IndexOf(i, j, k);
        parents[here] = here;
        air.push_back(here);
        for (int other = 0; other < 13; ++other)
        {
          const int x = i + other % 3 - 1;
          const int y = j + other / 3 % 3 - 1;
          const int z = k + other / 9 - 1;
          if (mask.IsAir(x, y, z))
          {
            const std::size_t a = RootOf(parents, here);
            const std::size_t b = RootOf(parents, mask.IndexOf(x, y, z));
            parents[std::max(a, b)] = std::min(a, b);
          }
        }
      }
    }
  }
  std::vector<long> counts(parents.size(), 0);
  long largest = 0;
  for (const std::size_t here : air)
  {
    const std::size_t root = RootOf(parents, here);
    shape.Components += root == here;
    largest = std::max(largest, ++counts[root]);
  }
  shape.Air = static_cast<double>(air.size()) / static_cast<double>(parents.size());
  shape.Largest = air.empty() ? 0. : static_cast<double>(largest) / static_cast<double>(air.size());
}
}

//------------------------------------------------------------------------------
CaveShape MeasureCaves(const std::vector<unsigned char>& values, const std::array<int, 3>& size)
{
  CaveShape shape;
  const Mask mask(values, size);
  CountComponents(mask, size, shape);
  double air = 0.;
  double level = 0.;
  double upright = 0.;
  for (int k = 0; k <= size[2]; ++k)
  {
    for (int j = 0; j <= size[1]; ++j)
    {
      for (int i = 0; i <= size[0]; ++i)
      {
        unsigned int around = 0;
        for (int cube = 0; cube < 8; ++cube)
        {
          const bool is =
            mask.IsAir(i - 1 + (cube & 1), j - 1 + (cube >> 1 & 1), k - 1 + (cube >> 2));
          around |= static_cast<unsigned int>(is) << cube;
        }
        shape.Euler += EulerOf(around);
        if (i + 1 < size[0] && j + 1 < size[1] && k + 1 < size[2])
        {
          const bool here = mask.IsAir(i, j, k);
          air += here;
          level +=
            0.25 * (here != mask.IsAir(i + 1, j, k)) + 0.25 * (here != mask.IsAir(i, j + 1, k));
          upright += 0.5 * (here != mask.IsAir(i, j, k + 1));
        }
      }
    }
  }
  shape.LevelWidth = air / level;
  shape.UprightWidth = air / upright;
  return shape;
}
}
