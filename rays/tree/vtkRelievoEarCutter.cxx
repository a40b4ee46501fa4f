// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEarCutter.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
bool vtkRelievoEarCutter::Cut(const std::vector<Point>& corners, std::vector<Triangle>& triangles)
{
  this->Points = corners.data();
  this->Count = static_cast<int>(corners.size());
  this->Before.resize(corners.size());
  this->Behind.resize(corners.size());
  for (int i = 0; i < this->Count; ++i)
  {
    this->Before[i] = i > 0 ? i - 1 : this->Count - 1;
    this->Behind[i] = i + 1 < this->Count ? i + 1 : 0;
  }
  this->MakeGrid();
  const auto isFlat = [this](int corner) {
    return this->Turn(this->Before[corner], corner, this->Behind[corner]) == 0.;
  };
  int corner = 0;
  int tried = 0; // corners tried since the last removal
  int left = this->Count;
  for (; left > 3 && tried < 3 * left; ++tried)
  {
    // In rounds: ears without corners on their edges, then corners without area, then ears that
    // touch other corners.
    const int round = tried / left;
    const bool flat = round == 1 && isFlat(corner);
    if (flat || (round != 1 && this->IsEar(corner, round == 0 ? Closed : Open)))
    {
      if (!flat)
      {
        triangles.push_back({ this->Before[corner], corner, this->Behind[corner] });
      }
      this->Remove(corner);
      --left;
      tried = -1;
      corner = this->Before[corner]; // its neighbours may have become ears
      continue;
    }
    corner = this->Behind[corner];
  }
  if (left == 3 && this->Turn(this->Before[corner], corner, this->Behind[corner]) > 0.)
  {
    triangles.push_back({ this->Before[corner], corner, this->Behind[corner] });
  }
  return left <= 3;
}

//------------------------------------------------------------------------------
// Twice the signed area of the triangle; positive for a left turn.
double vtkRelievoEarCutter::Turn(int a, int b, int c) const
{
  const Point& p = this->Points[a];
  const Point& q = this->Points[b];
  const Point& r = this->Points[c];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

//------------------------------------------------------------------------------
bool vtkRelievoEarCutter::IsEar(int corner, Strictness strictness) const
{
  const int a = this->Before[corner];
  const int c = this->Behind[corner];
  if (!(this->Turn(a, corner, c) > 0.))
  {
    return false;
  }
  std::size_t first[2], last[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto [low, high] =
      std::minmax({ this->Points[a][axis], this->Points[corner][axis], this->Points[c][axis] });
    first[axis] = this->GetColumn(low, axis);
    last[axis] = this->GetColumn(high, axis);
  }
  for (std::size_t y = first[1]; y <= last[1]; ++y)
  {
    for (std::size_t x = first[0]; x <= last[0]; ++x)
    {
      for (const int other : this->Grid[y * this->Columns + x])
      {
        if (this->Blocking[other] && this->Blocks(other, a, corner, c, strictness))
        {
          return false;
        }
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoEarCutter::Blocks(int other, int a, int b, int c, Strictness strictness) const
{
  if (other == a || other == b || other == c)
  {
    return false;
  }
  const Point& place = this->Points[other];
  if (place == this->Points[b])
  {
    // Two parts of the outline touch in b: is the other one inside the angle of this one?
    const auto within = [&](int corner) {
      return this->Turn(a, b, corner) > 0. && this->Turn(b, c, corner) > 0.;
    };
    return within(this->Before[other]) || within(this->Behind[other]);
  }
  if (place == this->Points[a] || place == this->Points[c])
  {
    return false;
  }
  const double least =
    std::min({ this->Turn(a, b, other), this->Turn(b, c, other), this->Turn(c, a, other) });
  return strictness == Closed ? least >= 0. : least > 0.;
}

//------------------------------------------------------------------------------
void vtkRelievoEarCutter::Remove(int corner)
{
  const int before = this->Before[corner];
  const int behind = this->Behind[corner];
  this->Behind[before] = behind;
  this->Before[behind] = before;
  this->Blocking[corner] = false;
  this->UpdateConvexity(before);
  this->UpdateConvexity(behind);
}

//------------------------------------------------------------------------------
void vtkRelievoEarCutter::UpdateConvexity(int corner)
{
  this->Blocking[corner] = !(this->Turn(this->Before[corner], corner, this->Behind[corner]) > 0.);
  if (this->Blocking[corner] && !this->InGrid[corner])
  {
    const Point& place = this->Points[corner];
    this->Grid[this->GetColumn(place[1], 1) * this->Columns + this->GetColumn(place[0], 0)]
      .push_back(corner);
    this->InGrid[corner] = true;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoEarCutter::MakeGrid()
{
  // About two corners per cell.
  this->Columns = static_cast<std::size_t>(std::clamp(std::sqrt(this->Count / 4.), 1., 1000.));
  Point highest = this->Lowest = this->Points[0];
  for (int i = 0; i < this->Count; ++i)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Lowest[axis] = std::min(this->Lowest[axis], this->Points[i][axis]);
      highest[axis] = std::max(highest[axis], this->Points[i][axis]);
    }
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    const double length = highest[axis] - this->Lowest[axis];
    this->Scale[axis] = length > 0. ? static_cast<double>(this->Columns) / length : 0.;
  }
  this->Grid.assign(this->Columns * this->Columns, {});
  this->Blocking.assign(static_cast<std::size_t>(this->Count), false);
  this->InGrid.assign(static_cast<std::size_t>(this->Count), false);
  for (int i = 0; i < this->Count; ++i)
  {
    this->UpdateConvexity(i);
  }
}

//------------------------------------------------------------------------------
std::size_t vtkRelievoEarCutter::GetColumn(double value, int axis) const
{
  return std::min(
    static_cast<std::size_t>((value - this->Lowest[axis]) * this->Scale[axis]), this->Columns - 1);
}
