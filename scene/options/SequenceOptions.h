// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --times, and what else the options of models mean for the other options.
 */
#ifndef SequenceOptions_h
#define SequenceOptions_h

#include <string>

namespace scene
{
struct RenderOptions;

/// Sets what the options mean for each other. Throws UsageError if they are given and no file can
/// have bones, or if a sequence's files have no number in their names.
void CheckModelOptions(RenderOptions& options);

/// The name of a frame's file: %d or %04d is its number. "" for a name without a number, or with
/// several.
std::string GetFrameName(const std::string& name, int frame);
}

#endif
