// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A primitive of a mesh, decoded: points as the file has them, before any node places them.
 */
#ifndef vtkRelievoGltfGeometry_h
#define vtkRelievoGltfGeometry_h

#include "vtkRelievoGltfParts.h"
#include "vtkRelievoModelWeights.h"

#include <glm/vec2.hpp>

#include <vector>

namespace relievo
{
struct GltfTarget
{
  std::vector<glm::dvec3> Points;
  std::vector<glm::dvec3> Normals;
  std::vector<glm::dvec3> Tangents;
};

struct GltfGeometry
{
  std::vector<glm::dvec3> Points;
  std::vector<glm::dvec3> Normals; ///< these, and the following: one a point, or none at all
  std::vector<glm::dvec4> Tangents;
  std::vector<glm::dvec2> Coordinates; ///< as the material's textures want them, v upwards
  std::vector<glm::dvec4> Colors;      ///< linear
  std::vector<std::vector<ModelInfluence>> Influences;
  std::vector<GltfTarget> Targets;
  std::vector<std::uint32_t> Corners; ///< points of each cell, one after the other
  int CellSize = 3;                   ///< 1: vertices, 2: lines, 3: triangles
  std::size_t Material = 0;           ///< of the model's
  ModelWeightFaults Faults;

  bool IsFaceted() const { return this->CellSize == 3 && this->Normals.empty(); }
};

/// Reads a primitive. Points that no cell has are left out; where the file has no normals, each
/// triangle gets points of its own. Returns nothing without points.
GltfGeometry ReadGltfGeometry(GltfDocument& document, const GltfValue& primitive, Model& model);

/// How many points and corners reading the primitive takes, at most.
void CountGltfGeometry(const GltfDocument& document, const GltfValue& primitive,
  std::size_t& points, std::size_t& corners);
}

#endif
