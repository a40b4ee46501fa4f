// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --times, and the effects of the options of models on other options.
 */
#ifndef SequenceOptions_h
#define SequenceOptions_h

#include <string>

namespace scene
{
struct RenderOptions;

/// Resolves how the options depend on each other. Throws UsageError if they are given and no file
/// can have bones, or if a sequence's file names lack a number.
void CheckModelOptions(RenderOptions& options);

/// The file name of a frame: %d or %04d becomes its number. "" for a name with no or several such
/// places.
std::string GetFrameName(const std::string& name, int frame);
}

#endif
