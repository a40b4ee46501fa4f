// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays in double precision past what casts and what is seen, on the CPU: what certifies shadows,
// and what they are planned by.
//
// Coordinates are the world's axes about the scene's centre.
#ifndef vtkRelievoCasterRays_h
#define vtkRelievoCasterRays_h

#include "vtkRelievoRayTree.h"

#include <vector>

// A mesh of the scene, and what it is there for.
struct vtkRelievoSurface
{
  vtkRelievoPlacedMesh Caster;
  bool Casts = true;
  bool Seen = true; // and opaque
  bool Receives = true;
};

class vtkRelievoCasterRays
{
public:
  // Where a ray meets a surface.
  struct Meeting
  {
    int Surface = -1; // none
    int Place = -1;   // of a mesh of glyphs, of all surfaces' places
    int Triangle = -1;
    double T = 0.0;
    glm::dvec3 Normal{ 0.0 }; // of the plane, towards the ray's start; not unit
  };

  // Meshes that have not changed keep their trees.
  void SetSurfaces(const std::vector<vtkRelievoSurface>& surfaces);
  const std::vector<vtkRelievoSurface>& GetSurfaces() const { return this->Surfaces; }
  const glm::dvec3& GetCenter() const { return this->Tree.GetCenter(); }
  long long GetNumberOfTriangles() const { return this->Tree.GetNumberOfTriangles(); }

  // The meeting with what is seen that is nearest to t = `wanted`, between two others.
  Meeting Find(
    const glm::dvec3& from, const glm::dvec3& ray, double low, double high, double wanted) const;

  // The first one.
  Meeting FindFirst(const glm::dvec3& from, const glm::dvec3& ray, double low) const;

  // What of the light passes from t = 0 to `last`: the product of what the casters between let
  // pass; translucent triangles that share an edge count once there. A triangle does not count if
  // it is `own`, or if the ray's start, or its end where it has one, lies in its plane within
  // `blur`.
  double Pass(const glm::dvec3& from, const glm::dvec3& ray, double last, const Meeting& own,
    double blur) const;

private:
  std::vector<vtkRelievoSurface> Surfaces;
  vtkRelievoRayTree Tree; // of Surfaces
};

#endif
