// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelPose.h"

#include "vtkRelievoFormulas.h"
#include "vtkRelievoSkinNames.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace relievo
{
namespace
{
// The adjacent keys, and the fraction between them.
struct Place
{
  std::size_t Before;
  std::size_t After;
  double Share;
};

Place Find(const std::vector<double>& times, double time)
{
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  const auto next = static_cast<std::size_t>(after - times.begin());
  if (next == 0 || next == times.size())
  {
    const std::size_t end = next == 0 ? 0 : next - 1;
    return { end, end, 0. };
  }
  const double before = times[next - 1];
  return { next - 1, next, (time - before) / (times[next] - before) };
}

// A Hermite spline through the keys, as in glTF: slopes are per second.
template <typename Value>
Value GetSpline(const ModelTrack<Value>& track, const Place& place)
{
  const double length = track.Times[place.After] - track.Times[place.Before];
  const double s = place.Share;
  const double s2 = s * s;
  const double s3 = s2 * s;
  return track.Values[place.Before] * (2. * s3 - 3. * s2 + 1.) +
    track.After[place.Before] * (length * (s3 - 2. * s2 + s)) +
    track.Values[place.After] * (3. * s2 - 2. * s3) +
    track.Before[place.After] * (length * (s3 - s2));
}

template <typename Value, typename Between>
Value Sample(const ModelTrack<Value>& track, double time, const Value& atRest, Between&& between)
{
  if (track.Times.empty())
  {
    return atRest;
  }
  if (track.Mode == KeyMode::Step)
  {
    // Times in files are floats: a time that rounds to a key's time, such as 1/30, counts as that.
    return track.Values[Find(track.Times, std::max(time, double(static_cast<float>(time)))).Before];
  }
  const Place place = Find(track.Times, time);
  if (place.Before == place.After)
  {
    return track.Values[place.Before];
  }
  return track.Mode == KeyMode::Cubic
    ? GetSpline(track, place)
    : between(track.Values[place.Before], track.Values[place.After], place.Share);
}

glm::dvec3 Mix(const glm::dvec3& a, const glm::dvec3& b, double share)
{
  return a * (1. - share) + b * share;
}

// A spline of opposite quaternions may pass through 0, which has no direction.
glm::dvec4 ToUnit(const glm::dvec4& q)
{
  const double length = glm::length(q);
  return length > 1e-12 ? q / length : glm::dvec4(0., 0., 0., 1.);
}

NodeParts Sample(const ModelChannel& channel, double time, const NodeParts& rest, bool slerp)
{
  const auto turn = slerp ? f64::relievoQuaternionSlerp : f64::relievoQuaternionNlerp;
  NodeParts parts;
  parts.Position = Sample(channel.Position, time, rest.Position, Mix);
  parts.Rotation = ToUnit(Sample(channel.Rotation, time, rest.Rotation, turn));
  parts.Scale = Sample(channel.Scale, time, rest.Scale, Mix);
  return parts;
}

NodeParts GetPartsOf(const ModelNode& node)
{
  return node.Parts ? *node.Parts : GetParts(node.Rest);
}

bool MovesAll(const ModelChannel& channel)
{
  return !channel.Position.Times.empty() && !channel.Rotation.Times.empty() &&
    !channel.Scale.Times.empty();
}

glm::dmat4 GetMatrix(const NodeParts& parts)
{
  const glm::dmat3 turn = f64::relievoQuaternionMatrix(parts.Rotation);
  return glm::dmat4(glm::dvec4(turn[0] * parts.Scale.x, 0.),
    glm::dvec4(turn[1] * parts.Scale.y, 0.), glm::dvec4(turn[2] * parts.Scale.z, 0.),
    glm::dvec4(parts.Position, 1.));
}
}

//------------------------------------------------------------------------------
NodeParts GetParts(const glm::dmat4& m)
{
  NodeParts parts;
  parts.Position = glm::dvec3(m[3]);
  glm::dmat3 axes(m);
  // A reflection becomes a negative scale along all axes.
  const double sign = glm::dot(axes[0], glm::cross(axes[1], axes[2])) < 0. ? -1. : 1.;
  for (int i = 0; i < 3; ++i)
  {
    const double length = glm::length(axes[i]);
    parts.Scale[i] = sign * length;
    axes[i] = length > 0. ? axes[i] / (sign * length) : glm::dmat3(1.)[i];
  }
  parts.Rotation = f64::relievoQuaternionOf(axes);
  return parts;
}

//------------------------------------------------------------------------------
std::vector<glm::dmat4> GetLocalMatrices(
  const Model& model, const ModelAnimation& animation, double time, bool slerp)
{
  std::vector<glm::dmat4> locals;
  locals.reserve(model.Nodes.size());
  for (const ModelNode& node : model.Nodes)
  {
    locals.push_back(node.Rest);
  }
  for (const ModelChannel& channel : animation.Channels)
  {
    glm::dmat4& local = locals[static_cast<std::size_t>(channel.Node)];
    const ModelNode& node = model.Nodes[static_cast<std::size_t>(channel.Node)];
    // Parts without keys keep the values of a previous channel.
    const NodeParts rest = MovesAll(channel) ? NodeParts()
      : local == node.Rest                   ? GetPartsOf(node)
                                             : GetParts(local);
    local = GetMatrix(Sample(channel, time, rest, slerp));
  }
  return locals;
}

//------------------------------------------------------------------------------
std::vector<glm::dmat4> GetBlendedMatrices(const Model& model, const ModelAnimation& first,
  double firstTime, const ModelAnimation& second, double secondTime, double weight, bool slerp)
{
  // The parts of nodes that either animation moves.
  std::vector<std::optional<NodeParts>> parts[2];
  const ModelAnimation* const animations[2] = { &first, &second };
  const double times[2] = { firstTime, secondTime };
  for (int i = 0; i < 2; ++i)
  {
    parts[i].resize(model.Nodes.size());
    for (const ModelChannel& channel : animations[i]->Channels)
    {
      const auto node = static_cast<std::size_t>(channel.Node);
      // Parts without keys keep the values of a previous channel.
      const NodeParts rest = parts[i][node] ? *parts[i][node]
        : MovesAll(channel)                 ? NodeParts()
                                            : GetPartsOf(model.Nodes[node]);
      parts[i][node] = Sample(channel, times[i], rest, slerp);
    }
  }
  std::vector<glm::dmat4> locals;
  locals.reserve(model.Nodes.size());
  for (std::size_t i = 0; i < model.Nodes.size(); ++i)
  {
    const glm::dmat4& rest = model.Nodes[i].Rest;
    if (!parts[0][i] && !parts[1][i])
    {
      locals.push_back(rest);
      continue;
    }
    const NodeParts a = parts[0][i] ? *parts[0][i] : GetPartsOf(model.Nodes[i]);
    const NodeParts b = parts[1][i] ? *parts[1][i] : GetPartsOf(model.Nodes[i]);
    NodeParts mixed;
    mixed.Position = Mix(a.Position, b.Position, weight);
    mixed.Rotation = slerp ? f64::relievoQuaternionSlerp(a.Rotation, b.Rotation, weight)
                           : f64::relievoQuaternionNlerp(a.Rotation, b.Rotation, weight);
    mixed.Scale = Mix(a.Scale, b.Scale, weight);
    locals.push_back(GetMatrix(mixed));
  }
  return locals;
}

//------------------------------------------------------------------------------
std::vector<ModelWeights> GetMorphWeights(
  const Model& model, const ModelAnimation& animation, double time)
{
  std::vector<ModelWeights> weights = model.Weights;
  const auto mix = [](const ModelWeights& a, const ModelWeights& b, double share) {
    return ModelWeights(a * (1. - share) + b * share);
  };
  for (const ModelMorphChannel& channel : animation.Morphs)
  {
    ModelWeights& own = weights[static_cast<std::size_t>(channel.Node)];
    own = Sample(channel.Weights, time, ModelWeights(own), mix);
  }
  return weights;
}

//------------------------------------------------------------------------------
std::vector<glm::dmat4> GetBindMatrices(const Model& model)
{
  std::vector<std::optional<glm::dmat4>> bound(model.Nodes.size());
  for (const ModelMesh& mesh : model.Meshes)
  {
    vtkDataArray* nodes = mesh.Data->GetFieldData()->GetArray(BoneNodeArray);
    vtkDataArray* offsets = mesh.Data->GetFieldData()->GetArray(BoneOffsetArray);
    for (vtkIdType i = 0; i < nodes->GetNumberOfTuples(); ++i)
    {
      const auto node = static_cast<std::size_t>(nodes->GetComponent(i, 0));
      glm::dmat4 offset;
      for (int j = 0; j < 16; ++j)
      {
        offset[j % 4][j / 4] = offsets->GetComponent(i, j);
      }
      if (!bound[node] && std::abs(glm::determinant(glm::dmat3(offset))) > 1e-30)
      {
        bound[node] = glm::inverse(offset);
      }
    }
  }
  std::vector<glm::dmat4> worlds;
  for (std::size_t i = 0; i < model.Nodes.size(); ++i)
  {
    const ModelNode& node = model.Nodes[i];
    const glm::dmat4 parent =
      node.Parent < 0 ? glm::dmat4(1.) : worlds[static_cast<std::size_t>(node.Parent)];
    worlds.push_back(bound[i] ? *bound[i] : parent * node.Rest);
  }
  return worlds;
}

//------------------------------------------------------------------------------
KeySpan GetKeySpan(const ModelAnimation& animation, double time, double rate)
{
  if (rate > 0.)
  {
    // The end is always a whole key.
    const double key = std::floor((time - animation.Start) * rate);
    const double before = std::min(animation.Start + key / rate, animation.End);
    const double after = std::min(animation.Start + (key + 1.) / rate, animation.End);
    const double share = after > before ? (time - before) / (after - before) : 0.;
    return { before, after, std::clamp(share, 0., 1.) };
  }
  const Place place = Find(animation.KeyTimes, time);
  const double before = animation.KeyTimes[place.Before];
  // At a jump, uses the value before it.
  return { before, std::nextafter(animation.KeyTimes[place.After], before), place.Share };
}

//------------------------------------------------------------------------------
double GetAnimationTime(const ModelAnimation& animation, double time, bool loop)
{
  const double length = animation.End - animation.Start;
  if (!std::isfinite(time) || length <= 0.)
  {
    return animation.Start;
  }
  if (!loop)
  {
    return std::clamp(time, animation.Start, animation.End);
  }
  // The end itself is shown when requested, instead of the start.
  if (time >= animation.Start && time <= animation.End)
  {
    return time;
  }
  const double turns = std::floor((time - animation.Start) / length);
  return std::clamp(time - turns * length, animation.Start, animation.End);
}
}
