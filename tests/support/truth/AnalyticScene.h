// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AnalyticScene.h
 * @brief Truth in closed form: planes, spheres, boxes and tori, in double precision.
 */
#ifndef relievoTestAnalyticScene_h
#define relievoTestAnalyticScene_h

#include "Truth.h"

#include <glm/gtc/matrix_transform.hpp>

#include <vector>

namespace relievoTest
{
/**
 * Shapes about their own origin, each placed by an invertible affine matrix (transposed against
 * vtkMatrix4x4: ToMatrix). The actor of a SurfacePoint is the index returned by Add.... Normals of
 * shapes with an inside point outwards before they are turned to the eye: FrontFacing is false
 * inside. A rectangle's front is its +z side.
 */
class AnalyticScene
{
public:
  /** The rectangle |x| <= halfX, |y| <= halfY in the plane z = 0; infinity is allowed. */
  int AddPlane(double halfX, double halfY, const glm::dmat4& place = glm::dmat4(1.));

  int AddSphere(double radius, const glm::dmat4& place = glm::dmat4(1.));

  /** The box from -half to +half. */
  int AddBox(const glm::dvec3& half, const glm::dmat4& place = glm::dmat4(1.));

  /** Around the z axis: circles of radius `tube` about a circle of radius `ring` in z = 0. */
  int AddTorus(double ring, double tube, const glm::dmat4& place = glm::dmat4(1.));

  /** First hit of a ray with t in [tMin, tMax]. */
  SurfacePoint Cast(const Ray& ray, double tMin, double tMax) const;

  /** Whether there is a hit with t in [tMin, tMax]. */
  bool Occluded(const Ray& ray, double tMin, double tMax) const;

  /** The truth for every pixel. */
  TruthImage Trace(const View& view) const;

  /** A matrix as VTK stores it (row by row, 16 values) for this class. */
  static glm::dmat4 ToMatrix(const double* rowMajor);

private:
  enum class Kind
  {
    Plane,
    Sphere,
    Box,
    Torus
  };
  struct Shape
  {
    Kind What;
    glm::dvec3 Size;
    glm::dmat4 ToWorld;
    glm::dmat4 ToLocal;
  };

  int Add(Kind what, const glm::dvec3& size, const glm::dmat4& place);
  static bool CastShape(
    const Shape& shape, const Ray& local, double tMin, double tMax, double& t, glm::dvec3& normal);

  std::vector<Shape> Shapes;
};

/**
 * Real roots of c[0] + c[1] t + ... + c[4] t^4 in [tMin, tMax], ascending, into `roots` (room for
 * 4); returns how many. Between the roots of the derivative, found the same way, a polynomial is
 * monotonous, so each root is bracketed and bisected down to neighbouring doubles. Roots where the
 * polynomial only touches zero may be missed. Infinite limits are not allowed.
 */
int QuarticRoots(const double c[5], double tMin, double tMax, double roots[4]);
}

#endif
