// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowRegion.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
using vtkRelievoShadowRegion::Polygon;

constexpr int Faces[6][4] = { { 0, 2, 6, 4 }, { 1, 5, 7, 3 }, { 0, 4, 5, 1 }, { 2, 3, 7, 6 },
  { 0, 1, 3, 2 }, { 4, 6, 7, 5 } };

std::vector<glm::dvec4> GetFrustumPlanes(const glm::dmat4& worldToNDC)
{
  const glm::dmat4 rows = glm::transpose(worldToNDC);
  return { rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1],
    rows[3] + rows[2], rows[3] - rows[2] };
}

std::vector<glm::dvec4> GetBoxPlanes(const vtkRelievoBox& box)
{
  return { glm::dvec4(1, 0, 0, -box.Min.x), glm::dvec4(-1, 0, 0, box.Max.x),
    glm::dvec4(0, 1, 0, -box.Min.y), glm::dvec4(0, -1, 0, box.Max.y),
    glm::dvec4(0, 0, 1, -box.Min.z), glm::dvec4(0, 0, -1, box.Max.z) };
}

// The faces of a hexahedron, with corners in the order of vtkRelievoBox::GetCorners, cut by planes.
void AddFaces(const std::array<glm::dvec3, 8>& corners, const std::vector<glm::dvec4>& planes,
  std::vector<Polygon>& polygons)
{
  for (const auto& face : Faces)
  {
    Polygon polygon;
    for (const int corner : face)
    {
      polygon.push_back(corners[corner]);
    }
    for (const glm::dvec4& plane : planes)
    {
      polygon = vtkRelievoShadowRegion::Clip(polygon, plane);
    }
    if (!polygon.empty())
    {
      polygons.push_back(polygon);
    }
  }
}

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

// Leaves out points that are clearly inside the octagon of the outermost ones in eight directions
// (S. G. Akl and G. T. Toussaint, A Fast Convex Hull Algorithm, 1978).
void LeaveOutInner(std::vector<glm::dvec2>& points)
{
  static const glm::dvec2 directions[8] = { { 1., 0. }, { 1., 1. }, { 0., 1. }, { -1., 1. },
    { -1., 0. }, { -1., -1. }, { 0., -1. }, { 1., -1. } };
  glm::dvec2 outer[8]; // counterclockwise
  for (int i = 0; i < 8; ++i)
  {
    outer[i] = *std::max_element(
      points.begin(), points.end(), [&](const glm::dvec2& one, const glm::dvec2& other) {
        return glm::dot(directions[i], one) < glm::dot(directions[i], other);
      });
  }
  const glm::dvec2 size(outer[0].x - outer[4].x, outer[2].y - outer[6].y);
  const double margin = 1e-9 * glm::dot(size, size);
  const auto isInner = [&](const glm::dvec2& point) {
    bool inner = size.x > 0. && size.y > 0.;
    for (int i = 0; inner && i < 8; ++i)
    {
      const glm::dvec2 along = outer[(i + 1) % 8] - outer[i];
      inner = along == glm::dvec2(0.) || Cross(along, point - outer[i]) > margin;
    }
    return inner;
  };
  points.erase(std::remove_if(points.begin(), points.end(), isInner), points.end());
}
}

//------------------------------------------------------------------------------
Polygon vtkRelievoShadowRegion::Clip(const Polygon& polygon, const glm::dvec4& plane)
{
  // Clips by the method of Sutherland and Hodgman (1974).
  Polygon kept;
  auto side = [&plane](const glm::dvec3& p) { return glm::dot(glm::dvec3(plane), p) + plane.w; };
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3& from = polygon[i];
    const glm::dvec3& to = polygon[(i + 1) % polygon.size()];
    const double a = side(from);
    const double b = side(to);
    if (a >= 0.0)
    {
      kept.push_back(from);
    }
    if ((a >= 0.0) != (b >= 0.0))
    {
      kept.push_back(from + (to - from) * (a / (a - b)));
    }
  }
  return kept;
}

//------------------------------------------------------------------------------
std::vector<Polygon> vtkRelievoShadowRegion::Clip(
  std::vector<Polygon> polygons, const std::vector<glm::dvec4>& planes)
{
  for (const glm::dvec4& plane : planes)
  {
    for (Polygon& polygon : polygons)
    {
      polygon = Clip(polygon, plane);
    }
  }
  polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                   [](const Polygon& polygon) { return polygon.empty(); }),
    polygons.end());
  return polygons;
}

//------------------------------------------------------------------------------
std::vector<Polygon> vtkRelievoShadowRegion::GetFaces(const std::vector<vtkRelievoBox>& boxes)
{
  std::vector<Polygon> polygons;
  for (const vtkRelievoBox& box : boxes)
  {
    AddFaces(box.GetCorners(), {}, polygons);
  }
  return polygons;
}

