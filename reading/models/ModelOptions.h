// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --time, --times, --animation, --blend, --loop, --skin, --skeleton and --bone-weight: the pose and
 * the look of models with bones.
 */
#ifndef ModelOptions_h
#define ModelOptions_h

#include "ReadingNames.h"

#include <optional>
#include <string>
#include <vector>

namespace reading
{
enum class SkinChoice
{
  Off, ///< the mesh at rest
  Linear,
  DualQuaternion,
  KeyMatrix
};

struct ModelChoice
{
  std::optional<double> Time; ///< seconds; none: the animation's start
  std::vector<double> Times;  ///< of a sequence of frames; none: one picture
  std::string Animation;      ///< empty: the first
  std::string Blend;          ///< an animation to blend in; empty: none
  double BlendWeight = 0.0;   ///< weight of the blended animation, 0 to 1
  bool Loop = false;          ///< whether the animation repeats after its end
  bool Skeleton = false;      ///< whether to draw bones and their axes
  std::string BoneWeight;     ///< the bone whose weight gives the colour; empty: none
  bool FirstBone = false;     ///< whether points have the array first_bone
  SkinChoice Skin = SkinChoice::Linear;
  bool Given = false; ///< whether any option of models was given
};

/// The names of the options of models, for messages.
const std::vector<std::string>& GetModelOptions();

void TakeTime(ModelChoice& model, const std::string& word);
void TakeAnimation(ModelChoice& model, const std::string& word);
void TakeTimes(ModelChoice& model, const std::string& word);
void TakeBlend(ModelChoice& model, const std::string& word);
void TakeLoop(ModelChoice& model, const std::string& word);
void TakeSkeleton(ModelChoice& model, const std::string& word);
void TakeBoneWeight(ModelChoice& model, const std::string& word);

}

#endif
