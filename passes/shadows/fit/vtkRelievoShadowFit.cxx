// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowFit.h"

#include "vtkMath.h"
#include "vtkRelievoLightSpace.h"
#include "vtkRelievoShadowLight.h"
#include "vtkRelievoShadowSnapping.h"

#include <algorithm>
#include <cmath>

namespace
{
using Frame = vtkRelievoLightSpace;
using vtkRelievoShadowFit::Request;
using vtkRelievoShadowRegion::GetPoints;
using vtkRelievoShadowRegion::Polygon;
using vtkRelievoShadowSnapping::Rounding;

// Tangent of half the opening up to which a lamp uses a single perspective map; beyond it, texels
// at the rim are too small for their cost.
constexpr double WidestTangent = 1.43; // 55 degrees
// Overlap of a cube's sides over their edges, for the filter.
constexpr double CubeTangent = 1.01;

// Margin as a share of the casters' width, because they are drawn in float.
constexpr double ShadowMargin = 1e-5;
// Tangent of half the opening of the cone from a lamp around the casters.
constexpr double WidestShadow = 5.0;

// Whether the box is flat, and all receivers are on the lit side of it.
bool CastsNothing(const vtkRelievoBox& box, const vtkRelievoShadowLight& light,
  const std::vector<vtkRelievoBox>& receivers)
{
  const glm::dvec3 size = box.Max - box.Min;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double lightSide =
      light.Positional ? light.Position[axis] - box.Min[axis] : -light.Direction[axis];
    const double slack = Rounding * glm::length(size);
    const bool above = lightSide > 0.0;
    if (size[axis] <= slack && std::abs(lightSide) > (light.Positional ? slack : Rounding) &&
      std::all_of(receivers.begin(), receivers.end(), [&](const vtkRelievoBox& receiver) {
        return above ? receiver.Min[axis] >= box.Max[axis] - slack
                     : receiver.Max[axis] <= box.Min[axis] + slack;
      }))
    {
      return true;
    }
  }
  return false;
}

// The part of the region within the frame's pyramid.
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

// Points, and the corners of the cones from them to a sun's parts, as far as there may be casters:
// for a map shared by these parts.
std::vector<glm::dvec3> SpreadOut(const std::vector<glm::dvec3>& points,
  const vtkRelievoShadowLight::Center& light, const std::vector<vtkRelievoBox>& casters)
{
  double top = -1e300;
  for (const vtkRelievoBox& box : casters)
  {
    for (const glm::dvec3& corner : box.GetCorners())
    {
      top = std::max(top, -glm::dot(corner, light.Direction));
    }
  }
  const glm::dvec3 right = vtkRelievoShadowLight::AnySquareTo(light.Direction);
  const glm::dvec3 up = glm::cross(light.Direction, right);
  std::vector<glm::dvec3> all = points;
  for (const glm::dvec3& point : points)
  {
    const double height = top + glm::dot(point, light.Direction);
    for (int side = 0; side < 4 && height > 0.0; ++side)
    {
      // A square around the disc.
      const glm::dvec3 off = ((side & 1) != 0 ? right : -right) + ((side & 2) != 0 ? up : -up);
      all.push_back(point + height * (light.Spread * off - light.Direction));
    }
  }
  return all;
}

double GetReach(const glm::dvec3& place, const std::vector<glm::dvec3>& points)
{
  double reach = 0.0;
  for (const glm::dvec3& point : points)
  {
    reach = std::max(reach, glm::length(point - place));
  }
  return reach;
}

// The tangent of half the opening of the cone about the axis around all points; -1 from 90 degrees
// on.
double GetTangent(
  const glm::dvec3& tip, const glm::dvec3& axis, const std::vector<glm::dvec3>& points)
{
  double cosine = 1.0;
  for (const glm::dvec3& point : points)
  {
    const double distance = glm::length(point - tip);
    cosine = distance > 0.0 ? std::min(cosine, glm::dot(point - tip, axis) / distance) : cosine;
  }
  return cosine <= 1e-3 ? -1.0 : std::sqrt(1.0 - cosine * cosine) / cosine;
}

