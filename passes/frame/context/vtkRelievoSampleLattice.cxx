// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSampleLattice.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <tuple>

namespace
{
// Quality of a lattice: the number of different positions in x and in y, which edges along the axes
// depend on; the least distance between two positions; and the number of cells in the raster of a
// square picture.
struct Quality
{
  int Levels = 0;
  int Distance = 0; // squared, times the squared number of samples
  int Cells = 0;

  // Beyond four fifths of the largest distance, a smaller raster is preferred.
  bool IsBetter(const Quality& other, int farthest) const
  {
    const auto rate = [farthest](const Quality& each) {
      return std::make_tuple(
        each.Levels, std::min(3 * each.Distance, 2 * farthest), -each.Cells, each.Distance);
    };
    return rate(*this) > rate(other);
  }
};

Quality GetQuality(const glm::ivec2& right, const glm::ivec2& up)
{
  // Steps between positions, times the number of samples.
  const glm::ivec2 a(up.y, -right.y);
  const glm::ivec2 b(-up.x, right.x);
  const int samples = right.x * up.y - right.y * up.x;
  Quality quality;
  quality.Levels = std::min(samples / std::gcd(std::gcd(a.x, b.x), samples),
    samples / std::gcd(std::gcd(a.y, b.y), samples));
  quality.Distance = samples * samples;
  for (int i = -3; i <= 3; ++i)
  {
    for (int j = -3; j <= 3; ++j)
    {
      const glm::ivec2 step = i * a + j * b;
      const int distance = step.x * step.x + step.y * step.y;
      quality.Distance = distance > 0 ? std::min(quality.Distance, distance) : quality.Distance;
    }
  }
  quality.Cells = (right.x + std::abs(up.x)) * (up.y + std::abs(right.y));
  return quality;
}
}

//------------------------------------------------------------------------------
vtkRelievoSampleLattice::vtkRelievoSampleLattice(int samples)
{
  const int most = 2 * static_cast<int>(std::ceil(std::sqrt(std::max(samples, 1))));
  const auto forEach = [samples, most](const auto& work) {
    for (int x = 1; x <= most; ++x)
    {
      for (int y = -x; y <= x; ++y)
      {
        for (int u = -most; u <= most; ++u)
        {
          // The fourth number makes the area equal to the number of samples.
          const int v = (samples + y * u) / x;
          if (x * v - y * u == samples && v > 0 && v <= 2 * most)
          {
            work(glm::ivec2(x, y), glm::ivec2(u, v), GetQuality({ x, y }, { u, v }));
          }
        }
      }
    }
  };
  int levels = 0;
  int farthest = 0;
  forEach([&](const glm::ivec2&, const glm::ivec2&, const Quality& quality) {
    farthest = quality.Levels > levels ? 0 : farthest;
    levels = std::max(levels, quality.Levels);
    farthest = quality.Levels == levels ? std::max(farthest, quality.Distance) : farthest;
  });
  Quality best;
  forEach([&](const glm::ivec2& right, const glm::ivec2& up, const Quality& quality) {
    if (quality.IsBetter(best, farthest))
    {
      best = quality;
      this->Right = right;
      this->Up = up;
    }
  });
  // A shift may move positions out of the pixel, and others into it.
  for (int i = 0; i < 8; ++i)
  {
    this->FindCells();
    glm::dvec2 mean(0.0);
    for (const glm::ivec2& cell : this->Cells)
    {
      mean += this->GetPlace(cell) / static_cast<double>(this->Cells.size());
    }
    if (glm::length(mean - 0.5) < 1e-9)
    {
      break;
    }
    this->Shift += 0.5 - mean;
  }
  std::stable_sort(
    this->Cells.begin(), this->Cells.end(), [this](const glm::ivec2& a, const glm::ivec2& b) {
      return glm::length(this->GetPlace(a) - 0.5) < glm::length(this->GetPlace(b) - 0.5);
    });
}

//------------------------------------------------------------------------------
int vtkRelievoSampleLattice::GetNumberInPlaceOf(int samples)
{
  const auto isPrime = [](int number) {
    for (int i = 2; i * i <= number; ++i)
    {
      if (number % i == 0)
      {
        return false;
      }
    }
    return true;
  };
  int number = samples + 2 * samples / 3;
  while (!isPrime(number))
  {
    ++number;
  }
  return number;
}

