// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --preset: lights, shadows, ground, background and view by one name, unless other options set
 * them.
 */
#ifndef Presets_h
#define Presets_h

#include "SceneNames.h"

#include <string>
#include <vector>

namespace scene
{
struct RenderOptions;
class Settings;

/// "none" first: VTK's plain look.
std::vector<std::string> GetPresetNames();

/// A parameter of a stage that presets may set, if no option does.
struct PresetParameter
{
  std::string Stage, Parameter;
  std::string Off; ///< the value with which the stage does nothing; empty: none
};
const std::vector<PresetParameter>& GetPresetParameters();

///@{
/// The rows of --preset and --fill.
void AddPresetOption(OptionRows& rows, RenderOptions& options);
void AddFillOption(OptionRows& rows, RenderOptions& options);
///@}

/// Removes --fill if the preset has no fill lights, because it would be refused.
void DropIdleFill(Settings& settings);

///@{
/// The first light of the preset in settings without --light, as a word of --light; "" if there is
/// none. OwnKeyLight adds it to the settings, which then show the same picture if they had no
/// lights.
std::string WriteKeyLight(const Settings& settings, int upAxis);
void OwnKeyLight(Settings& settings, int upAxis);
///@}

/// Whether the preset adds a moon, because all lights of --light are suns below the horizon.
bool HasMoon(const Settings& settings);

/// Fills in the preset's values for options that were not given. Throws UsageError for a --fill
/// without effect.
void ApplyPreset(RenderOptions& options);
}

#endif
