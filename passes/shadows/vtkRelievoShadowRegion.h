// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where shadows can be seen: the boxes of what receives them, cut by the camera's frustum, as
// convex polygons in world coordinates.
#ifndef vtkRelievoShadowRegion_h
#define vtkRelievoShadowRegion_h

#include "vtkRelievoFormulas.h" // for GLM

#include <array>
#include <vector>

struct vtkRelievoBox
{
  glm::dvec3 Min;
  glm::dvec3 Max;

  std::array<glm::dvec3, 8> GetCorners() const;
};

namespace vtkRelievoShadowRegion
{
using Polygon = std::vector<glm::dvec3>;

// A plane keeps the points with dot(plane.xyz, p) + plane.w >= 0.
Polygon Clip(const Polygon& polygon, const glm::dvec4& plane);

// The surface of each box cut by the frustum of worldToNDC (no far plane beyond it, as the camera
// has it).
std::vector<Polygon> Cut(const std::vector<vtkRelievoBox>& boxes, const glm::dmat4& worldToNDC);

// A rectangle around points of the plane, of about the least area: axis turned by Angle.
struct Rectangle
{
  double Angle = 0.0;
  glm::dvec2 Min{ 0.0 };
  glm::dvec2 Max{ 0.0 };

  double GetArea() const { return (this->Max.x - this->Min.x) * (this->Max.y - this->Min.y); }
};
Rectangle Enclose(std::vector<glm::dvec2> points);
Rectangle EncloseAt(const std::vector<glm::dvec2>& points, double angle);
}

#endif
