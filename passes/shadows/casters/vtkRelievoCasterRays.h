// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays in double precision past casters and visible surfaces, on the CPU, for certifying and
// planning shadows.
//
// Coordinates use the world's axes, relative to the scene's centre.
#ifndef vtkRelievoCasterRays_h
#define vtkRelievoCasterRays_h

#include "vtkRelievoRayTree.h"

#include <string>
#include <vector>

// A mesh of the scene with its roles.
struct vtkRelievoSurface
{
  vtkRelievoPlacedMesh Caster;
  bool Casts = true;
  bool Seen = true; // visible and opaque
  bool Receives = true;
};

class vtkRelievoCasterRays
{
public:
  // A hit of a ray.
  struct Hit
  {
    int Surface = -1; // -1: no hit
    int Place = -1;   // glyph number, counted over all surfaces
    int Triangle = -1;
    double T = 0.0;
    glm::dvec3 Normal{ 0.0 }; // of the triangle's plane, towards the ray's start; not normalised
  };

  // Unchanged meshes keep their trees. Returns an empty string; without memory for the trees, the
  // numbers of bytes, and there are no surfaces.
  std::string SetSurfaces(const std::vector<vtkRelievoSurface>& surfaces);
  const std::vector<vtkRelievoSurface>& GetSurfaces() const { return this->Surfaces; }
  const glm::dvec3& GetCenter() const { return this->Tree.GetCenter(); }
  long long GetNumberOfTriangles() const { return this->Tree.GetNumberOfTriangles(); }

  // The hit with a visible surface nearest to t = `wanted`, between two limits.
  Hit Find(
    const glm::dvec3& from, const glm::dvec3& ray, double low, double high, double wanted) const;

  // The first such hit.
  Hit FindFirst(const glm::dvec3& from, const glm::dvec3& ray, double low) const;

  // The light's transmittance from t = 0 to `last`: the product over the casters between;
  // translucent triangles that share an edge count once there. A triangle does not count if it is
  // `own`, or if the ray's start (or its end, if it has one) lies in its plane within `blur`.
  double Pass(
    const glm::dvec3& from, const glm::dvec3& ray, double last, const Hit& own, double blur) const;

private:
  std::vector<vtkRelievoSurface> Surfaces;
  vtkRelievoRayTree Tree; // of Surfaces
};

#endif
