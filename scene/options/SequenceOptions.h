// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Sequences of frames, and the effects of the options of models on other options.
 */
#ifndef SequenceOptions_h
#define SequenceOptions_h

#include "SceneNames.h"

#include <string>

namespace scene
{
struct RenderOptions;

/// Resolves how the options of models depend on each other. Throws UsageError if they are given and
/// no file can have bones.
void CheckModelOptions(RenderOptions& options);

/// Whether the options ask for several frames.
bool IsSequence(const RenderOptions& options);

/// Throws UsageError for options of sequences without a sequence or without each other, and if its
/// file names lack a number.
void CheckSequence(const RenderOptions& options);

/// Throws UsageError for outputs of which no frame can be drawn without the frames before it.
/// `option`: the one that asks for frames alone.
void CheckFramesAlone(const RenderOptions& options, const std::string& option);

/// The file name of a frame: %d or %04d becomes its number. "" for a name with no or several such
/// places.
std::string GetFrameName(const std::string& name, int frame);
}

#endif
