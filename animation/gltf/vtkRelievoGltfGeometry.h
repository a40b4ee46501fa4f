// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** A primitive of a mesh, decoded: points as in the file, before any node transforms them. */
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
  std::vector<glm::dvec3> Normals; ///< this and the following: one per point, or empty
  std::vector<glm::dvec4> Tangents;
  std::vector<glm::dvec2> Coordinates; ///< for the material's textures, v upwards
  std::vector<glm::dvec4> Colors;      ///< linear
  std::vector<std::vector<ModelInfluence>> Influences;
  std::vector<GltfTarget> Targets;
  std::vector<std::uint32_t> Corners; ///< points of each cell, concatenated
  int CellSize = 3;                   ///< 1: vertices, 2: lines, 3: triangles
  std::size_t Material = 0;           ///< index in the model
  ModelWeightFaults Faults;

  bool IsFaceted() const { return this->CellSize == 3 && this->Normals.empty(); }
};

/// Reads a primitive. Points that no cell uses are left out; if the file has no normals, each
/// triangle gets its own points. Returns an empty result without points.
GltfGeometry ReadGltfGeometry(GltfDocument& document, const GltfValue& primitive, Model& model);

/// Upper bounds of the points and corners needed to read the primitive.
void CountGltfGeometry(const GltfDocument& document, const GltfValue& primitive,
  std::size_t& points, std::size_t& corners);
}

#endif
