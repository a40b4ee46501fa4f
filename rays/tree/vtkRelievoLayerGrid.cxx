// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLayerGrid.h"

#include "vtkRelievoThreads.h"

#include <algorithm>
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
  this->Squares.assign(count * count, Square());
  this->HasAnswers = false;
}

//------------------------------------------------------------------------------
inline int vtkRelievoLayerGrid::GetPlace(double x) const
{
  const double place = 0.5 * (x + 1.0) * this->Count;
  return static_cast<int>(std::min(std::max(place, 0.0), this->Count - 1.0));
}

//------------------------------------------------------------------------------
void vtkRelievoLayerGrid::Add(
  bool isFront, const glm::dvec2 corners[3], const Box& box, double margin)
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
  // Twice the areas between a square's centre and the triangle's sides are linear in the centre.
  const double step = 2.0 / this->Count;
  const glm::dvec2 first(step * (left + 0.5) - 1.0, step * (top + 0.5) - 1.0);
  const double sign = isFront ? 1.0 : -1.0;
  double areas[3];
  double across[3];
  double down[3];
  for (int k = 0; k < 3; ++k)
  {
    const glm::dvec2 from = corners[k] - first;
    const glm::dvec2 to = corners[k == 2 ? 0 : k + 1] - first;
    areas[k] = sign * (from.x * to.y - to.x * from.y);
    across[k] = sign * step * (from.y - to.y);
    down[k] = sign * step * (to.x - from.x);
  }
  for (int row = top; row <= bottom; ++row)
  {
    for (int column = left; column <= right; ++column)
    {
      const double x = column - left;
      const double y = row - top;
      double least = std::numeric_limits<double>::max();
      for (int k = 0; k < 3; ++k)
      {
        least = std::min(least, areas[k] + x * across[k] + y * down[k]);
      }
      const std::size_t at = this->GetIndex(column, row);
      const bool isPart = this->HasAnswers && box.Min.z < this->Answers[at].HiddenBelow;
      Put(this->Squares[at],
        { box.Min.z, box.Max.z, least > margin ? 1 : 0, isPart || std::abs(least) <= margin });
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLayerGrid::AddOutline(const glm::dvec2& a, const glm::dvec2& b, const Box& box)
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
      Put(this->Squares[this->GetIndex(column, row)], { box.Min.z, box.Max.z, 0, true });
    }
  }
}

//------------------------------------------------------------------------------
// Joins the sheet with those that it overlaps; if there are too many, also the two farthest.
inline void vtkRelievoLayerGrid::Put(Square& square, Sheet sheet)
{
  for (int i = 0; i < square.Count;)
  {
    Sheet& other = square.Sheets[i];
    if (sheet.Low > other.High || other.Low > sheet.High)
    {
      ++i;
      continue;
    }
    const bool isWithin = other.Low <= sheet.Low && sheet.High <= other.High;
    sheet.Low = std::min(sheet.Low, other.Low);
    sheet.High = std::max(sheet.High, other.High);
    sheet.Layers += other.Layers;
    sheet.IsCrossed = sheet.IsCrossed || other.IsCrossed;
    if (isWithin)
    {
      other = sheet;
      return;
    }
    other = square.Sheets[--square.Count];
    i = 0;
  }
  if (square.Count == MostSheets)
  {
    const auto isBehind = [](const Sheet& a, const Sheet& b) { return a.IsBehind(b); };
    Sheet* const end = square.Sheets + MostSheets;
    Sheet& farthest = *std::min_element(square.Sheets, end, isBehind);
    if (farthest.IsBehind(sheet))
    {
      std::swap(farthest, sheet);
    }
    Sheet& next = *std::min_element(square.Sheets, end, isBehind);
    next.Low = sheet.Low;
    next.Layers += sheet.Layers;
    next.IsCrossed = next.IsCrossed || sheet.IsCrossed;
    return;
  }
  square.Sheets[square.Count++] = sheet;
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
    const Answer* answer = this->Answers.data() + this->GetIndex(left, row);
    for (int column = left; column <= right; ++column, ++answer)
    {
      if (!visit(*answer))
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
  constexpr float far = std::numeric_limits<float>::max();
  const int right = this->GetPlace(box.Max.x);
  const int bottom = this->GetPlace(box.Max.y);
  for (int row = this->GetPlace(box.Min.y); row <= bottom; ++row)
  {
    for (int column = this->GetPlace(box.Min.x); column <= right; ++column)
    {
      Put(this->Squares[this->GetIndex(column, row)], { -far, far, 0, true });
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLayerGrid::Finish()
{
  constexpr float far = std::numeric_limits<float>::infinity();
  if (this->Left == 0) // no box is asked for
  {
    return;
  }
  this->Answers.resize(this->Squares.size());
  vtkRelievoForAll(static_cast<vtkIdType>(this->Squares.size()), [&](vtkIdType i) {
    const Square& square = this->Squares[i];
    Answer& answer = this->Answers[i];
    answer = { far, this->HasAnswers ? answer.HiddenBelow : -far };
    float nearest = -far;
    for (int k = 0; k < square.Count; ++k)
    {
      const Sheet& sheet = square.Sheets[k];
      const bool isWhole = sheet.Layers > 0 && !sheet.IsCrossed;
      answer.HiddenBelow = std::max(answer.HiddenBelow, isWhole ? sheet.Low : -far);
      if (sheet.Low > nearest)
      {
        nearest = sheet.Low;
        answer.FirstFrom = isWhole && sheet.Layers == 1 ? sheet.Low : far;
      }
    }
  });
  this->HasAnswers = true;
}

//------------------------------------------------------------------------------
bool vtkRelievoLayerGrid::IsHidden(const Box& box) const
{
  return this->ForEach(
    box, [&box](const Answer& answer) { return box.Max.z < answer.HiddenBelow; });
}

//------------------------------------------------------------------------------
bool vtkRelievoLayerGrid::IsFirst(const Box& box) const
{
  return this->ForEach(box, [&box](const Answer& answer) { return box.Min.z >= answer.FirstFrom; });
}