// The mean of the points' directions; zero if they surround the light.
glm::dvec3 GetAxis(const glm::dvec3& tip, const std::vector<glm::dvec3>& points)
{
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (const glm::dvec3& point : points)
  {
    const double distance = glm::length(point - tip);
    if (distance > 0.0)
    {
      low = glm::min(low, (point - tip) / distance);
      high = glm::max(high, (point - tip) / distance);
    }
  }
  const glm::dvec3 axis = 0.5 * (low + high);
  const double length = glm::length(axis);
  return length > 1e-3 && low.x <= high.x ? axis / length : glm::dvec3(0.0);
}

// A single perspective map, if it can cover the visible region.
struct Cone
{
  glm::dvec3 Axis{ 0.0 };
  double Tangent = -1.0;

  bool IsNarrow() const { return this->Tangent >= 0.0 && this->Tangent <= WidestTangent; }

  // A margin, because the rim is computed in float.
  double GetOpening() const { return 1.001 * std::max(this->Tangent, 1e-4); }
};

Cone GetCone(const glm::dvec3& tip, const glm::dvec3& axis, const std::vector<glm::dvec3>& points)
{
  Cone cone;
  if (axis != glm::dvec3(0.0))
  {
    cone.Axis = axis;
    cone.Tangent = GetTangent(tip, axis, points);
  }
  return cone;
}

// A lamp's maps for the whole visible region.
Cone GetWholeCone(const vtkRelievoShadowLight& light, const std::vector<glm::dvec3>& all)
{
  const double tangent =
    light.IsSpot() ? std::tan(vtkMath::RadiansFromDegrees(light.ConeAngle)) : -1.0;
  if (tangent > 0.0 && tangent <= WidestTangent)
  {
    Cone cone;
    cone.Axis = light.Direction;
    cone.Tangent = tangent;
    return cone;
  }
  return GetCone(light.Position, GetAxis(light.Position, all), all);
}
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> vtkRelievoShadowFit::GetShadowPlanes(const vtkRelievoShadowLight& light,
  const std::vector<vtkRelievoBox>& casters, const std::vector<vtkRelievoBox>& receivers)
{
  std::vector<glm::dvec4> planes;
  std::vector<glm::dvec3> corners;
  for (const vtkRelievoBox& box : casters)
  {
    if (CastsNothing(box, light, receivers))
    {
      continue;
    }
    if (box.Loose)
    {
      return planes;
    }
    const auto own = box.GetCorners();
    corners.insert(corners.end(), own.begin(), own.end());
  }
  if (corners.empty())
  {
    return planes;
  }
  const glm::dvec3 axis = light.Positional ? GetAxis(light.Position, corners) : light.Direction;
  const double tangent = light.Positional ? GetCone(light.Position, axis, corners).Tangent : 0.0;
  if (tangent < 0.0 || tangent > WidestShadow)
  {
    return planes; // the casters surround the lamp
  }
  const Frame frame(light.Positional ? light.Position : corners.front(), axis);
  std::vector<glm::dvec2> places;
  double width = 0.0;
  // Parts of a sun's disc see places beside those seen from its centre.
  double low = 1e300;
  double high = -1e300;
  for (const vtkRelievoBox& box : light.Spread > 0.0 ? receivers : std::vector<vtkRelievoBox>())
  {
    for (const glm::dvec3& corner : box.GetCorners())
    {
      high = std::max(high, frame.Map(corner).z);
    }
  }
  for (const glm::dvec3& corner : corners)
  {
    low = std::min(low, frame.Map(corner).z);
  }
  const double beside = light.Spread * std::max(0.0, high - low);
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec3 place = frame.Map(corner);
    places.emplace_back(glm::dvec2(place) / (light.Positional ? place.z : 1.0));
    width = std::max(width, glm::length(places.back() - places.front()));
  }
  const std::vector<glm::dvec2> hull = vtkRelievoShadowRegion::GetHull(std::move(places));
  for (std::size_t i = 0; hull.size() > 2 && i < hull.size(); ++i)
  {
    const glm::dvec2 along = glm::normalize(hull[(i + 1) % hull.size()] - hull[i]);
    const glm::dvec2 inwards(-along.y, along.x);
    const double from = ShadowMargin * width + beside - glm::dot(inwards, hull[i]);
    planes.push_back(frame.GetPlane(inwards.x, inwards.y, light.Positional ? from : 0.0));
    planes.back().w += light.Positional ? 0.0 : from;
  }
  return planes;
}

