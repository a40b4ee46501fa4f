// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The meshes of a glTF file, and the nodes that place them.
 */
#ifndef GltfMeshes_h
#define GltfMeshes_h

#include "GltfBuffer.h"
#include "GltfMaterials.h"
#include "SceneNames.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <optional>
#include <set>
#include <string>

namespace scene
{
struct GltfSurface;

/// A matrix as glTF's nodes have it: scale, then rotation, then translation.
struct GltfPlace
{
  glm::dvec3 Translation = glm::dvec3(0.);
  glm::dvec4 Rotation = glm::dvec4(0., 0., 0., 1.); ///< a unit quaternion x, y, z, w
  glm::dvec3 Scale = glm::dvec3(1.);

  /// None for a matrix with shear or a side of length 0.
  static std::optional<GltfPlace> Find(const glm::dmat4& matrix);
  GltfBuffer::Json GetNode(const std::string& name) const;
};

class GltfMeshes
{
public:
  GltfMeshes(GltfBuffer& buffer, GltfMaterials& materials, std::set<std::string>& notes)
    : Buffer(buffer)
    , Materials(materials)
    , Notes(notes)
  {
  }

  /// Adds the surface as drawn: triangles, lines and points, each with its material. Returns the
  /// index of its node; none if nothing of it is drawn.
  std::optional<std::size_t> Add(const GltfSurface& surface, const std::string& name);

private:
  GltfBuffer& Buffer;
  GltfMaterials& Materials;
  std::set<std::string>& Notes;
};
}

#endif
