// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Surfaces.h
 * @brief Triangle meshes of surfaces with known normals and tangents.
 */
#ifndef relievoTestSurfaces_h
#define relievoTestSurfaces_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>

#include <functional>

namespace relievoTest
{
/** Position, unit normal, and unit tangent along growing u at a place (u, v). */
struct SurfacePoint
{
  glm::dvec3 Position;
  glm::dvec3 Normal;
  glm::dvec3 Tangent;
};
using Surface = std::function<SurfacePoint(double u, double v)>;

/** z = 0, u along x. */
SurfacePoint PlanePoint(double u, double v);
/** Radius 1, u once around z from +x, v from -z (0) to +z (1). */
SurfacePoint SpherePoint(double u, double v);
/** Radii 1 and 0.4 about z; u around the axis, v around the ring. */
SurfacePoint TorusPoint(double u, double v);

/**
 * (columns + 1) x (rows + 1) points over u and v in [0, 1], two triangles a cell, with float arrays
 * "Normals" (active), "TCoords" (active) and "truth" (the tangent). Cells without area at a pole
 * are one triangle.
 */
vtkSmartPointer<vtkPolyData> MakeSurface(const Surface& surface, int columns, int rows);
}

#endif