//------------------------------------------------------------------------------
void vtkRelievoSampleLattice::FindCells()
{
  this->Cells.clear();
  const glm::ivec2 reach = glm::abs(this->Right) + glm::abs(this->Up) + 1;
  for (int y = -reach.y; y <= reach.y; ++y)
  {
    for (int x = -reach.x; x <= reach.x; ++x)
    {
      const glm::dvec2 place = this->GetPlace({ x, y });
      // Positions on an edge, up to rounding, belong to one of the two pixels.
      const glm::dvec2 inside = glm::floor(place + 1e-9);
      if (inside == glm::dvec2(0.0))
      {
        this->Cells.emplace_back(x, y);
      }
    }
  }
}

//------------------------------------------------------------------------------
glm::dvec2 vtkRelievoSampleLattice::GetPlace(const glm::ivec2& cell) const
{
  const glm::dvec2 center = glm::dvec2(cell) + 0.5;
  const double area = this->Right.x * this->Up.y - this->Right.y * this->Up.x;
  return glm::dvec2(this->Up.y * center.x - this->Up.x * center.y,
           this->Right.x * center.y - this->Right.y * center.x) /
    area +
    this->Shift;
}

//------------------------------------------------------------------------------
glm::ivec2 vtkRelievoSampleLattice::GetOrigin(const glm::ivec2& pixels) const
{
  const glm::ivec2 none(0);
  glm::ivec2 low(0);
  for (const glm::ivec2& cell : this->Cells)
  {
    low = glm::min(low, cell);
  }
  const glm::ivec2 origin = -(
    glm::min((pixels.x - 1) * this->Right, none) + glm::min((pixels.y - 1) * this->Up, none) + low);
  // Numbers are counted from the origin's cells, in every raster.
  const glm::ivec2 step = this->GetNumberStep();
  for (int more = 0;; ++more)
  {
    for (int x = 0; x <= more; ++x)
    {
      const glm::ivec2 moved = origin + glm::ivec2(x, more - x);
      if ((moved.x * step.x + moved.y * step.y) % this->GetNumberOfSamples() == 0)
      {
        return moved;
      }
    }
  }
}

//------------------------------------------------------------------------------
// The step of a sample's position in x, in units of one divided by the number of samples.
glm::ivec2 vtkRelievoSampleLattice::GetNumberStep() const
{
  const int samples = this->GetNumberOfSamples();
  return { this->Up.y % samples, (samples - this->Up.x % samples) % samples };
}

//------------------------------------------------------------------------------
glm::ivec2 vtkRelievoSampleLattice::GetSize(const glm::ivec2& pixels) const
{
  const glm::ivec2 none(0);
  glm::ivec2 high(0);
  for (const glm::ivec2& cell : this->Cells)
  {
    high = glm::max(high, cell);
  }
  return this->GetOrigin(pixels) + glm::max((pixels.x - 1) * this->Right, none) +
    glm::max((pixels.y - 1) * this->Up, none) + high + 1;
}

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoSampleLattice::GetToRaster(const glm::ivec2& viewport, const int part[4]) const
{
  const glm::ivec2 pixels(part[2], part[3]);
  const glm::dvec2 scale = 2.0 / glm::dvec2(this->GetSize(pixels));
  const glm::dvec2 half = 0.5 * glm::dvec2(viewport);
  const glm::dvec2 right(this->Right);
  const glm::dvec2 up(this->Up);
  // The viewport's centre in pixels of the part, in GetPlace()'s coordinates.
  const glm::dvec2 center = half - glm::dvec2(part[0], part[1]) - this->Shift;
  const glm::dvec2 at = center.x * right + center.y * up + glm::dvec2(this->GetOrigin(pixels));
  glm::dmat4 toRaster(1.0);
  toRaster[0] = glm::dvec4(scale * half.x * right, 0.0, 0.0);
  toRaster[1] = glm::dvec4(scale * half.y * up, 0.0, 0.0);
  toRaster[3] = glm::dvec4(scale * at - 1.0, 0.0, 1.0);
  return toRaster;
}
