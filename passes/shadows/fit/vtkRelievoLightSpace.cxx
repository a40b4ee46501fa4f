// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLightSpace.h"

#include "vtkRelievoShadowLight.h"
#include "vtkRelievoShadowSnapping.h"

#include <algorithm>
#include <cmath>

namespace
{
using Frame = vtkRelievoLightSpace;
using vtkRelievoShadowFit::Request;
using vtkRelievoShadowRegion::Rectangle;
using vtkRelievoShadowSnapping::Rounding;

// Tested angles of a map, in a quarter turn.
constexpr int Turns = 8;

glm::dmat4 LookAlong(const glm::dvec3& position, const glm::dvec3& forward, const glm::dvec3& right,
  const glm::dvec3& up)
{
  glm::dmat4 m(1.0);
  const glm::dvec3 rows[3] = { right, up, -forward };
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      m[column][row] = rows[row][column];
    }
    m[3][row] = -glm::dot(rows[row], position);
  }
  return m;
}

// The projection of a rectangle: at unit distance if perspective.
glm::dmat4 Project(const Rectangle& r, bool parallel, double n, double f)
{
  glm::dmat4 m(0.0);
  const glm::dvec2 size = r.Max - r.Min;
  const glm::dvec2 middle = 0.5 * (r.Max + r.Min);
  m[0][0] = 2.0 / size.x;
  m[1][1] = 2.0 / size.y;
  if (parallel)
  {
    m[2][2] = -2.0 / (f - n);
    m[3] = glm::dvec4(-2.0 * middle.x / size.x, -2.0 * middle.y / size.y, -(f + n) / (f - n), 1.0);
  }
  else
  {
    m[2] = glm::dvec4(2.0 * middle.x / size.x, 2.0 * middle.y / size.y, -(f + n) / (f - n), -1.0);
    m[3][2] = -2.0 * f * n / (f - n);
  }
  return m;
}

void Widen(Rectangle& r, const Request& request)
{
  const glm::dvec2 size = r.Max - r.Min;
  // A region without width, such as a line, still gets texels.
  const double least = 1e-6 * std::max(std::max(size.x, size.y), 1e-12);
  const glm::dvec2 middle = 0.5 * (r.Max + r.Min);
  const double texels =
    request.Size / static_cast<double>(std::max(1, request.Size - 2 * request.Border));
  const glm::dvec2 half = 0.5 * texels * glm::max(size, glm::dvec2(least));
  r.Min = middle - half;
  r.Max = middle + half;
}

// Points in the light's frame: their places in the map's plane, and their distances.
struct Seen
{
  std::vector<glm::dvec2> Hull;
  double Nearest = 1e300;
  double Farthest = -1e300;

  Seen(const Frame& frame, bool parallel, const std::vector<glm::dvec3>& points)
  {
    std::vector<glm::dvec2> places;
    for (const glm::dvec3& point : points)
    {
      const glm::dvec3 p = frame.Map(point);
      const double w = parallel ? 1.0 : p.z;
      places.emplace_back(p.x / w, p.y / w);
      this->Nearest = std::min(this->Nearest, p.z);
      this->Farthest = std::max(this->Farthest, p.z);
    }
    this->Hull = vtkRelievoShadowRegion::GetHull(std::move(places));
  }
};

// The depth range of a view's region, in steps of the whole scene's.
void SetDepths(const Seen& region, const Seen& whole, double side, vtkRelievoShadowView& view)
{
  view.Near = whole.Nearest;
  view.Far = whole.Farthest;
  if (view.Parallel)
  {
    // The map's side planes: nearly exact in float.
    const double first = std::floor((region.Nearest - whole.Nearest) / side + Rounding);
    const double last = std::ceil((region.Farthest - whole.Nearest) / side - Rounding);
    view.Near = whole.Nearest + side * first;
    view.Far = std::min(whole.Farthest, whole.Nearest + side * last);
  }
  else
  {
    view.Far = vtkRelievoShadowSnapping::Up(region.Farthest, whole.Farthest, 2);
  }
}

// The depth of the first caster in the view.
double GetFirst(
  const vtkRelievoShadowView& view, const Frame& frame, const std::vector<vtkRelievoBox>& casters)
{
  double first = 1e300;
  for (const vtkRelievoBox& box : casters)
  {
    if (view.Sees(box))
    {
      for (const glm::dvec3& corner : box.GetCorners())
      {
        first = std::min(first, frame.Map(corner).z);
      }
    }
  }
  return first;
}
}

//------------------------------------------------------------------------------
vtkRelievoLightSpace::vtkRelievoLightSpace(
  const glm::dvec3& origin, const glm::dvec3& forward, const glm::dvec3& up)
  : Origin(origin)
  , Forward(forward)
  , Up(up)
  , Right(glm::cross(forward, up))
{
}

