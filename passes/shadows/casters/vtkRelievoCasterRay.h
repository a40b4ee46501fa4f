// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A ray in double precision, and whether it meets a box or a triangle.
#ifndef vtkRelievoCasterRay_h
#define vtkRelievoCasterRay_h

#include "vtkRelievoBoxTree.h"

#include <algorithm>
#include <cmath>

// A ray as boxes and triangles are asked for it (S. Woop, C. Benthin, I. Wald, Watertight
// ray/triangle intersection, 2013).
struct vtkRelievoCasterRay
{
  glm::dvec3 From;
  glm::dvec3 Inverse;
  int X = 0;
  int Y = 1;
  int Z = 2;
  glm::dvec3 Shear{ 0.0 };

  vtkRelievoCasterRay(const glm::dvec3& from, const glm::dvec3& ray)
    : From(from)
  {
    const glm::dvec3 size = glm::abs(ray);
    this->Z = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    this->X = (this->Z + 1) % 3;
    this->Y = (this->Z + 2) % 3;
    this->Shear =
      glm::dvec3(ray[this->X] / ray[this->Z], ray[this->Y] / ray[this->Z], 1.0 / ray[this->Z]);
    for (int i = 0; i < 3; ++i)
    {
      this->Inverse[i] = std::abs(ray[i]) > 1e-290 ? 1.0 / ray[i] : std::copysign(1e290, ray[i]);
    }
  }

  bool Meets(const vtkRelievoBoxTree::Node& node, double low, double high) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const double a = (static_cast<double>(node.Low[i]) - this->From[i]) * this->Inverse[i];
      const double b = (static_cast<double>(node.High[i]) - this->From[i]) * this->Inverse[i];
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    }
    return low <= high;
  }

  // Edges belong to the triangle. `owns`: those that are shared belong to one of the triangles on
  // both of their sides, as if the ray were moved by next to nothing along y, and by next to
  // nothing of that against x.
  bool Meets(const glm::dvec3* corners, double& t, bool& owns) const
  {
    double x[3];
    double y[3];
    double z[3];
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 p = corners[i] - this->From;
      x[i] = p[this->X] - this->Shear.x * p[this->Z];
      y[i] = p[this->Y] - this->Shear.y * p[this->Z];
      z[i] = p[this->Z] * this->Shear.z;
    }
    bool right[3];
    const auto side = [&](int from, int to, int edge) {
      // Of both directions of an edge the same number, with another sign.
      const bool turned = x[from] > x[to] || (x[from] == x[to] && y[from] > y[to]);
      const int p = turned ? to : from;
      const int q = turned ? from : to;
      const double left = x[p] * y[q] - y[p] * x[q];
      right[edge] = (left < 0.0) != turned;
      return turned ? left : -left;
    };
    const double u = side(1, 2, 0);
    const double v = side(2, 0, 1);
    const double w = side(0, 1, 2);
    const double sum = u + v + w;
    owns = right[0] == right[1] && right[0] == right[2];
    if ((std::min({ u, v, w }) < 0.0 && std::max({ u, v, w }) > 0.0) || sum == 0.0)
    {
      return false;
    }
    t = (u * z[0] + v * z[1] + w * z[2]) / sum;
    return true;
  }
};

#endif
