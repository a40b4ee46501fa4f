// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Changes of settings in what surfaces wear.
 */
#ifndef SurfaceSettings_h
#define SurfaceSettings_h

#include <string>

namespace scene
{
class Settings;

/// Sets a value of --material or --environment, in words; "" takes it back.
void SetSurfaceValue(Settings& settings, const std::string& name, const std::string& words);

/// The word of --environment, whose other values stay; "" takes it back.
void SetEnvironmentFile(Settings& settings, const std::string& file, double rotation);

/// Takes back what --normal-map, --height-map and --environment were needed for, if they are gone:
/// it would be refused.
void DropIdleSurface(Settings& settings);
}

#endif
