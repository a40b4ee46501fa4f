// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rays in double precision past the triangles of a scene, on the CPU: what certifies shadows, and
// what they are planned by. Shares nothing with the shaders but the boxes' tree.
//
// Coordinates are the world's axes about the scene's centre.
#ifndef vtkRelievoCasterRays_h
#define vtkRelievoCasterRays_h

#include "vtkRelievoBoxTree.h"
#include "vtkRelievoShadowTree.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <vector>

class vtkPolyData;

// A mesh of the scene, and what it is there for.
struct vtkRelievoSurface
{
  vtkRelievoCaster Caster;
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
  const glm::dvec3& GetCenter() const { return this->Center; }
  long long GetNumberOfTriangles() const;

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
  struct Mesh;
  struct Placed
  {
    int Surface = 0;
    const Mesh* Triangles = nullptr;
    glm::dmat4 ToScene{ 1.0 };
    glm::dmat4 ToMesh{ 1.0 };
  };
  struct Held
  {
    vtkWeakPointer<vtkPolyData> Data;
    std::shared_ptr<Mesh> Triangles;
  };

  template <typename Visit>
  void Walk(
    const glm::dvec3& from, const glm::dvec3& ray, double low, double high, Visit visit) const;
  glm::dvec3 GetNormal(const Meeting& meeting, glm::dvec3& corner) const;

  std::map<vtkPolyData*, Held> Meshes;
  std::vector<vtkRelievoSurface> Surfaces;
  std::vector<Placed> Places; // of Surfaces, one or more each
  vtkRelievoBoxTree Tree;     // over Places
  glm::dvec3 Center{ 0.0 };
};

#endif
