// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --time, --animation and --skin: what models with bones show.
 */
#ifndef ModelOptions_h
#define ModelOptions_h

#include <optional>
#include <string>

namespace cli
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
  std::string Animation;      ///< empty: the first
  SkinChoice Skin = SkinChoice::Linear;
  bool Given = false; ///< whether any of these was
};

void TakeTime(RenderOptions& options, const std::string& word);
void TakeAnimation(RenderOptions& options, const std::string& word);
void TakeSkin(RenderOptions& options, const std::string& word);

/// Throws WordsError if these options are given and no file can have bones.
void CheckModelOptions(const RenderOptions& options);
}

#endif
