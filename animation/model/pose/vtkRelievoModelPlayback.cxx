// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoModelPlayback.h"

#include "vtkRelievoModelPose.h"

#include <algorithm>

namespace relievo
{
//------------------------------------------------------------------------------
SkeletonPose Play(const Model& model, const ModelPlayback& play, double time)
{
  SkeletonPose pose;
  if (!play.First)
  {
    std::vector<glm::dmat4> locals;
    for (const ModelNode& node : model.Nodes)
    {
      locals.push_back(node.Rest);
    }
    pose.Now = GetWorldMatrices(model.Nodes, locals);
    pose.Before = pose.Now;
    pose.After = pose.Now;
    return pose;
  }
  const double now = GetAnimationTime(*play.First, time, play.Loop);
  const auto getPose = [&](double at) {
    if (!play.Second)
    {
      return GetWorldMatrices(model.Nodes, GetLocalMatrices(model, *play.First, at, play.Slerp));
    }
    // The first animation's keys may lie beyond an end of the second.
    const double second = GetAnimationTime(
      *play.Second, GetAnimationTime(*play.Second, time, play.Loop) + (at - now), play.Loop);
    return GetWorldMatrices(model.Nodes,
      GetBlendedMatrices(model, *play.First, at, *play.Second, second, play.Weight, play.Slerp));
  };
  const KeySpan span = GetKeySpan(*play.First, now, play.KeyRate);
  pose.Now = getPose(now);
  pose.Before = getPose(span.Before);
  pose.After = getPose(span.After);
  pose.Share = span.Share;
  return pose;
}

//------------------------------------------------------------------------------
std::vector<ModelWeights> PlayMorphs(const Model& model, const ModelPlayback& play, double time)
{
  if (!play.First || model.Weights.empty())
  {
    return model.Weights;
  }
  std::vector<ModelWeights> weights =
    GetMorphWeights(model, *play.First, GetAnimationTime(*play.First, time, play.Loop));
  if (play.Second)
  {
    const std::vector<ModelWeights> second =
      GetMorphWeights(model, *play.Second, GetAnimationTime(*play.Second, time, play.Loop));
    for (std::size_t i = 0; i < weights.size(); ++i)
    {
      weights[i] = weights[i] * (1. - play.Weight) + second[i] * play.Weight;
    }
  }
  return weights;
}

//------------------------------------------------------------------------------
std::vector<double> GetTimes(const ModelPlayback& play)
{
  std::vector<double> times;
  for (const ModelAnimation* animation : { play.First, play.Second })
  {
    if (animation)
    {
      times.insert(times.end(), animation->KeyTimes.begin(), animation->KeyTimes.end());
      times.push_back(animation->End);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}
}
