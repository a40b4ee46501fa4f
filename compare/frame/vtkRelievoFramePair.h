// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Two frames of one scene, pixel by pixel: the values of one and of those around it in the other.
#ifndef vtkRelievoFramePair_h
#define vtkRelievoFramePair_h

#include "vtkRelievoComparedFrame.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <string>

namespace relievo::compare
{
class FramePair
{
public:
  FramePair(const Frame& before, const Frame& after)
    : A(before)
    , B(after)
  {
  }

  const Frame& A;
  const Frame& B;

  // Components of a pixel of the pictures, with alpha if both have it; 0: no picture.
  int CountLevels() const;

  // Visits the pixels up to `reach` columns and rows away, and the pixel itself.
  template <typename Visit>
  void ForNeighbours(std::size_t pixel, Visit visit, int reach = 1) const;

  // Whether each frame's value(frame, pixel) lies between the other frame's values around the
  // pixel.
  template <typename Value>
  bool IsBetween(std::size_t pixel, double limit, Value value) const;
  // One direction of it; `widening` extends the range by a part of its width at both ends.
  template <typename Value>
  bool IsBetween(const Frame& own, const Frame& other, std::size_t pixel, double limit, Value value,
    double widening = 0.0, int reach = 1) const;

  // Whether two values are equal; NaN equals NaN.
  static bool IsEqual(float a, float b);

  // The angle between two vectors of three components, in degrees.
  static double GetAngle(const float* a, const float* b);

  // A layer by its name; nullptr: none.
  static const Layer* Find(const std::map<std::string, Layer>& layers, const std::string& name);
};

//------------------------------------------------------------------------------
template <typename Visit>
void FramePair::ForNeighbours(std::size_t pixel, Visit visit, int reach) const
{
  const auto width = static_cast<std::ptrdiff_t>(this->A.Size[0]);
  const auto x = static_cast<std::ptrdiff_t>(pixel) % width;
  const auto y = static_cast<std::ptrdiff_t>(pixel) / width;
  for (std::ptrdiff_t v = std::max<std::ptrdiff_t>(0, y - reach);
       v <= std::min<std::ptrdiff_t>(this->A.Size[1] - 1, y + reach); ++v)
  {
    for (std::ptrdiff_t u = std::max<std::ptrdiff_t>(0, x - reach);
         u <= std::min<std::ptrdiff_t>(width - 1, x + reach); ++u)
    {
      visit(static_cast<std::size_t>(v * width + u));
    }
  }
}

//------------------------------------------------------------------------------
template <typename Value>
bool FramePair::IsBetween(std::size_t pixel, double limit, Value value) const
{
  return this->IsBetween(this->A, this->B, pixel, limit, value) &&
    this->IsBetween(this->B, this->A, pixel, limit, value);
}

//------------------------------------------------------------------------------
template <typename Value>
bool FramePair::IsBetween(const Frame& own, const Frame& other, std::size_t pixel, double limit,
  Value value, double widening, int reach) const
{
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  const auto take = [&](std::size_t near) {
    least = std::min(least, double(value(other, near)));
    most = std::max(most, double(value(other, near)));
  };
  this->ForNeighbours(pixel, take, reach);
  const double here = value(own, pixel);
  const double around = limit + (widening > 0.0 ? widening * (most - least) : 0.0);
  return here >= least - around && here <= most + around;
}
}

#endif
