// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shared by the parts of the glTF reader: the file's nodes, and the model being filled. Problems
 * are thrown as GltfError.
 */
#ifndef vtkRelievoGltfParts_h
#define vtkRelievoGltfParts_h

#include "vtkRelievoGltfDocument.h"
#include "vtkRelievoModel.h"

#include <functional>
#include <string>
#include <vector>

namespace relievo
{
/// Maps the file's nodes to the model's.
struct GltfNodes
{
  std::vector<int> Numbers; ///< the model's index of each node of the file; -1 if left out
  std::vector<int> Shown;   ///< the file's indices of the scene's nodes, parents first

  int Get(std::size_t place) const { return this->Numbers[place]; }
};

/// Takes the nodes of the scene, and of trees with joints of skins shown in the scene. Fills the
/// model's nodes.
GltfNodes ReadGltfNodes(const GltfDocument& document, Model& model);

/// Reads the meshes of the shown nodes. `weights`: most bones per point.
void ReadGltfMeshes(GltfDocument& document, const GltfNodes& nodes, int weights,
  const std::function<bool(double)>& progress, Model& model);

/// The joints of a skin: the model's nodes, and the matrices from the mesh's points to each joint.
struct GltfSkin
{
  std::vector<int> Nodes;
  std::vector<glm::dmat4> Offsets;
};

GltfSkin ReadGltfSkin(GltfDocument& document, const GltfNodes& nodes, std::size_t skin);

void ReadGltfAnimations(GltfDocument& document, const GltfNodes& nodes, Model& model);

/// Reads all materials of the file, one more for meshes without any, and the images' bytes.
void ReadGltfMaterials(GltfDocument& document, Model& model);

void ReadGltfLightsAndCameras(GltfDocument& document, const GltfNodes& nodes, Model& model);

/// A primitive's data: corners by the topology of its mode, and attributes by name. If compressed,
/// the attributes' accessors describe the compressed data.
struct GltfPrimitive
{
  std::vector<std::uint32_t> Indices;
  bool IsIndexed = false;
  std::map<std::string, GltfNumbers> Attributes;
};

/// Decodes KHR_draco_mesh_compression of a primitive.
void ReadGltfDraco(GltfDocument& document, const GltfValue& primitive, GltfPrimitive& result);
}

#endif