//------------------------------------------------------------------------------
vtkRelievoLightSpace::vtkRelievoLightSpace(const glm::dvec3& origin, const glm::dvec3& forward)
  : vtkRelievoLightSpace(origin, forward, vtkRelievoShadowLight::AnySquareTo(forward))
{
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoLightSpace::Map(const glm::dvec3& world) const
{
  const glm::dvec3 p = world - this->Origin;
  const double depth = glm::dot(p, this->Forward);
  return glm::dvec3(glm::dot(p, this->Right) - depth * this->Shear.x,
    glm::dot(p, this->Up) - depth * this->Shear.y, depth);
}

//------------------------------------------------------------------------------
void vtkRelievoLightSpace::MoveTo(const glm::dvec3& p)
{
  this->Origin += this->Right * (p.x + p.z * this->Shear.x) +
    this->Up * (p.y + p.z * this->Shear.y) + this->Forward * p.z;
}

//------------------------------------------------------------------------------
glm::dvec4 vtkRelievoLightSpace::GetPlane(double x, double y, double z) const
{
  const glm::dvec3 normal = this->Right * x + this->Up * y + this->Forward * z;
  return glm::dvec4(normal, -glm::dot(normal, this->Origin));
}

//------------------------------------------------------------------------------
bool vtkRelievoLightSpace::Fit(bool parallel, const std::vector<glm::dvec3>& visible,
  const std::vector<glm::dvec3>& scene, const std::vector<vtkRelievoBox>& casters,
  const Request& request, vtkRelievoShadowView& view, const vtkRelievoMapPlacement& placement) const
{
  if (visible.empty() || scene.empty())
  {
    return false;
  }
  Frame frame = *this;
  const Seen region(frame, parallel, visible);
  const Seen whole(frame, parallel, scene);
  const double angle =
    placement.Turned ? placement.Angle : vtkRelievoShadowRegion::Enclose(whole.Hull).Angle;
  Rectangle rectangle =
    vtkRelievoShadowSnapping::Enclose(region.Hull, whole.Hull, angle, placement.Turned ? 1 : Turns);
  Widen(rectangle, request);
  const glm::dvec2 size = rectangle.Max - rectangle.Min;
  const double side = std::max(size.x, size.y);
  const double c = std::cos(rectangle.Angle);
  const double s = std::sin(rectangle.Angle);
  view.Parallel = parallel;
  SetDepths(region, whole, side, view);
  if (parallel)
  {
    // The view's origin is near its region, to keep digits far from the world's origin.
    const glm::dvec2 middle = 0.5 * (rectangle.Min + rectangle.Max);
    frame.MoveTo(glm::dvec3(c * middle.x - s * middle.y, s * middle.x + c * middle.y, view.Near));
    rectangle.Min = -0.5 * size;
    rectangle.Max = 0.5 * size;
    view.Far -= view.Near;
    view.Near = 0.0;
  }
  const double nearest = view.Near;
  const glm::dvec3 right = frame.Right * c + frame.Up * s;
  view.Forward = frame.Forward;
  view.Up = frame.Up * c - frame.Right * s;
  view.Position = frame.Origin;
  view.WorldToView = LookAlong(view.Position, view.Forward, right, view.Up);
  // First with a depth range around everything, to find the casters.
  view.Far += 1e-3 * (view.Far - view.Near) + 1e-6 * side * (parallel ? 1.0 : view.Far);
  view.Near = parallel ? nearest : Frame::NearestShare * view.Far;
  glm::dmat4 shear(1.0);
  shear[2].x = c * frame.Shear.x + s * frame.Shear.y;
  shear[2].y = c * frame.Shear.y - s * frame.Shear.x;
  view.ViewToNDC = Project(rectangle, parallel, view.Near, view.Far) * shear;
  const double first = GetFirst(view, frame, casters);
  if (first >= view.Far)
  {
    return false;
  }
  const double texel = side / request.Size;
  // Margin of a few texels' bias on both sides.
  const double room = 8.0 * texel * placement.Widest * (parallel ? 1.0 : view.Far);
  view.Far += parallel ? room : 0.0;
  const double before =
    std::max(1e-3 * (view.Far - (parallel ? std::max(first, nearest) : first)), room);
  // There are no receivers in front of the region: casters there are drawn onto the near plane, so
  // that a far one does not cost the others' precision.
  view.Near = parallel ? std::max(first, nearest) - before
                       : std::max(first - before, Frame::NearestShare * view.Far);
  view.ViewToNDC = Project(rectangle, parallel, view.Near, view.Far) * shear;
  view.NearCut = parallel && nearest > first;
  view.Width = size.x;
  view.Height = size.y;
  // Along an oblique ray, a texel's width covers less of the map's depth.
  const double oblique = 1.0 / std::sqrt(1.0 + glm::dot(frame.Shear, frame.Shear));
  view.Texel = parallel ? oblique * texel / (view.Far - view.Near)
                        : texel * view.Far * view.Near / (view.Far - view.Near);
  return true;
}
