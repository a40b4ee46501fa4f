// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoTangentSpace.h
 * @brief Tangents at the corners of triangles, as vtkRelievoTangents makes them, on plain arrays.
 */
#ifndef vtkRelievoTangentSpace_h
#define vtkRelievoTangentSpace_h

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace relievo
{
/**
 * Method: M. Mikkelsen, Simulation of Wrinkled Surfaces Revisited, 2008. Corners with equal
 * position, normal and texture coordinate are joined. Around such a vertex, triangles that share
 * edges and whose textures have the same handedness share a tangent: the average of theirs, each
 * projected into the plane of the vertex's normal, weighted by the angles of their corners.
 */
class TangentSpace
{
public:
  /** A corner's values. A normal without length projects nothing. */
  struct Vertex
  {
    glm::dvec3 Position;
    glm::dvec3 Normal;
    glm::dvec2 Texture;
  };

  using Triangle = std::array<int, 3>;

  /** Triangles are triples of indices into the vertices, of which several may be equal. */
  TangentSpace(std::vector<Vertex> vertices, const std::vector<Triangle>& triangles);

  /** The unit tangent of a corner, and w: its bitangent is w cross(normal, tangent). */
  glm::dvec4 GetTangent(std::size_t triangle, int corner) const;

  /**
   * Triangles without area in texture coordinates or positions: they have no tangent of their own.
   */
  std::size_t GetNumberOfDegenerate() const { return this->NumberOfDegenerate; }

private:
  static constexpr int None = -1;

  struct Face
  {
    Triangle Vertex; // joined vertices, each represented by one of them
    Triangle Neighbour = { { None, None, None } }; // across the edge after corner i
    Triangle Group = { { None, None, None } };
    glm::dvec3 S = glm::dvec3(0.); // along growing u
    glm::dvec3 T = glm::dvec3(0.); // along growing v
    bool Preserving = false;       // the texture is not mirrored
    bool JoinsAny = true;          // no texture area: takes the tangent of its neighbours
    bool Collapsed = false;        // two corners coincide
  };

  struct Group
  {
    int Vertex;
    bool Preserving;
    glm::dvec4 Tangent;
    std::vector<int> Faces;
  };

  void Join(const std::vector<Triangle>& triangles);
  void MeasureFaces();
  void FindNeighbours();
  void FindGroups();
  void Grow(int group, int face);
  void Average(Group& group);

  std::vector<Vertex> Vertices;
  std::vector<int> Place; // a representative vertex at the same position
  std::vector<Face> Faces;
  std::vector<Group> Groups;
  std::vector<int> GroupOfVertex;
  std::vector<int> GroupOfPlace;
  std::size_t NumberOfDegenerate = 0;
};
}

#endif
