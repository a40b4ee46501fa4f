// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** Shared by the parts of reading: Assimp's scene, and the numbers of its nodes. */
#ifndef vtkRelievoModelParts_h
#define vtkRelievoModelParts_h

#include "vtkRelievoModel.h"

#include <assimp/scene.h>

#include <map>
#include <string>

namespace relievo
{
inline glm::dmat4 ToMatrix(const aiMatrix4x4& m)
{
  // Assimp stores rows, GLM columns.
  return glm::dmat4(
    m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4);
}

/// Nodes by name; the first of equal names, as in Assimp's search.
using NodeNumbers = std::map<std::string, int>;

/// The mesh's name, or its node's. ParaView rejects blocks without a name.
inline std::string GetMeshName(const aiMesh* mesh, int node, const Model& model)
{
  const std::string name =
    mesh->mName.length > 0 ? mesh->mName.C_Str() : model.Nodes[static_cast<std::size_t>(node)].Name;
  return name.empty() ? "node " + std::to_string(node) : name;
}

/// Reads the scene's animations, with sorted and finite keys; adds notes.
void ReadAnimations(const aiScene* scene, const NodeNumbers& numbers, Model& model);

/// A node's mesh: geometry transformed by the node at rest, with bones.
void ReadMesh(const aiScene* scene, const aiMesh* mesh, int node, const glm::dmat4& place,
  const NodeNumbers& numbers, int weights, Model& model);

/// Adds colour and texture names to the mesh's polydata, and images inside the file to the model.
void ReadMaterial(
  const aiScene* scene, const aiMaterial* material, vtkPolyData* output, Model& model);

/// Adds `joints`, `weights` and the bones' field data to the mesh's polydata. A mesh without bones
/// follows its node.
void ReadBones(const aiMesh* mesh, int node, const glm::dmat4& place, const NodeNumbers& numbers,
  int weights, vtkPolyData* output, Model& model);
}

#endif
