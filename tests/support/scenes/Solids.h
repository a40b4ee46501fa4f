// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Solids.h
 * @brief Closed bodies with a known inside: turned about z, tilted, as triangles.
 */
#ifndef relievoTestSolids_h
#define relievoTestSolids_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <vector>

namespace relievoTest
{
struct Solid
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Mesh; // points in double, closed
  /** Distance to the surface, negative inside; far away, a lower bound. */
  std::function<double(const glm::dvec3&)> DistanceAt;
  double Volume = 0.;
  /** Upper bound of the distance between the triangles and the true surface. */
  double Chord = 0.;
};

/** A rotation about the axis by an angle in degrees. */
glm::dmat3 Turn(const glm::dvec3& axis, double degrees);

/** The profile (distance from z, z), closed or from z to z, turned about z in so many steps. */
vtkSmartPointer<vtkPolyData> Lathe(const std::vector<glm::dvec2>& profile, bool closed, int steps,
  const glm::dmat3& rotation = glm::dmat3(1.));

/** `chord`: largest allowed distance of triangles from the true surface. */
Solid MakeBall(double chord = 1e-3, const glm::dmat3& rotation = glm::dmat3(1.));
Solid MakeTorus(double chord = 1e-3, const glm::dmat3& rotation = glm::dmat3(1.));
/** A ball of radius 1 with a hollow of 0.5. */
Solid MakeHollowBall(double chord = 1e-3, const glm::dmat3& rotation = glm::dmat3(1.));
/** Half of a hollow ball of radii 1 and 0.8, open towards z. */
Solid MakeBowl(double chord = 1e-3, const glm::dmat3& rotation = glm::dmat3(1.));
/** Half sides 0.9, 0.6 and 0.4. */
Solid MakeBox(const glm::dmat3& rotation = glm::dmat3(1.));
}

#endif
