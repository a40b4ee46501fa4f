// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelBytes.h"

#include <algorithm>

namespace relievo
{
namespace
{
template <typename Value>
bool Fits(const ModelTrack<Value>& track)
{
  const std::size_t count = track.Times.size();
  const bool sloped = track.Before.size() == count && track.After.size() == count;
  return track.Values.size() == count && (track.Mode != KeyMode::Cubic || sloped);
}
}

//------------------------------------------------------------------------------
bool IsConsistent(const Model& model)
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
