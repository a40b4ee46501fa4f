// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoBlueNoise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>

namespace
{
constexpr int Size = vtkRelievoBlueNoise::Size;
constexpr int Count = Size * Size;

// Points on a torus, and their density at each place: in integers, so that points can be removed
// exactly, and the order is the same on every machine.
class Pattern
{
public:
  Pattern()
    : Has(Count, false)
    , Crowd(Count, 0)
    , Weights(Count)
  {
    constexpr double sigma = 1.5; // pixels, Ulichney's
    for (int i = 0; i < Count; ++i)
    {
      const int x = std::min(i % Size, Size - i % Size);
      const int y = std::min(i / Size, Size - i / Size);
      this->Weights[i] =
        std::llround(std::exp(-(x * x + y * y) / (2.0 * sigma * sigma)) * (1 << 24));
    }
  }

  void Set(int place, bool has)
  {
    this->Has[place] = has;
    const int left = place % Size;
    const int low = place / Size;
    for (int y = 0; y < Size; ++y)
    {
      const std::size_t row = static_cast<std::size_t>((y - low) & (Size - 1)) * Size;
      for (int x = 0; x < Size; ++x)
      {
        const std::int64_t weight = this->Weights[row + ((x - left) & (Size - 1))];
        this->Crowd[static_cast<std::size_t>(y) * Size + x] += has ? weight : -weight;
      }
    }
  }

  int FindTightestCluster() const { return this->Find(true, -1); }
  int FindLargestVoid() const { return this->Find(false, 1); }

private:
  int Find(bool has, int sign) const
  {
    int best = -1;
    for (int i = 0; i < Count; ++i)
    {
      if (this->Has[i] == has && (best < 0 || sign * this->Crowd[i] < sign * this->Crowd[best]))
      {
        best = i;
      }
    }
    return best;
  }

  std::vector<bool> Has;
  std::vector<std::int64_t> Crowd;
  std::vector<std::int64_t> Weights;
};

std::vector<float> MakeThresholds()
{
  std::vector<int> places(Count);
  std::mt19937 random(1); // the standard defines its sequence
  for (int i = 0; i < Count; ++i)
  {
    places[i] = i;
    std::swap(places[i], places[random() % static_cast<unsigned int>(i + 1)]);
  }
  constexpr int first = Count / 10;
  Pattern pattern;
  for (int i = 0; i < first; ++i)
  {
    pattern.Set(places[i], true);
  }
  // Points move from the tightest cluster into the largest void until none moves.
  for (int from = -1, to = -2; from != to;)
  {
    from = pattern.FindTightestCluster();
    pattern.Set(from, false);
    to = pattern.FindLargestVoid();
    pattern.Set(to, true);
  }
  std::vector<float> thresholds(Count);
  const auto rank = [&thresholds](int place, int number) {
    thresholds[place] = (static_cast<float>(number) + 0.5F) / static_cast<float>(Count);
  };
  Pattern fewer = pattern;
  for (int i = first - 1; i >= 0; --i)
  {
    const int place = fewer.FindTightestCluster();
    fewer.Set(place, false);
    rank(place, i);
  }
  // The tightest cluster of empty places is the largest void: all weights have the same sum.
  for (int i = first; i < Count; ++i)
  {
    const int place = pattern.FindLargestVoid();
    pattern.Set(place, true);
    rank(place, i);
  }
  return thresholds;
}
}

//------------------------------------------------------------------------------
const std::vector<float>& vtkRelievoBlueNoise::GetThresholds()
{
  static const std::vector<float> thresholds = MakeThresholds();
  return thresholds;
}
