// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the parts of reading share: Assimp's scene, and the numbers of its nodes.
 */
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
  // Assimp's are rows, GLM's columns.
  return glm::dmat4(
    m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4);
}

/// Nodes by name; of several with one name the first, as Assimp's own search has it.
using NodeNumbers = std::map<std::string, int>;

/// The mesh's name, or its node's. Blocks without a name are errors to ParaView.
inline std::string GetMeshName(const aiMesh* mesh, int node, const Model& model)
{
  const std::string name =
    mesh->mName.length > 0 ? mesh->mName.C_Str() : model.Nodes[static_cast<std::size_t>(node)].Name;
  return name.empty() ? "node " + std::to_string(node) : name;
}

/// The animations of the scene, with keys in order and finite; adds notes.
void ReadAnimations(const aiScene* scene, const NodeNumbers& numbers, Model& model);

/// A mesh that hangs below a node: geometry in the node's place at rest, with bones.
void ReadMesh(const aiScene* scene, const aiMesh* mesh, int node, const glm::dmat4& place,
  const NodeNumbers& numbers, int weights, Model& model);

/// Gives the mesh's polydata its colour and the names of its textures, and the model the images
/// that are in the file.
void ReadMaterial(
  const aiScene* scene, const aiMaterial* material, vtkPolyData* output, Model& model);

/// Gives the mesh's polydata `joints`, `weights` and the bones' field data. A mesh without bones
/// follows its node.
void ReadBones(const aiMesh* mesh, int node, const glm::dmat4& place, const NodeNumbers& numbers,
  int weights, vtkPolyData* output, Model& model);
}

#endif
