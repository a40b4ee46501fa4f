// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A ray in double precision, and its hit with a triangle (S. Woop, C. Benthin, I. Wald, Watertight
// ray/triangle intersection, 2013).
#ifndef vtkRelievoRay_h
#define vtkRelievoRay_h

#include "vtkRelievoFormulas.h" // for GLM

struct vtkRelievoRay
{
  glm::dvec3 From;
  glm::dvec3 Ray;
  int X = 0;
  int Y = 1;
  int Z = 2;
  glm::dvec3 Shear{ 0.0 };

  vtkRelievoRay(const glm::dvec3& from, const glm::dvec3& ray)
    : From(from)
    , Ray(ray)
  {
    const glm::dvec3 size = glm::abs(ray);
    this->Z = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    this->X = this->Z == 2 ? 0 : this->Z + 1;
    this->Y = this->X == 2 ? 0 : this->X + 1;
    const double inverse = 1.0 / ray[this->Z];
    this->Shear = glm::dvec3(ray[this->X] * inverse, ray[this->Y] * inverse, inverse);
  }

  // Edges belong to the triangle: for both directions of an edge, side() is the same number with
  // opposite signs. This requires products without fusing (-ffp-contract=off).
  bool Hits(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double& t,
    glm::dvec3& sides) const
  {
    const glm::dvec3 p = this->Place(a);
    const glm::dvec3 q = this->Place(b);
    const glm::dvec3 r = this->Place(c);
    const double u = GetSide(q, r);
    const double v = GetSide(r, p);
    const double w = GetSide(p, q);
    // Without branches, which would be unpredictable.
    const int below =
      static_cast<int>(u < 0.0) | static_cast<int>(v < 0.0) | static_cast<int>(w < 0.0);
    const int above =
      static_cast<int>(u > 0.0) | static_cast<int>(v > 0.0) | static_cast<int>(w > 0.0);
    const double sum = u + v + w;
    if (below == above || sum == 0.0) // outside, or seen edge-on
    {
      return false;
    }
    sides = glm::dvec3(u, v, w);
    t = (u * p.z + v * q.z + w * r.z) * this->Shear.z / sum;
    return true;
  }

  // Whether the triangle, which the ray hits, owns the hit at a shared edge: exactly one of the
  // triangles on the edge's two sides does, as if the ray were moved infinitesimally along y, and
  // infinitesimally less against x.
  bool Owns(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const
  {
    const glm::dvec3 p = this->Place(a);
    const glm::dvec3 q = this->Place(b);
    const glm::dvec3 r = this->Place(c);
    const bool side = IsRight(q, r);
    return side == IsRight(r, p) && side == IsRight(p, q);
  }

private:
  // Sheared so that the ray is the z axis; z is not yet divided.
  glm::dvec3 Place(const glm::dvec3& corner) const
  {
    const glm::dvec3 p = corner - this->From;
    const double z = p[this->Z];
    return glm::dvec3(p[this->X] - this->Shear.x * z, p[this->Y] - this->Shear.y * z, z);
  }
  static double GetSide(const glm::dvec3& from, const glm::dvec3& to)
  {
    return to.x * from.y - from.x * to.y;
  }
  static bool IsRight(const glm::dvec3& from, const glm::dvec3& to)
  {
    const double left = -GetSide(from, to);
    const bool turned = from.x > to.x || (from.x == to.x && from.y > to.y);
    return left < 0.0 || (left == 0.0 && turned);
  }
};

#endif
