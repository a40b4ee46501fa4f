// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether all directions of a cone from a position are free, or all blocked: answers that hold for
// every direction, unlike those of rays. Where triangles neither miss the whole cone nor cover it,
// or rounding matters, the answer is no to both.
#ifndef vtkRelievoConeSight_h
#define vtkRelievoConeSight_h

#include "vtkRelievoNeighbors.h"
#include "vtkRelievoRayTree.h"

#include <map>
#include <vector>

class VTKRELIEVORAYS_EXPORT vtkRelievoConeSight
{
public:
  // The directions with no negative product with any of the normals. All of them lie between the
  // edges, in any order; lengths do not matter.
  struct Cone
  {
    static constexpr int Sides = 6;
    static constexpr int Corners = 4;
    glm::dvec3 Normals[Sides];
    glm::dvec3 Edges[Corners];
  };

  // The scene must not change.
  explicit vtkRelievoConeSight(const vtkRelievoRayTree& scene);

  // Positions are the scene's. Whether no triangle meets the cone.
  bool IsFree(const glm::dvec3& from, const Cone& cone) const;
  // Whether the cone is covered by triangles that share edges. One direction within the cone is
  // given.
  bool IsBlocked(const glm::dvec3& from, const Cone& cone, const glm::dvec3& within) const;

private:
  class Local;

  const vtkRelievoRayTree& Scene;
  std::map<const vtkRelievoMeshTree*, vtkRelievoNeighbors> Neighbors;
  std::vector<glm::dmat3> Turns; // of each place's mesh into the scene
};

#endif
