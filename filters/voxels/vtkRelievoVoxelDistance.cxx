// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelDistance.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <cmath>
#include <limits>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// The lower envelope of the parabolas over a line of cells.
class Line
{
public:
  Line(int size, double spacing)
    : Spacing(spacing)
    , Value(static_cast<std::size_t>(size))
    , Vertex(static_cast<std::size_t>(size))
    , From(static_cast<std::size_t>(size))
  {
  }

  void Sweep(float* first, vtkIdType stride)
  {
    const auto size = static_cast<int>(this->Value.size());
    int count = 0;
    for (int i = 0; i < size; ++i)
    {
      const double value = first[i * stride];
      this->Value[i] = value;
      if (value == Infinity)
      {
        continue;
      }
      double from = -Infinity;
      while (count > 0)
      {
        from = this->Intersect(this->Vertex[count - 1], i);
        if (from > this->From[count - 1])
        {
          break;
        }
        --count;
      }
      this->Vertex[count] = i;
      this->From[count] = count == 0 ? -Infinity : from;
      ++count;
    }
    for (int i = 0, at = 0; i < size && count > 0; ++i)
    {
      while (at + 1 < count && this->From[at + 1] < i)
      {
        ++at;
      }
      const double apart = (i - this->Vertex[at]) * this->Spacing;
      first[i * stride] = static_cast<float>(this->Value[this->Vertex[at]] + apart * apart);
    }
  }

private:
  // The position from which the parabola over cell b is lower than that over a.
  double Intersect(int a, int b) const
  {
    const double square = this->Spacing * this->Spacing;
    return ((this->Value[b] - this->Value[a]) / square + static_cast<double>(b) * b -
             static_cast<double>(a) * a) /
      (2. * (b - a));
  }

  double Spacing;
  std::vector<double> Value;
  std::vector<int> Vertex;
  std::vector<double> From;
};
}

//------------------------------------------------------------------------------
std::vector<float> vtkRelievoVoxelDistance::Squared(
  const unsigned char* mask, const std::array<int, 3>& cells, const std::array<double, 3>& spacing)
{
  const vtkIdType strides[3] = { 1, cells[0], static_cast<vtkIdType>(cells[0]) * cells[1] };
  const vtkIdType all = strides[2] * cells[2];
  std::vector<float> squares(static_cast<std::size_t>(all));
  for (vtkIdType i = 0; i < all; ++i)
  {
    squares[static_cast<std::size_t>(i)] = mask[i] ? 0.f : std::numeric_limits<float>::infinity();
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const int across = axis == 0 ? 1 : 0;
    const int up = axis == 2 ? 1 : 2;
    const vtkIdType lines = static_cast<vtkIdType>(cells[across]) * cells[up];
    vtkSMPTools::For(0, lines, 256, [&](vtkIdType begin, vtkIdType end) {
      Line line(cells[axis], spacing[axis]);
      for (vtkIdType i = begin; i < end; ++i)
      {
        line.Sweep(
          squares.data() + i % cells[across] * strides[across] + i / cells[across] * strides[up],
          strides[axis]);
      }
    });
  }
  return squares;
}
