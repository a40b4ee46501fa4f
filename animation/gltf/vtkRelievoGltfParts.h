// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the parts of reading glTF share: the file's nodes, and the model that they fill. What is
 * wrong is a GltfError.
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
/// Which of the file's nodes are the model's.
struct GltfNodes
{
  std::vector<int> Numbers; ///< by places in the file: the model's; -1 for those left out
  std::vector<int> Shown;   ///< places in the file of those of the scene, parents first

  int Get(std::size_t place) const { return this->Numbers[place]; }
};

/// Those of the scene, and of trees with joints of skins that the scene shows. Fills the model's
/// nodes.
GltfNodes ReadGltfNodes(const GltfDocument& document, Model& model);

/// The meshes of the nodes that are shown. `weights`: most bones of a point.
void ReadGltfMeshes(GltfDocument& document, const GltfNodes& nodes, int weights,
  const std::function<bool(double)>& progress, Model& model);

/// The joints of a skin: the model's nodes, and from where each takes the mesh's points.
struct GltfSkin
{
  std::vector<int> Nodes;
  std::vector<glm::dmat4> Offsets;
};

GltfSkin ReadGltfSkin(GltfDocument& document, const GltfNodes& nodes, std::size_t skin);

void ReadGltfAnimations(GltfDocument& document, const GltfNodes& nodes, Model& model);

/// All of the file's materials, one more for meshes without one, and the images' bytes.
void ReadGltfMaterials(GltfDocument& document, Model& model);

void ReadGltfLightsAndCameras(GltfDocument& document, const GltfNodes& nodes, Model& model);

/// What a primitive holds: corners by the topology of its mode, and attributes by name. Of a
/// compressed one the attributes' accessors describe what was compressed.
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
