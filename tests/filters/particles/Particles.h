// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Particles.h
 * @brief Shared by the tests of particles: their positions, and their distance to a surface.
 */
#ifndef relievoTestParticles_h
#define relievoTestParticles_h

#include <vtkPolyData.h>

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

class vtkRelievoSurfaceParticles;

namespace relievoTest
{
using Places = std::vector<glm::dvec3>;

/** The particles at a time, which the filter must make. */
Places PlacesAt(vtkRelievoSurfaceParticles* filter, double time);

/** The largest distance to the mesh's nearest point, by vtkStaticCellLocator. */
double LargestDistance(const Places& places, vtkPolyData* mesh);

/** The mesh with the point array `field` (double), of which each point has its value. */
vtkSmartPointer<vtkPolyData> WithField(
  vtkPolyData* mesh, const std::function<glm::dvec3(const glm::dvec3&)>& field);

/** A copy moved in double. */
vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, const glm::dvec3& by);

/** A square of triangles in z = 0, from -1 to 1, so many cells each way. */
vtkSmartPointer<vtkPolyData> Sheet(int cells = 4);
}

#endif
