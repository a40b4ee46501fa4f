// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A surface as glTF stores it: vertices and indices by kind of cell, and a place.
 */
#ifndef GltfShape_h
#define GltfShape_h

#include "GltfBuffer.h"
#include "SceneNames.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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
  glm::dvec3 Turn(const glm::dvec3& vector) const; ///< scaled and rotated
  GltfBuffer::Json GetNode(const std::string& name) const;
};

/// Cells of one kind, and their vertices. Surfaces whose meshes differ only by the coordinates of
/// their points have their vertices in one order.
struct GltfPrimitive
{
  /// Numbers of the glTF 2 specification.
  enum Kind
  {
    Points = 0,
    Lines = 1,
    Triangles = 4
  };
  Kind Mode = Triangles;
  std::vector<glm::dvec3> Positions;
  std::vector<float> Normals;        ///< empty: none
  std::vector<float> Coordinates;    ///< of textures, v downwards; empty: none
  std::vector<std::uint16_t> Colors; ///< linear, with alpha; empty: none
  std::vector<std::uint32_t> Indices;
};

struct GltfShape
{
  GltfPlace Place;      ///< of the mesh; for a mesh that moves with its vertices alone, none
  bool IsPlaced = true; ///< false: the vertices are in world coordinates
  std::vector<GltfPrimitive> Primitives; ///< those that have cells

  explicit GltfShape(const GltfSurface& surface);

  /// A place close to the vertices, in double, if these are too far from 0 for floats.
  glm::dvec3 ChooseOrigin() const;
};
}

#endif
