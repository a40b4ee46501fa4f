// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelBytes.h"

#include <algorithm>

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

namespace
{
template <typename Value>
bool Fits(const ModelTrack<Value>& track)
{
  const std::size_t count = track.Times.size();
  const bool sloped = track.Before.size() == count && track.After.size() == count;
  return track.Values.size() == count && (track.Mode != KeyMode::Cubic || sloped);
}

bool Fits(const Model& model)
{
  const auto isNode = [&model](const auto& it) {
    return it.Node >= 0 && it.Node < static_cast<int>(model.Nodes.size());
  };
  for (std::size_t i = 0; i < model.Nodes.size(); ++i)
  {
    if (model.Nodes[i].Parent < -1 || model.Nodes[i].Parent >= static_cast<int>(i))
    {
      return false;
    }
  }
  const auto fits = [&](const ModelAnimation& animation) {
    return std::all_of(animation.Channels.begin(), animation.Channels.end(),
             [&](const ModelChannel& channel) {
               return isNode(channel) && Fits(channel.Position) && Fits(channel.Rotation) &&
                 Fits(channel.Scale);
             }) &&
      std::all_of(animation.Morphs.begin(), animation.Morphs.end(),
        [&](const ModelMorphChannel& channel) { return isNode(channel) && Fits(channel.Weights); });
  };
  return (model.Weights.empty() || model.Weights.size() == model.Nodes.size()) &&
    std::all_of(model.Meshes.begin(), model.Meshes.end(),
      [&](const ModelMesh& mesh) {
        return isNode(mesh) && mesh.Data && mesh.Material >= -1 &&
          mesh.Material < static_cast<int>(model.Materials.size());
      }) &&
    std::all_of(model.Lights.begin(), model.Lights.end(), isNode) &&
    std::all_of(model.Cameras.begin(), model.Cameras.end(), isNode) &&
    std::all_of(model.Animations.begin(), model.Animations.end(), fits);
}
}

//------------------------------------------------------------------------------
void PutModel(ByteWriter& writer, const Model& model)
{
  writer(model);
}

//------------------------------------------------------------------------------
void GetModel(ByteReader& reader, Model& model)
{
  reader(model);
  if (!Fits(model))
  {
    ByteReader::Refuse();
  }
}
}
