// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Changes of settings for surface maps, materials and the environment.
 */
#ifndef SurfaceSettings_h
#define SurfaceSettings_h

#include "SceneNames.h"

#include <string>

namespace scene
{
class Settings;

/// Sets a value of --material or --environment, in words; "" removes it.
void SetSurfaceValue(Settings& settings, const std::string& name, const std::string& words);

/// Sets the file of --environment and keeps its other values; "" removes the option.
void SetEnvironmentFile(Settings& settings, const std::string& file, double rotation);

/// Removes the options that need --normal-map, --height-map or --environment when these are
/// missing, because they would be refused.
void DropIdleSurface(Settings& settings);
}

#endif
