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
class Settings;

/// "none" first, which is VTK's bare look.
std::vector<std::string> GetPresetNames();

/// Whether presets may set this parameter of a stage, where no words do.
bool IsOfPresets(const std::string& stage, const std::string& parameter);

/// Throws UsageError for a name that there is not.
void TakePreset(RenderOptions& options, const std::string& word);

/// Throws UsageError for what is no share.
void TakeFill(RenderOptions& options, const std::string& word);

/// Takes back --fill where no preset fills: it would be refused.
void DropIdleFill(Settings& settings);

///@{
/// The light that the preset of settings without --light has first, as a word of --light; "" if
/// there is none. OwnKeyLight gives it to the settings, which show the same picture then if they
/// had no lights.
std::string WriteKeyLight(const Settings& settings, int upAxis);
void OwnKeyLight(Settings& settings, int upAxis);
///@}

/// Fills in what the preset has for options that were not given. Throws UsageError for a --fill
/// that has no effect.
void ApplyPreset(RenderOptions& options, const std::set<std::string>& given);
}

#endif
