// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSphereBounds.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
glm::dvec4 GetRow(const glm::dmat4& matrix, int row)
{
  return { matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row] };
}

}

//------------------------------------------------------------------------------
vtkRelievoSphereBounds::vtkRelievoSphereBounds(const glm::dmat4& viewToNDC)
  : Rows{ GetRow(viewToNDC, 0), GetRow(viewToNDC, 1), GetRow(viewToNDC, 3) }
  , Usual(this->Rows[2].x == 0.0 && this->Rows[2].y == 0.0)
{
  const glm::dvec3 w(this->Rows[2]);
  this->SquareW = glm::dot(w, w);
  for (int axis = 0; axis < 2; ++axis)
  {
    const glm::dvec3 normal(this->Rows[axis]);
    this->Across[axis] = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    this->Square[axis] = glm::dot(normal, normal);
    this->Mixed[axis] = glm::dot(normal, w);
  }
}

//------------------------------------------------------------------------------
glm::dvec4 vtkRelievoSphereBounds::GetPlane(int axis, double ndc) const
{
  const glm::dvec4 plane = this->Rows[axis] - ndc * this->Rows[2];
  return plane / glm::length(glm::dvec3(plane));
}

//------------------------------------------------------------------------------
bool vtkRelievoSphereBounds::FindExtent(
  const Sphere& sphere, int axis, double from, double to, double& least, double& most) const
{
  const glm::dvec3& center = sphere.Center;
  const double radius = sphere.Radius;
  const double depth = -center.z;
  if (depth + radius < from || depth - radius > to)
  {
    return false;
  }
  if (!this->Usual)
  {
    least = -std::numeric_limits<double>::infinity();
    most = std::numeric_limits<double>::infinity();
    return true;
  }
  least = std::numeric_limits<double>::infinity();
  most = -least;
  const auto take = [&](double ndc) {
    least = std::min(least, ndc);
    most = std::max(most, ndc);
  };
  const glm::dvec4& row = this->Rows[axis];
  const glm::dvec4& rowW = this->Rows[2];

  // The circle at which the sphere is cut.
  const double across = row.x * center.x + row.y * center.y + row.w;
  for (const double cut : { from, to })
  {
    const double left2 = radius * radius - (cut - depth) * (cut - depth);
    const double w = rowW.w - rowW.z * cut;
    if (left2 >= 0.0 && w > 0.0)
    {
      const double middle = across - row.z * cut;
      const double reach = std::sqrt(left2) * this->Across[axis];
      take((middle - reach) / w);
      take((middle + reach) / w);
    }
  }

  // Planes of constant NDC that touch the sphere: (a - ndc b)^2 = radius^2 |A - ndc B|^2.
  const double a = across + row.z * center.z;
  const double b = rowW.z * center.z + rowW.w;
  const double r2 = radius * radius;
  const double square = b * b - r2 * this->SquareW;
  const double half = a * b - r2 * this->Mixed[axis];
  const double constant = a * a - r2 * this->Square[axis];
  const double discriminant = half * half - square * constant;
  if (discriminant >= 0.0)
  {
    // One root without cancellation, the other from the product of both.
    const double sum = half + std::copysign(std::sqrt(discriminant), half);
    const double roots[2] = { sum / square, constant / sum };
    for (const double ndc : roots)
    {
      const double length2 =
        this->Square[axis] + ndc * (ndc * this->SquareW - 2.0 * this->Mixed[axis]);
      const double z = center.z - (row.z - ndc * rowW.z) * ((a - ndc * b) / length2);
      if (-z >= from && -z <= to && rowW.z * z + rowW.w > 0.0) // false for NaN
      {
        take(ndc);
      }
    }
  }
  return least <= most;
}

//------------------------------------------------------------------------------
bool vtkRelievoSphereBounds::FindRectangle(
  const Sphere& sphere, double from, double to, double rectangle[4]) const
{
  for (int axis = 0; axis < 2; ++axis)
  {
    double least;
    double most;
    if (!this->FindExtent(sphere, axis, from, to, least, most) || least > 1.0 || most < -1.0)
    {
      return false;
    }
    rectangle[axis] = std::max(-1.0, least);
    rectangle[axis + 2] = std::min(1.0, most);
  }
  return true;
}
