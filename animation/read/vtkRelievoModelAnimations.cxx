// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelNames.h"
#include "vtkRelievoModelParts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace relievo
{
namespace
{
// For files that do not specify it: the default of Assimp's own viewer.
constexpr double UsualTicksPerSecond = 25.;

// Problems of an animation's keys, for one note each.
struct KeyFaults
{
  int Unfit = 0;
  int Disordered = 0;
  int Doubled = 0;
  std::set<std::string> Strangers; // nodes missing in the tree
};

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool IsFinite(const glm::dvec4& v)
{
  const double size = glm::dot(v, v);
  return std::isfinite(size) && size > 1e-12;
}

glm::dvec3 ToValue(const aiVector3D& v)
{
  return glm::dvec3(v.x, v.y, v.z);
}

glm::dvec4 ToValue(const aiQuaternion& q)
{
  return glm::dvec4(q.x, q.y, q.z, q.w);
}

template <typename Value, typename Key>
ModelTrack<Value> ReadTrack(const Key* keys, unsigned int count, double ticks, KeyFaults& faults)
{
  std::vector<std::pair<double, Value>> good;
  for (unsigned int i = 0; i < count; ++i)
  {
    const Value value = ToValue(keys[i].mValue);
    if (std::isfinite(keys[i].mTime) && IsFinite(value))
    {
      good.emplace_back(keys[i].mTime / ticks, value);
    }
    else
    {
      ++faults.Unfit;
    }
  }
  const auto earlier = [](const auto& a, const auto& b) { return a.first < b.first; };
  const bool ordered = std::is_sorted(good.begin(), good.end(), earlier);
  if (!ordered)
  {
    ++faults.Disordered;
    std::stable_sort(good.begin(), good.end(), earlier);
  }
  ModelTrack<Value> track;
  for (const auto& [time, value] : good)
  {
    // Two keys at one time are a jump: the track arrives at the first and continues from the last.
    // Keys between these are never seen. Unsorted keys do not tell which comes first.
    const std::size_t kept = track.Times.size();
    const std::size_t most = ordered ? 2 : 1;
    if (kept >= most && track.Times[kept - 1] == time && track.Times[kept - most] == time)
    {
      ++faults.Doubled;
      track.Values.back() = value;
      continue;
    }
    track.Times.push_back(time);
    track.Values.push_back(value);
  }
  return track;
}

void AddNotes(const std::string& name, const KeyFaults& faults, Model& model)
{
  const std::string of = "animation '" + name + "': ";
  const auto add = [&](int count, const std::string& what) {
    if (count > 0)
    {
      model.Notes.push_back(of + std::to_string(count) + " " + what);
    }
  };
  add(faults.Unfit, "keys are not finite, and left out");
  add(faults.Disordered, "tracks have their keys out of order, and are sorted");
  add(faults.Doubled, "keys stand at the time of the one before, and replace it");
  if (!faults.Strangers.empty())
  {
    add(static_cast<int>(faults.Strangers.size()),
      "channels move nodes that are not there, such as '" + *faults.Strangers.begin() +
        "'; they are left out");
  }
}
}

//------------------------------------------------------------------------------
void ReadAnimations(const aiScene* scene, const NodeNumbers& numbers, Model& model)
{
  for (unsigned int i = 0; i < scene->mNumAnimations; ++i)
  {
    const aiAnimation* source = scene->mAnimations[i];
    ModelAnimation animation;
    animation.Name = GetFreeName(source->mName.C_Str(), model.Animations);
    double ticks = source->mTicksPerSecond;
    if (!std::isfinite(ticks) || ticks <= 0.)
    {
      ticks = UsualTicksPerSecond;
      model.Notes.push_back("animation '" + animation.Name +
        "': the file does not say how long a tick is; 25 a second are assumed");
    }
    KeyFaults faults;
    for (unsigned int j = 0; j < source->mNumChannels; ++j)
    {
      const aiNodeAnim* from = source->mChannels[j];
      const auto node = numbers.find(from->mNodeName.C_Str());
      if (node == numbers.end())
      {
        faults.Strangers.insert(from->mNodeName.C_Str());
        continue;
      }
      ModelChannel channel;
      channel.Node = node->second;
      channel.Position =
        ReadTrack<glm::dvec3>(from->mPositionKeys, from->mNumPositionKeys, ticks, faults);
      channel.Rotation =
        ReadTrack<glm::dvec4>(from->mRotationKeys, from->mNumRotationKeys, ticks, faults);
      channel.Scale =
        ReadTrack<glm::dvec3>(from->mScalingKeys, from->mNumScalingKeys, ticks, faults);
      for (glm::dvec4& rotation : channel.Rotation.Values)
      {
        rotation = glm::normalize(rotation);
      }
      for (const std::vector<double>* times :
        { &channel.Position.Times, &channel.Rotation.Times, &channel.Scale.Times })
      {
        animation.KeyTimes.insert(animation.KeyTimes.end(), times->begin(), times->end());
      }
      animation.Channels.push_back(std::move(channel));
    }
    AddNotes(animation.Name, faults, model);
    if (source->mNumMorphMeshChannels > 0 || source->mNumMeshChannels > 0)
    {
      model.Notes.push_back("animation '" + animation.Name + "': its morph targets are not played");
    }
    std::vector<double>& times = animation.KeyTimes;
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.empty())
    {
      model.Notes.push_back("animation '" + animation.Name + "' moves nothing, and is left out");
      continue;
    }
    animation.Start = times.front();
    const double length = source->mDuration / ticks;
    animation.End = std::isfinite(length) ? std::max(times.back(), length) : times.back();
    model.Animations.push_back(std::move(animation));
  }
}
}