//------------------------------------------------------------------------------
bool vtkRelievoShadowFit::IsCube(
  const vtkRelievoShadowLight& light, const std::vector<Polygon>& scene)
{
  return light.Positional && !GetWholeCone(light, GetPoints(scene)).IsNarrow();
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoShadowView> vtkRelievoShadowFit::Fit(const vtkRelievoShadowLight& light,
  const std::vector<Polygon>& visible, const std::vector<Polygon>& scene,
  const std::vector<vtkRelievoBox>& casters, const Request& request)
{
  std::vector<vtkRelievoShadowView> views;
  vtkRelievoShadowView view;
  const std::vector<glm::dvec3> points = GetPoints(visible);
  const std::vector<glm::dvec3> all = GetPoints(scene);
  if (points.empty() || all.empty())
  {
    return views;
  }
  if (!light.Positional)
  {
    const Frame frame(vtkRelievoShadowRegion::GetMiddle(scene), light.Direction);
    for (const vtkRelievoShadowLight::Center& center : light.Centers)
    {
      const Frame own(vtkRelievoShadowRegion::GetMiddle(scene), center.Direction);
      if (!own.Fit(true, SpreadOut(points, center, casters), SpreadOut(all, center, casters),
            casters, request, view))
      {
        return {}; // nor does anything cast for the other sides
      }
      views.push_back(view);
    }
    if (light.Centers.empty() && frame.Fit(true, points, all, casters, request, view))
    {
      views.push_back(view);
    }
    return views;
  }
  const glm::dvec3& place = light.Position;
  const double nearest = Frame::NearestShare *
    vtkRelievoShadowSnapping::Up(GetReach(place, points), GetReach(place, all), 2);
  auto add = [&](const Frame& frame, double tangent) {
    if (frame.Fit(false, GetPointsWithin(visible, frame, tangent, nearest),
          GetPointsWithin(scene, frame, tangent, nearest), casters, request, view))
    {
      views.push_back(view);
    }
  };
  Cone cone = GetWholeCone(light, all);
  if (!cone.IsNarrow())
  {
    const glm::dvec3 axis = GetAxis(place, points);
    cone = axis == glm::dvec3(0.0)
      ? cone
      : GetCone(place, vtkRelievoShadowSnapping::Direction(axis), points);
    cone.Tangent = cone.IsNarrow() ? WidestTangent : -1.0;
  }
  if (cone.IsNarrow())
  {
    add(Frame(place, cone.Axis), cone.GetOpening());
    return views;
  }
  const glm::dvec3 first = light.IsSpot() ? light.Direction : glm::dvec3(0, 0, -1);
  const glm::dvec3 second = vtkRelievoShadowLight::AnySquareTo(first);
  const glm::dvec3 third = glm::cross(first, second);
  const glm::dvec3 sides[6] = { first, second, -second, third, -third, -first };
  for (int side = 0; side < 6; ++side)
  {
    if (light.IsSpot() && side == 5)
    {
      continue; // behind the lamp
    }
    const bool alongFirst = side == 0 || side == 5;
    view = vtkRelievoShadowView();
    view.Side = side;
    add(Frame(place, sides[side], alongFirst ? second : first), CubeTangent);
  }
  return views;
}
