// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSphereRays.h"

#include "vtkRelievoFrameCamera.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Largest = 1e30;        // greatest value that is safe in sums of floats
constexpr double PixelTolerance = 1e-3; // added to rectangles all around
constexpr double ClosestOfNear = 1e-9;  // least depth of bounds, over the near plane's

// The cross product of (x, y, 0) and (direction, -1).
glm::dvec3 Cross(const glm::dvec2& offset, const glm::dvec2& direction)
{
  return { -offset.y, offset.x, offset.x * direction.y - offset.y * direction.x };
}

bool IsSafe(const glm::dvec2& v)
{
  return std::abs(v.x) < Largest && std::abs(v.y) < Largest;
}

bool IsSafe(const glm::dvec3& v)
{
  return IsSafe(glm::dvec2(v)) && std::abs(v.z) < Largest;
}
}

//------------------------------------------------------------------------------
vtkRelievoSphereRays::vtkRelievoSphereRays(const vtkRelievoFrameCamera& view)
  : WorldToView(view.WorldToView)
  , Bounds(view.ViewToNDC)
  , Size(view.Viewport[2], view.Viewport[3])
{
  // NDC (p23 z + p33) = [p00 p10; p01 p11] (x, y) + (p20, p21) z + (p30, p31), solved for x and y.
  const glm::dmat4& p = view.ViewToNDC;
  this->Usual = p[0][3] == 0.0 && p[1][3] == 0.0;
  const glm::dmat2 toPlane = glm::inverse(glm::dmat2(p[0][0], p[0][1], p[1][0], p[1][1]));
  const glm::dvec2 byZ(p[2][0], p[2][1]);
  const glm::dvec2 constant(p[3][0], p[3][1]);
  const glm::dvec2 corner(-1.0); // NDC of pixel (0, 0)
  // Change of NDC per pixel.
  const glm::dmat2 ndc(2.0 / this->Size.x, 0.0, 0.0, 2.0 / this->Size.y);
  if (p[2][3] != 0.0)
  {
    this->Apex = p[3][3] / p[2][3];
    this->Base = toPlane * (this->Apex * byZ - constant);
    this->Direction = toPlane * (byZ - p[2][3] * corner);
    this->Directions = toPlane * (-p[2][3] * ndc);
  }
  else
  {
    this->Base = toPlane * (p[3][3] * corner - constant);
    this->Bases = toPlane * (p[3][3] * ndc);
    this->Direction = toPlane * byZ;
  }
  this->Begin = std::min(0.0, view.Near);
  this->From = p[2][3] != 0.0
    ? std::max(this->Begin, this->Apex) + ClosestOfNear * std::abs(view.Near)
    : this->Begin;
}

//------------------------------------------------------------------------------
glm::dvec2 vtkRelievoSphereRays::GetDirection(const glm::dvec2& pixel) const
{
  return this->Direction + this->Directions * pixel;
}

//------------------------------------------------------------------------------
bool vtkRelievoSphereRays::Find(
  const glm::dvec3& centerWorld, double radius, Sphere& sphere, double margin) const
{
  const double around = margin + PixelTolerance;
  const glm::dvec3 center(this->WorldToView * glm::dvec4(centerWorld, 1.0));
  const double depth = -center.z;
  double rectangle[4];
  if (!this->Bounds.FindRectangle(
        { center, radius }, this->From, std::max(this->From, depth + radius), rectangle))
  {
    return false;
  }
  // The pixels whose centres lie in the rectangle.
  for (int axis = 0; axis < 2; ++axis)
  {
    const double first = 0.5 * (rectangle[axis] + 1.0) * this->Size[axis];
    const double last = 0.5 * (rectangle[axis + 2] + 1.0) * this->Size[axis];
    sphere.Rectangle[axis] = static_cast<int>(std::max(0.0, std::ceil(first - 0.5 - around)));
    sphere.Rectangle[axis + 2] =
      static_cast<int>(std::min(this->Size[axis] - 1.0, std::floor(last - 0.5 + around)) + 1.0);
    if (sphere.Rectangle[axis] >= sphere.Rectangle[axis + 2])
    {
      return false;
    }
    sphere.Pixel[axis] = (sphere.Rectangle[axis] + sphere.Rectangle[axis + 2]) / 2 + 0.5;
  }

  const glm::dvec2 direction = this->GetDirection(sphere.Pixel);
  const glm::dmat2& turn = this->Directions;
  const double along = depth - this->Apex;
  sphere.Offset =
    (this->Base + this->Bases * sphere.Pixel + along * direction - glm::dvec2(center)) / radius;
  sphere.Offsets = (this->Bases + along * turn) / radius;
  sphere.MiddleDepth = depth - this->Begin;

  // The cross product is linear in the pixel: where both factors change, the quadratic terms
  // cancel.
  const glm::dvec3 cross = Cross(sphere.Offset, direction);
  glm::dvec3 change[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    change[axis] = Cross(sphere.Offsets[axis], direction);
    change[axis].z += sphere.Offset.x * turn[axis].y - sphere.Offset.y * turn[axis].x;
  }
  const glm::dvec3 ray(direction, -1.0);
  sphere.Linear = glm::dvec3(glm::dot(ray, ray) - glm::dot(cross, cross),
    2.0 * (glm::dot(direction, turn[0]) - glm::dot(cross, change[0])),
    2.0 * (glm::dot(direction, turn[1]) - glm::dot(cross, change[1])));
  sphere.Square = glm::dvec3(glm::dot(turn[0], turn[0]) - glm::dot(change[0], change[0]),
    2.0 * (glm::dot(turn[0], turn[1]) - glm::dot(change[0], change[1])),
    glm::dot(turn[1], turn[1]) - glm::dot(change[1], change[1]));
  return IsSafe(sphere.Linear) && IsSafe(sphere.Square) && IsSafe(sphere.Offset) &&
    IsSafe(sphere.Offsets[0]) && IsSafe(sphere.Offsets[1]) &&
    std::abs(sphere.MiddleDepth) < Largest;
}
