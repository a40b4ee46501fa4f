// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPolygonOutline.h"

#include "vtkMath.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
vtkRelievoPolygonOutline::vtkRelievoPolygonOutline(vtkPoints* points)
  : Points(points)
  , Tolerance(points->GetDataType() == VTK_FLOAT ? 1e-6 : 1e-12)
{
}

//------------------------------------------------------------------------------
vtkRelievoPolygonOutline::Way vtkRelievoPolygonOutline::Look(vtkIdType count, const vtkIdType* ids)
{
  const vtkIdType points = this->Points->GetNumberOfPoints();
  const auto isThere = [points](vtkIdType id) { return id >= 0 && id < points; };
  if (count < 4 || !std::all_of(ids, ids + count, isThere))
  {
    return Way::AsItIs;
  }
  this->Corners.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->Points->GetPoint(ids[i], this->Corners[static_cast<std::size_t>(i)].data());
  }
  this->Normal = {};
  for (std::size_t i = 2; i < this->Corners.size(); ++i)
  {
    const Vector cross = this->Cross(0, i - 1, i);
    vtkMath::Add(this->Normal.data(), cross.data(), this->Normal.data());
  }
  const double square = vtkMath::Dot(this->Normal.data(), this->Normal.data());
  this->Least = -this->Tolerance * square;
  const bool backwards = this->LooksBackwards();
  if (!(square > 0.) || !std::isfinite(square) || !(backwards || this->Folds(0)))
  {
    return Way::AsItIs;
  }
  // A corner that sees all others is usually found early; large outlines hardly have one.
  const std::size_t most = backwards ? 0 : std::min<std::size_t>(this->Corners.size(), 1000);
  for (this->First = 1; this->First < most; ++this->First)
  {
    if (!this->Folds(this->First))
    {
      return Way::Turned;
    }
  }
  return this->Cut() ? Way::Cut : Way::AsItIs;
}

//------------------------------------------------------------------------------
// Vector along the triangle's normal, of twice its area.
vtkRelievoPolygonOutline::Vector vtkRelievoPolygonOutline::Cross(
  std::size_t a, std::size_t b, std::size_t c) const
{
  Vector ab, ac, cross;
  vtkMath::Subtract(this->Corners[b].data(), this->Corners[a].data(), ab.data());
  vtkMath::Subtract(this->Corners[c].data(), this->Corners[a].data(), ac.data());
  vtkMath::Cross(ab.data(), ac.data(), cross.data());
  return cross;
}

//------------------------------------------------------------------------------
bool vtkRelievoPolygonOutline::Folds(std::size_t first) const
{
  const std::size_t count = this->Corners.size();
  const auto wrap = [count](std::size_t i) { return i < count ? i : i - count; };
  for (std::size_t i = 2; i < count; ++i)
  {
    const Vector cross = this->Cross(first, wrap(first + i - 1), wrap(first + i));
    if (vtkMath::Dot(cross.data(), this->Normal.data()) < this->Least)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// VTK sums the triangles at the corners, where concave corners may outweigh the others. With four
// corners the sum is twice the area.
bool vtkRelievoPolygonOutline::LooksBackwards() const
{
  const std::size_t count = this->Corners.size();
  Vector sum = {};
  for (std::size_t i = 0; count > 4 && i < count; ++i)
  {
    const Vector cross = this->Cross(i, (i + 1) % count, (i + 2) % count);
    vtkMath::Add(sum.data(), cross.data(), sum.data());
  }
  return vtkMath::Dot(sum.data(), this->Normal.data()) < 0.;
}

//------------------------------------------------------------------------------
// Projects along the axis nearest to the normal.
bool vtkRelievoPolygonOutline::Cut()
{
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = std::abs(this->Normal[i]) > std::abs(this->Normal[axis]) ? i : axis;
  }
  const bool above = this->Normal[axis] > 0.;
  const int u = (axis + (above ? 1 : 2)) % 3;
  const int v = (axis + (above ? 2 : 1)) % 3;
  this->Flat.clear();
  for (const Vector& corner : this->Corners)
  {
    this->Flat.push_back({ corner[u], corner[v] });
  }
  this->Triangles.clear();
  return this->Cutter.Cut(this->Flat, this->Triangles);
}
