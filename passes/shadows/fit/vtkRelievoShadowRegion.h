// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The region with visible shadows: the boxes of the receivers, cut by the camera's frustum, as
// convex polygons in world coordinates.
#ifndef vtkRelievoShadowRegion_h
#define vtkRelievoShadowRegion_h

#include "vtkRelievoBox.h"

#include <vector>

namespace vtkRelievoShadowRegion
{
using Polygon = std::vector<glm::dvec3>;

// A plane keeps the points with dot(plane.xyz, p) + plane.w >= 0.
Polygon Clip(const Polygon& polygon, const glm::dvec4& plane);

// The surface of each box.
std::vector<Polygon> GetFaces(const std::vector<vtkRelievoBox>& boxes);

// The surface of each box cut by the frustum of worldToNDC (without a separate far plane).
std::vector<Polygon> Cut(const std::vector<vtkRelievoBox>& boxes, const glm::dmat4& worldToNDC);

// The parts within all planes.
std::vector<Polygon> Clip(std::vector<Polygon> polygons, const std::vector<glm::dvec4>& planes);

// The corners of all polygons.
std::vector<glm::dvec3> GetPoints(const std::vector<Polygon>& polygons);

// The centre of the polygons' extent.
glm::dvec3 GetMiddle(const std::vector<Polygon>& polygons);

// A rectangle of the plane, its axes turned by Angle.
struct Rectangle
{
  double Angle = 0.0;
  glm::dvec2 Min{ 0.0 };
  glm::dvec2 Max{ 0.0 };

  // The sum of both sides: a map has equally many texels along either, so that the error of edges,
  // in any direction, is proportional to it.
  double GetLength() const { return this->Max.x - this->Min.x + this->Max.y - this->Min.y; }
};
// The smallest rectangle around points; among rectangles equal but for rounding, always at the same
// angle.
Rectangle Enclose(const std::vector<glm::dvec2>& points);
Rectangle EncloseAt(const std::vector<glm::dvec2>& points, double angle);

// The convex hull, counter-clockwise.
std::vector<glm::dvec2> GetHull(std::vector<glm::dvec2> points);
}

#endif
