// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelPose.h"

#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>

namespace relievo
{
namespace
{
// Between which keys, and how far.
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

glm::dvec3 Sample(const ModelTrack<glm::dvec3>& track, double time, const glm::dvec3& atRest)
{
  if (track.Times.empty())
  {
    return atRest;
  }
  const Place place = Find(track.Times, time);
  return track.Values[place.Before] * (1. - place.Share) + track.Values[place.After] * place.Share;
}

glm::dvec4 Sample(
  const ModelTrack<glm::dvec4>& track, double time, const glm::dvec4& atRest, bool slerp)
{
  if (track.Times.empty())
  {
    return atRest;
  }
  const Place place = Find(track.Times, time);
  const glm::dvec4& a = track.Values[place.Before];
  const glm::dvec4& b = track.Values[place.After];
  return slerp ? f64::relievoQuaternionSlerp(a, b, place.Share)
               : f64::relievoQuaternionNlerp(a, b, place.Share);
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
  // A mirror is a negative scale along all axes.
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
    const bool whole = !channel.Position.Times.empty() && !channel.Rotation.Times.empty() &&
      !channel.Scale.Times.empty();
    const NodeParts rest = whole ? NodeParts() : GetParts(local);
    NodeParts parts;
    parts.Position = Sample(channel.Position, time, rest.Position);
    parts.Rotation = Sample(channel.Rotation, time, rest.Rotation, slerp);
    parts.Scale = Sample(channel.Scale, time, rest.Scale);
    local = GetMatrix(parts);
  }
  return locals;
}

//------------------------------------------------------------------------------
KeySpan GetKeySpan(const ModelAnimation& animation, double time, double rate)
{
  if (rate > 0.)
  {
    const double key = std::floor((time - animation.Start) * rate);
    const double before = animation.Start + key / rate;
    return { before, animation.Start + (key + 1.) / rate,
      std::clamp((time - before) * rate, 0., 1.) };
  }
  const Place place = Find(animation.KeyTimes, time);
  return { animation.KeyTimes[place.Before], animation.KeyTimes[place.After], place.Share };
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
  // The end itself is shown where it is asked for, and not the start again.
  if (time >= animation.Start && time <= animation.End)
  {
    return time;
  }
  const double turns = std::floor((time - animation.Start) / length);
  return std::clamp(time - turns * length, animation.Start, animation.End);
}
}
