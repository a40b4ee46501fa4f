// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where the nodes of a model are at a time of an animation.
 */
#ifndef vtkRelievoModelPose_h
#define vtkRelievoModelPose_h

#include "vtkRelievoModel.h"

namespace relievo
{
NodeParts GetParts(const glm::dmat4& m);

/// Node to parent for every node. Before the first key and after the last these hold. `slerp`:
/// rotations at constant speed, otherwise along the chord.
std::vector<glm::dmat4> GetLocalMatrices(
  const Model& model, const ModelAnimation& animation, double time, bool slerp);

/// Node to parent for every node, of two animations, each at a time of its own: `weight` of the way
/// from the first to the second. Parts that one of them leaves alone are as at rest there.
std::vector<glm::dmat4> GetBlendedMatrices(const Model& model, const ModelAnimation& first,
  double firstTime, const ModelAnimation& second, double secondTime, double weight, bool slerp);

/// The weights of morph targets by nodes, as the model has them at rest or the animation at a time.
std::vector<ModelWeights> GetMorphWeights(
  const Model& model, const ModelAnimation& animation, double time);

/// The bones' matrices for which no mesh moves, node to world; nodes that are no bones follow their
/// parents.
std::vector<glm::dmat4> GetBindMatrices(const Model& model);

/// The whole keys around a time: those of any track, or, when `rate` is above 0, as many a second
/// from the start on, and the end.
struct KeySpan
{
  double Before;
  double After;
  double Share; ///< of the way from before to after
};

KeySpan GetKeySpan(const ModelAnimation& animation, double time, double rate);

/// The time within the animation: `loop` starts anew after the end, otherwise the ends hold.
double GetAnimationTime(const ModelAnimation& animation, double time, bool loop);
}

#endif
