// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/** The transforms of a model's nodes at a time of an animation. */
#ifndef vtkRelievoModelPose_h
#define vtkRelievoModelPose_h

#include "vtkRelievoModel.h"

namespace relievo
{
NodeParts GetParts(const glm::dmat4& m);

/// Node to parent for every node. Values stay constant before the first key and after the last.
/// `slerp`: rotations at constant speed, otherwise along the chord.
std::vector<glm::dmat4> GetLocalMatrices(
  const Model& model, const ModelAnimation& animation, double time, bool slerp);

/// Node to parent for every node, blended from two animations, each at its own time: `weight` is
/// the fraction from the first to the second. Parts that an animation does not move count as at
/// rest.
std::vector<glm::dmat4> GetBlendedMatrices(const Model& model, const ModelAnimation& first,
  double firstTime, const ModelAnimation& second, double secondTime, double weight, bool slerp);

/// The weights of morph targets by nodes, at rest or at a time of the animation.
std::vector<ModelWeights> GetMorphWeights(
  const Model& model, const ModelAnimation& animation, double time);

/// The bones' matrices that leave the meshes at rest, node to world; nodes that are not bones
/// follow their parents.
std::vector<glm::dmat4> GetBindMatrices(const Model& model);

/// The whole keys around a time: those of any track or, if `rate` is above 0, `rate` keys per
/// second from the start on, and the end.
struct KeySpan
{
  double Before;
  double After;
  double Share; ///< fraction between before and after
};

KeySpan GetKeySpan(const ModelAnimation& animation, double time, double rate);

/// The time within the animation: with `loop` it restarts after the end, otherwise it stops at the
/// ends.
double GetAnimationTime(const ModelAnimation& animation, double time, bool loop);
}

#endif
