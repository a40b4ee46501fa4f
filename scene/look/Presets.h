// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --preset: lights, shadows, ground, background and view by one name, for what no other option
 * says.
 */
#ifndef Presets_h
#define Presets_h

#include <set>
#include <string>
#include <vector>

namespace scene
{
struct RenderOptions;

/// "none" first, which is VTK's bare look.
std::vector<std::string> GetPresetNames();

/// Throws UsageError for a name that there is not.
void TakePreset(RenderOptions& options, const std::string& word);

/// Fills in what the preset has for options that were not given.
void ApplyPreset(RenderOptions& options, const std::set<std::string>& given);
}

#endif
