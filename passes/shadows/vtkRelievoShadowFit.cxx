// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowFit.h"

#include "vtkMath.h"
#include "vtkRelievoShadowLight.h"

#include <algorithm>
#include <cmath>

namespace
{
using vtkRelievoShadowFit::Request;
using vtkRelievoShadowRegion::Polygon;

// Half the opening, in tangents, up to which one perspective map serves a lamp; beyond it texels at
// the rim get too small for what they cost.
constexpr double WidestTangent = 1.43; // 55 degrees
// Sides of a cube reach a little over their edges, for the filter.
constexpr double CubeTangent = 1.01;
// Nearest plane of a perspective map, as a share of the farthest: floats keep 4 digits then.
// Casters before it are drawn onto it.
constexpr double NearestShare = 1e-3;

glm::dvec3 AnySquareTo(const glm::dvec3& v)
{
  const glm::dvec3 size = glm::abs(v);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
    : size.y <= size.z                                         ? glm::dvec3(0, 1, 0)
                                                               : glm::dvec3(0, 0, 1);
  return glm::normalize(axis - v * glm::dot(axis, v));
}

struct Frame
{
  glm::dvec3 Origin;
  glm::dvec3 Forward;
  glm::dvec3 Up;
  glm::dvec3 Right;
  glm::dvec2 Shear{ 0.0 }; // right and up per forward: of oblique parallel rays

  Frame(const glm::dvec3& origin, const glm::dvec3& forward, const glm::dvec3& up)
    : Origin(origin)
    , Forward(forward)
    , Up(up)
    , Right(glm::cross(forward, up))
  {
  }

  // Right, up, forward.
  glm::dvec3 Map(const glm::dvec3& world) const
  {
    const glm::dvec3 p = world - this->Origin;
    const double depth = glm::dot(p, this->Forward);
    return glm::dvec3(glm::dot(p, this->Right) - depth * this->Shear.x,
      glm::dot(p, this->Up) - depth * this->Shear.y, depth);
  }

