// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** A model as bytes, for programs that let another process read its file. */
#ifndef vtkRelievoModelBytes_h
#define vtkRelievoModelBytes_h

#include "vtkRelievoBytes.h"
#include "vtkRelievoModel.h"

namespace relievo
{
// Structs are decomposed into all members: adding a member prevents compilation.
template <typename Visit>
void VisitFields(ModelNode& node, Visit&& visit)
{
  auto& [name, parent, rest, parts, isBone] = node;
  visit(name, parent, rest, parts, isBone);
}

template <typename Value, typename Visit>
void VisitFields(ModelTrack<Value>& track, Visit&& visit)
{
  auto& [times, values, mode, before, after] = track;
  visit(times, values, mode, before, after);
}

template <typename Visit>
void VisitFields(ModelChannel& channel, Visit&& visit)
{
  auto& [node, position, rotation, scale] = channel;
  visit(node, position, rotation, scale);
}

template <typename Visit>
void VisitFields(ModelMorphChannel& channel, Visit&& visit)
{
  auto& [node, weights] = channel;
  visit(node, weights);
}

template <typename Visit>
void VisitFields(ModelAnimation& animation, Visit&& visit)
{
  auto& [name, start, end, channels, morphs, keyTimes] = animation;
  visit(name, start, end, channels, morphs, keyTimes);
}

template <typename Visit>
void VisitFields(ModelMorph& morph, Visit&& visit)
{
  auto& [points, normals, tangents] = morph;
  visit(points, normals, tangents);
}

template <typename Visit>
void VisitFields(ModelMesh& mesh, Visit&& visit)
{
  auto& [name, data, node, material, morphs, isPlaced, isSkinned, isFaceted] = mesh;
  visit(name, data, node, material, morphs, isPlaced, isSkinned, isFaceted);
}

template <typename Visit>
void VisitFields(ModelTexture& texture, Visit&& visit)
{
  auto& [image, wrap, smooth, mipmaps, coordinates, transform] = texture;
  visit(image, wrap, smooth, mipmaps, coordinates, transform);
}

template <typename Visit>
void VisitFields(ModelMaterial& material, Visit&& visit)
{
  auto& [name, baseColor, metallic, roughness, normalScale, occlusionStrength, emission, alpha,
    alphaCutoff, isDoubleSided, isUnlit, baseColorTexture, metalTexture, normalTexture,
    occlusionTexture, emissionTexture] = material;
  visit(name, baseColor, metallic, roughness, normalScale, occlusionStrength, emission, alpha,
    alphaCutoff, isDoubleSided, isUnlit, baseColorTexture, metalTexture, normalTexture,
    occlusionTexture, emissionTexture);
}

template <typename Visit>
void VisitFields(ModelLight& light, Visit&& visit)
{
  auto& [name, is, node, color, intensity, range, innerCone, outerCone] = light;
  visit(name, is, node, color, intensity, range, innerCone, outerCone);
}

template <typename Visit>
void VisitFields(ModelCamera& camera, Visit&& visit)
{
  auto& [name, node, isPerspective, height, nearEnd, farEnd] = camera;
  visit(name, node, isPerspective, height, nearEnd, farEnd);
}

template <typename Visit>
void VisitFields(ModelImage& image, Visit&& visit)
{
  auto& [bytes, format, width, height] = image;
  visit(bytes, format, width, height);
}

template <typename Visit>
void VisitFields(Model& model, Visit&& visit)
{
  auto& [nodes, meshes, weights, animations, materials, lights, cameras, images, notes] = model;
  visit(nodes, meshes, weights, animations, materials, lights, cameras, images, notes);
}

/// Whether the nodes, meshes, materials, lights, cameras and tracks refer to existing ones.
bool IsConsistent(const Model& model);
}

#endif
