// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --time, --times, --animation, --blend, --loop, --skin, --skeleton and --bone-weight: what models
 * with bones show.
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
  Off, ///< as the file holds the mesh
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
  double BlendWeight = 0.0;   ///< of it, 0 to 1
  bool Loop = false;          ///< whether it starts anew after its end
  bool Skeleton = false;      ///< whether bones are drawn, with their axes
  std::string BoneWeight;     ///< the bone whose weight gives the colour; empty: none
  bool FirstBone = false;     ///< whether points have the array first_bone
  SkinChoice Skin = SkinChoice::Linear;
  bool Given = false; ///< whether any of these was
};

/// The options that choose what models show, as they are written.
const std::vector<std::string>& GetModelOptions();

void TakeTime(RenderOptions& options, const std::string& word);
void TakeAnimation(RenderOptions& options, const std::string& word);
void TakeTimes(RenderOptions& options, const std::string& word);
void TakeBlend(RenderOptions& options, const std::string& word);
void TakeLoop(RenderOptions& options, const std::string& word);
void TakeSkeleton(RenderOptions& options, const std::string& word);
void TakeBoneWeight(RenderOptions& options, const std::string& word);

/// Sets what the options mean for each other. Throws UsageError if they are given and no file can
/// have bones, or if a sequence's files have no number in their names.
void CheckModelOptions(RenderOptions& options);

/// The name of a frame's file: %d or %04d is its number. "" for a name without a number, or with
/// several.
std::string GetFrameName(const std::string& name, int frame);
}

#endif