  // The plane right * x + up * y + forward * z >= 0 through the origin, in world coordinates.
  glm::dvec4 GetPlane(double x, double y, double z) const
  {
    const glm::dvec3 normal = this->Right * x + this->Up * y + this->Forward * z;
    return glm::dvec4(normal, -glm::dot(normal, this->Origin));
  }
};

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
glm::dmat4 Project(const vtkRelievoShadowRegion::Rectangle& r, bool parallel, double n, double f)
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

void Widen(vtkRelievoShadowRegion::Rectangle& r, const Request& request)
{
  const glm::dvec2 size = r.Max - r.Min;
  // A region without width, a line say, still has texels.
  const double least = 1e-6 * std::max(std::max(size.x, size.y), 1e-12);
  const glm::dvec2 middle = 0.5 * (r.Max + r.Min);
  const double texels =
    request.Size / static_cast<double>(std::max(1, request.Size - 2 * request.Border));
  const glm::dvec2 half =
    0.5 * (1.0 + 2.0 * request.Margin) * texels * glm::max(size, glm::dvec2(least));
  r.Min = middle - half;
  r.Max = middle + half;
}

// The frame whose depth is the height over the ground, which is what stands on the view-up's
// nearest axis: rays are sheared upright, and the map lies in the ground. Upright rays if the sun
// is too low.
Frame MakeGroundFrame(
  const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& viewUp)
{
  constexpr double Lowest = 0.03;
  auto nearestAxis = [](const glm::dvec3& v) {
    const glm::dvec3 size = glm::abs(v);
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  };
  int axis = nearestAxis(viewUp);
  if (std::abs(direction[axis]) < Lowest)
  {
    axis = nearestAxis(direction);
  }
  glm::dvec3 forward(0.0);
  forward[axis] = direction[axis] < 0.0 ? -1.0 : 1.0;
  Frame frame(origin, forward, AnySquareTo(forward));
  const double depth = glm::dot(direction, forward);
  frame.Shear =
    glm::dvec2(glm::dot(direction, frame.Right) / depth, glm::dot(direction, frame.Up) / depth);
  return frame;
}

// What the camera needs along one axis of the map: where most texels, and how many times fewer at
// the farther end. Pixels on a surface grow with their distance from the eye.
void SetWarp(vtkRelievoShadowView& view, const std::vector<glm::dvec3>& world,
  const std::vector<glm::dvec2>& places, const Request& request)
{
  if (request.ParallelEye)
  {
    return;
  }
  double nearest = 1e300;
  double farthest = 0.0;
  glm::dvec2 focus(0.5);
  for (std::size_t i = 0; i < world.size(); ++i)
  {
    const double depth = glm::dot(world[i] - request.Eye, request.Gaze);
    farthest = std::max(farthest, depth);
    if (depth < nearest)
    {
      nearest = depth;
      focus = places[i];
    }
  }
  if (!(nearest > 0.0))
  {
    return;
  }
  // The u axis runs along the gaze. Across it, distance changes little.
  view.U.Warp(focus.x, std::min(farthest / nearest, 36.0), request.Size);
}

// A view for the points (right, up, forward of the frame). False if nothing casts into it.
bool MakeView(const Frame& frame, bool parallel, const std::vector<glm::dvec3>& world,
  const std::vector<vtkRelievoBox>& casters, const Request& request, vtkRelievoShadowView& view)
{
  std::vector<glm::dvec2> flat;
  double farthest = -1e300;
  double nearest = 1e300;
  for (const glm::dvec3& point : world)
  {
    const glm::dvec3 p = frame.Map(point);
    const double w = parallel ? 1.0 : p.z;
    flat.emplace_back(p.x / w, p.y / w);
    farthest = std::max(farthest, p.z);
    nearest = std::min(nearest, p.z);
  }
  if (flat.empty())
  {
    return false;
  }
  vtkRelievoShadowRegion::Rectangle rectangle = vtkRelievoShadowRegion::Enclose(flat);
  const glm::dvec2 along(glm::dot(request.Gaze, frame.Right), glm::dot(request.Gaze, frame.Up));
  const bool warp = request.Warp && parallel && glm::length(along) > 0.2;
  if (warp)
  {
    rectangle = vtkRelievoShadowRegion::EncloseAt(flat, std::atan2(along.y, along.x));
  }
  Widen(rectangle, request);
  const double c = std::cos(rectangle.Angle);
  const double s = std::sin(rectangle.Angle);
  const glm::dvec3 right = frame.Right * c + frame.Up * s;
  view.Forward = frame.Forward;
  view.Up = frame.Up * c - frame.Right * s;
  view.Position = frame.Origin;
  view.Parallel = parallel;
  view.Points = world;
  view.WorldToView = LookAlong(view.Position, view.Forward, right, view.Up);
  // First with a depth range that holds everything, to see what casts.
  view.Far = farthest + 1e-3 * (farthest - nearest) + 1e-6 * std::abs(farthest);
  view.Near = parallel ? nearest : NearestShare * view.Far;
  if (view.Far <= view.Near)
  {
    view.Far = view.Near + 1e-6 * std::max(1e-12, std::abs(view.Near));
  }
  glm::dmat4 shear(1.0);
  shear[2].x = c * frame.Shear.x + s * frame.Shear.y;
  shear[2].y = c * frame.Shear.y - s * frame.Shear.x;
  view.ViewToNDC = Project(rectangle, parallel, view.Near, view.Far) * shear;
  double first = 1e300;
  for (const vtkRelievoBox& box : casters)
  {
    if (!view.Sees(box))
    {
      continue;
    }
    for (const glm::dvec3& corner : box.GetCorners())
    {
      first = std::min(first, frame.Map(corner).z);
    }
  }
  if (first >= view.Far)
  {
    return false;
  }
  const glm::dvec2 size = rectangle.Max - rectangle.Min;
  const double texel = std::max(size.x, size.y) / request.Size;
  // Room for a few texels' bias on both sides, and for the wider texels of a warped map.
  const double room = 8.0 * texel * (warp ? 8.0 : 1.0) * (parallel ? 1.0 : view.Far);
  view.Far += parallel ? room : 0.0;
  const double before = std::max(1e-3 * (view.Far - std::max(first, nearest)), room);
  // Nothing is looked up before the region: casters there are drawn onto the near plane, and a far
  // one does not take the digits of the others.
  view.Near = parallel ? std::max(first, nearest) - before
                       : std::max(first - before, NearestShare * view.Far);
  view.ViewToNDC = Project(rectangle, parallel, view.Near, view.Far) * shear;
  view.NearCut = parallel && nearest > first;
  view.Width = size.x;
  view.Height = size.y;
  // Along an oblique ray a texel's width is less of the map's depth.
  const double oblique = 1.0 / std::sqrt(1.0 + glm::dot(frame.Shear, frame.Shear));
  view.Texel = parallel ? oblique * texel / (view.Far - view.Near)
                        : texel * view.Far * view.Near / (view.Far - view.Near);
  if (warp)
  {
    const glm::dmat4 worldToNDC = view.ViewToNDC * view.WorldToView;
    std::vector<glm::dvec2> places;
    for (const glm::dvec3& point : world)
    {
      places.push_back(0.5 + 0.5 * glm::dvec2(worldToNDC * glm::dvec4(point, 1.0)));
    }
    SetWarp(view, world, places, request);
  }
  return true;
}

std::vector<glm::dvec3> GetPoints(const std::vector<Polygon>& region)
{
  std::vector<glm::dvec3> points;
  for (const Polygon& polygon : region)
  {
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  return points;
}

// What of the region is within the pyramid of the frame.
std::vector<glm::dvec3> GetPointsWithin(
  const std::vector<Polygon>& region, const Frame& frame, double tangent, double nearest)
{
  std::vector<glm::dvec3> points;
  for (Polygon polygon : region)
  {
    for (const glm::dvec4& plane : { frame.GetPlane(0, 0, 1) - glm::dvec4(0, 0, 0, nearest),
           frame.GetPlane(1, 0, tangent), frame.GetPlane(-1, 0, tangent),
           frame.GetPlane(0, 1, tangent), frame.GetPlane(0, -1, tangent) })
    {
      polygon = vtkRelievoShadowRegion::Clip(polygon, plane);
    }
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  return points;
}

// The axis of a cone that holds all points; the tangent of its half angle, or -1 beyond 90 degrees.
double GetCone(const glm::dvec3& tip, const std::vector<glm::dvec3>& points, glm::dvec3& axis)
{
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  std::vector<glm::dvec3> directions;
  for (const glm::dvec3& point : points)
  {
    const double distance = glm::length(point - tip);
    if (distance > 0.0)
    {
      directions.push_back((point - tip) / distance);
      low = glm::min(low, directions.back());
      high = glm::max(high, directions.back());
    }
  }
  axis = 0.5 * (low + high);
  const double length = directions.empty() ? 0.0 : glm::length(axis);
  if (length < 1e-3)
  {
    return -1.0;
  }
  axis /= length;
  double cosine = 1.0;
  for (const glm::dvec3& direction : directions)
  {
    cosine = std::min(cosine, glm::dot(direction, axis));
  }
  return cosine <= 1e-3 ? -1.0 : std::sqrt(1.0 - std::min(1.0, cosine * cosine)) / cosine;
}
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoShadowView> vtkRelievoShadowFit::Fit(const vtkRelievoShadowLight& light,
  const std::vector<Polygon>& region, const std::vector<vtkRelievoBox>& casters,
  const Request& request)
{
  std::vector<vtkRelievoShadowView> views;
  vtkRelievoShadowView view;
  const std::vector<glm::dvec3> points = GetPoints(region);
  if (points.empty())
  {
    return views;
  }
  if (!light.Positional)
  {
    // The origin of a sun's view is near what it sees, so that no digits are lost far away.
    const Frame frame = request.Warp
      ? MakeGroundFrame(points.front(), light.Direction, request.ViewUp)
      : Frame(points.front(), light.Direction, AnySquareTo(light.Direction));
    if (MakeView(frame, true, points, casters, request, view))
    {
      views.push_back(view);
    }
    return views;
  }
  double reach = 0.0;
  for (const glm::dvec3& point : points)
  {
    reach = std::max(reach, glm::length(point - light.Position));
  }
  const double nearest = NearestShare * reach;
  const double cone =
    light.IsSpot() ? std::tan(vtkMath::RadiansFromDegrees(light.ConeAngle)) : -1.0;
  glm::dvec3 axis(0.0);
  double tangent = GetCone(light.Position, points, axis);
  if (cone > 0.0 && cone <= WidestTangent)
  {
    axis = light.Direction;
    tangent = cone;
  }
  if (tangent >= 0.0 && tangent <= WidestTangent)
  {
    const Frame frame(light.Position, axis, AnySquareTo(axis));
    // A little more than the cone: its rim is computed in float.
    const double opening = 1.001 * std::max(tangent, 1e-4);
    if (MakeView(
          frame, false, GetPointsWithin(region, frame, opening, nearest), casters, request, view))
    {
      views.push_back(view);
    }
    return views;
  }
  const glm::dvec3 first = light.IsSpot() ? light.Direction : glm::dvec3(0, 0, -1);
  const glm::dvec3 second = AnySquareTo(first);
  const glm::dvec3 third = glm::cross(first, second);
  const glm::dvec3 sides[6] = { first, second, -second, third, -third, -first };
  for (int side = 0; side < 6; ++side)
  {
    if (light.IsSpot() && side == 5)
    {
      continue; // behind the lamp
    }
    const bool alongFirst = side == 0 || side == 5;
    const Frame frame(light.Position, sides[side], alongFirst ? second : first);
    view = vtkRelievoShadowView();
    view.Side = side;
    if (MakeView(frame, false, GetPointsWithin(region, frame, CubeTangent, nearest), casters,
          request, view))
    {
      views.push_back(view);
    }
  }
  return views;
}
