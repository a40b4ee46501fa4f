// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLayerGrid.h"

#include <cmath>
#include <limits>

namespace
{
constexpr int LeastSquares = 16;    // in each direction
constexpr double MostSquares = 2.0; // per triangle
constexpr double RoomOfEdges = 1e-6;
}

//------------------------------------------------------------------------------
void vtkRelievoLayerGrid::Clear(std::size_t triangles, double size)
{
  const double most = std::sqrt(MostSquares * static_cast<double>(triangles));
  const double wanted = size > 0.0 ? 2.0 / size : 0.0;
  this->Count = std::max(LeastSquares, static_cast<int>(std::min(wanted, most)));
  const auto count = static_cast<std::size_t>(this->Count);
  this->Left = MostLooks * (triangles + count * count);
  constexpr float far = std::numeric_limits<float>::max();
  this->Squares.assign(count * count, Square{ { far, far }, { -far, -far }, { 0, 0 }, false });
}

//------------------------------------------------------------------------------
int vtkRelievoLayerGrid::GetPlace(double x) const
{
  const double place = 0.5 * (x + 1.0) * this->Count;
  return static_cast<int>(std::min(std::max(place, 0.0), this->Count - 1.0));
}

//------------------------------------------------------------------------------
void vtkRelievoLayerGrid::Add(int side, const glm::dvec2 corners[3], const Box& box, double margin)
{
  const int left = this->GetPlace(box.Min.x);
  const int right = this->GetPlace(box.Max.x);
  const int top = this->GetPlace(box.Min.y);
  const int bottom = this->GetPlace(box.Max.y);
  const auto looks =
    static_cast<std::size_t>(right - left + 1) * static_cast<std::size_t>(bottom - top + 1);
  this->Left -= std::min(this->Left, looks);
  if (this->Left == 0)
  {
    return;
  }
  const double sign = side == 0 ? 1.0 : -1.0;
  const double step = 2.0 / this->Count;
  for (int row = top; row <= bottom; ++row)
  {
    for (int column = left; column <= right; ++column)
    {
      Square& square = this->At(column, row);
      square.Least[side] = std::min(square.Least[side], box.Min.z);
      square.Greatest[side] = std::max(square.Greatest[side], box.Max.z);
      const glm::dvec2 middle(step * (column + 0.5) - 1.0, step * (row + 0.5) - 1.0);
      double least = std::numeric_limits<double>::max();
      for (int k = 0; k < 3; ++k)
      {
        const glm::dvec2 from = corners[k] - middle;
        const glm::dvec2 to = corners[k == 2 ? 0 : k + 1] - middle;
        least = std::min(least, sign * (from.x * to.y - to.x * from.y));
      }
      square.Layers[side] += least > margin ? 1 : 0;
      square.IsCrossed = square.IsCrossed || std::abs(least) <= margin;
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLayerGrid::AddOutline(const glm::dvec2& a, const glm::dvec2& b)
{
  const glm::dvec2 low = glm::min(a, b) - RoomOfEdges;
  const glm::dvec2 high = glm::max(a, b) + RoomOfEdges;
  if (low.x > 1.0 || low.y > 1.0 || high.x < -1.0 || high.y < -1.0)
  {
    return;
  }
  const double step = 2.0 / this->Count;
  const int bottom = this->GetPlace(high.y);
  for (int row = this->GetPlace(low.y); row <= bottom; ++row)
  {
    // The edge's extent within the row.
    double from = 0.0;
    double to = 1.0;
    if (high.y - low.y > 4.0 * RoomOfEdges)
    {
      const double top = step * row - 1.0 - RoomOfEdges;
      const double t = (top - a.y) / (b.y - a.y);
      const double u = (top + step + 2.0 * RoomOfEdges - a.y) / (b.y - a.y);
      from = std::max(from, std::min(t, u));
      to = std::min(to, std::max(t, u));
    }
    const double x = a.x + from * (b.x - a.x);
    const double y = a.x + to * (b.x - a.x);
    const int right = this->GetPlace(std::max(x, y) + RoomOfEdges);
    for (int column = this->GetPlace(std::min(x, y) - RoomOfEdges); column <= right; ++column)
    {
      this->At(column, row).IsCrossed = true;
    }
  }
}

//------------------------------------------------------------------------------
template <typename Visit>
bool vtkRelievoLayerGrid::ForEach(const Box& box, Visit visit) const
{
  const bool isWithin = box.Min.x >= -1.f && box.Min.y >= -1.f && box.Max.x <= 1.f &&
    box.Max.y <= 1.f && box.Min.x <= box.Max.x;
  if (!isWithin || this->Left == 0)
  {
    return false;
  }
  const int left = this->GetPlace(box.Min.x);
  const int right = this->GetPlace(box.Max.x);
  const int bottom = this->GetPlace(box.Max.y);
  for (int row = this->GetPlace(box.Min.y); row <= bottom; ++row)
  {
    const Square* square = this->Squares.data() +
      static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Count) + left;
    for (int column = left; column <= right; ++column, ++square)
    {
      if (square->IsCrossed || !visit(*square))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoLayerGrid::Block(const Box& box)
{
  const int right = this->GetPlace(box.Max.x);
  const int bottom = this->GetPlace(box.Max.y);
  for (int row = this->GetPlace(box.Min.y); row <= bottom; ++row)
  {
    for (int column = this->GetPlace(box.Min.x); column <= right; ++column)
    {
      this->At(column, row).IsCrossed = true;
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoLayerGrid::IsHidden(const Box& box) const
{
  return this->ForEach(box, [&box](const Square& square) {
    return (square.Layers[0] > 0 && box.Max.z < square.Least[0]) ||
      (square.Layers[1] > 0 && box.Max.z < square.Least[1]);
  });
}

//------------------------------------------------------------------------------
bool vtkRelievoLayerGrid::IsFirst(const Box& box, int side) const
{
  return this->ForEach(box, [&box, side](const Square& square) {
    return square.Layers[side] == 1 && box.Min.z > square.Greatest[1 - side];
  });
}
