// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** The state of a model at a time: one animation, or two of them blended. */
#ifndef vtkRelievoModelPlayback_h
#define vtkRelievoModelPlayback_h

#include "vtkRelievoSkeleton.h"

#include <vector>

namespace relievo
{
struct ModelPlayback
{
  const ModelAnimation* First = nullptr;  ///< null: the nodes' own matrices
  const ModelAnimation* Second = nullptr; ///< blended in; null: only the first
  double Weight = 0.;                     ///< of the second, 0 to 1
  bool Slerp = true;
  bool Loop = false;
  double KeyRate = 0.; ///< whole keys per second; 0: the first animation's own keys
};

/// Every node at a time in seconds of the animations.
SkeletonPose Play(const Model& model, const ModelPlayback& play, double time);

/// The weights of morph targets at that time, by nodes; empty if no node has any.
std::vector<ModelWeights> PlayMorphs(const Model& model, const ModelPlayback& play, double time);

/// The times of all keys, and the ends; ascending, without duplicates.
std::vector<double> GetTimes(const ModelPlayback& play);
}

#endif