//------------------------------------------------------------------------------
std::vector<Polygon> vtkRelievoShadowRegion::Cut(
  const std::vector<vtkRelievoBox>& boxes, const glm::dmat4& worldToNDC)
{
  std::array<glm::dvec3, 8> frustum;
  const glm::dmat4 ndcToWorld = glm::inverse(worldToNDC);
  const std::array<glm::dvec3, 8> cube =
    vtkRelievoBox{ glm::dvec3(-1.0), glm::dvec3(1.0) }.GetCorners();
  std::transform(cube.begin(), cube.end(), frustum.begin(), [&ndcToWorld](const glm::dvec3& p) {
    const glm::dvec4 world = ndcToWorld * glm::dvec4(p, 1.0);
    return glm::dvec3(world) / world.w;
  });
  const std::vector<glm::dvec4> planes = GetFrustumPlanes(worldToNDC);
  std::vector<Polygon> polygons;
  for (const vtkRelievoBox& box : boxes)
  {
    const std::array<glm::dvec3, 8> corners = box.GetCorners();
    int cut = 0;
    bool outside = false;
    for (const glm::dvec4& plane : planes)
    {
      const auto beyond = std::count_if(corners.begin(), corners.end(),
        [&](const glm::dvec3& p) { return !(glm::dot(glm::dvec3(plane), p) + plane.w >= 0.0); });
      cut += beyond > 0 ? 1 : 0;
      outside = outside || beyond == 8;
    }
    if (outside)
    {
      continue;
    }
    // Of many small boxes, most are whole.
    AddFaces(corners, cut > 0 ? planes : std::vector<glm::dvec4>(), polygons);
    if (cut > 0)
    {
      AddFaces(frustum, GetBoxPlanes(box), polygons);
    }
  }
  return polygons;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> vtkRelievoShadowRegion::GetPoints(const std::vector<Polygon>& polygons)
{
  std::vector<glm::dvec3> points;
  for (const Polygon& polygon : polygons)
  {
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  return points;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoShadowRegion::GetMiddle(const std::vector<Polygon>& polygons)
{
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (const Polygon& polygon : polygons)
  {
    for (const glm::dvec3& point : polygon)
    {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  }
  return low.x <= high.x ? 0.5 * (low + high) : glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
vtkRelievoShadowRegion::Rectangle vtkRelievoShadowRegion::EncloseAt(
  const std::vector<glm::dvec2>& points, double angle)
{
  Rectangle rectangle;
  rectangle.Angle = angle;
  const glm::dvec2 x(std::cos(angle), std::sin(angle));
  const glm::dvec2 y(-x.y, x.x);
  rectangle.Min = glm::dvec2(1e300);
  rectangle.Max = glm::dvec2(-1e300);
  for (const glm::dvec2& point : points)
  {
    const glm::dvec2 turned(glm::dot(point, x), glm::dot(point, y));
    rectangle.Min = glm::min(rectangle.Min, turned);
    rectangle.Max = glm::max(rectangle.Max, turned);
  }
  return rectangle;
}

//------------------------------------------------------------------------------
// By Andrew's monotone chain (1979).
std::vector<glm::dvec2> vtkRelievoShadowRegion::GetHull(std::vector<glm::dvec2> points)
{
  constexpr std::size_t many = 64;
  if (points.size() > many)
  {
    LeaveOutInner(points);
  }
  std::sort(points.begin(), points.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
  {
    return points;
  }
  std::vector<glm::dvec2> hull;
  for (int side = 0; side < 2; ++side)
  {
    const std::size_t first = hull.size();
    for (const glm::dvec2& point : points)
    {
      while (hull.size() >= first + 2 &&
        Cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

//------------------------------------------------------------------------------
vtkRelievoShadowRegion::Rectangle vtkRelievoShadowRegion::Enclose(
  const std::vector<glm::dvec2>& points)
{
  const std::vector<glm::dvec2> hull = GetHull(points);
  // The smallest rectangle has a side along a side of the hull: between, its length is a sum of
  // sines of the angle, which is smallest at an end. Angles a quarter turn apart give equal
  // rectangles.
  const double quarter = 0.5 * vtkMath::Pi();
  constexpr double Rounding = 1e-6;
  Rectangle best;
  for (std::size_t i = 0; i < hull.size(); ++i)
  {
    const glm::dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
    double angle = std::atan2(edge.y, edge.x);
    angle -= quarter * std::floor(angle / quarter + Rounding);
    const Rectangle rectangle = EncloseAt(hull, angle);
    const double length = rectangle.GetLength();
    const double least = best.GetLength();
    if (i == 0 || length < (1.0 - Rounding) * least ||
      (length <= (1.0 + Rounding) * least && angle < best.Angle - Rounding))
    {
      best = rectangle;
    }
  }
  return best;
}
