// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --time, --times, --animation, --blend, --loop, --skin, --skeleton and --bone-weight: the pose and
 * the look of models with bones.
 */
#ifndef ModelOptions_h
#define ModelOptions_h

#include <optional>
#include <string>
#include <vector>

namespace scene
{
struct RenderOptions;

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

void TakeTime(RenderOptions& options, const std::string& word);
void TakeAnimation(RenderOptions& options, const std::string& word);
void TakeTimes(RenderOptions& options, const std::string& word);
void TakeBlend(RenderOptions& options, const std::string& word);
void TakeLoop(RenderOptions& options, const std::string& word);
void TakeSkeleton(RenderOptions& options, const std::string& word);
void TakeBoneWeight(RenderOptions& options, const std::string& word);

/// Resolves how the options depend on each other. Throws UsageError if they are given and no file
/// can have bones, or if a sequence's file names lack a number.
void CheckModelOptions(RenderOptions& options);

/// The file name of a frame: %d or %04d becomes its number. "" for a name with no or several such
/// places.
std::string GetFrameName(const std::string& name, int frame);
}

#endif
