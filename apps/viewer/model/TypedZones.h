// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A note among the settings: the words of the suns whose time zone was typed, and does not follow
 * the longitude, even where it is the longitude's. Undo and sessions bring it back; commands do not
 * have it.
 */
#ifndef TypedZones_h
#define TypedZones_h

#include "Settings.h"

#include <string>

namespace viewer
{
/// The note's name among the options.
constexpr const char* TypedZones = "(typed zones)";

/// Whether the settings note this of the light.
bool HasTypedZone(const scene::Settings& settings, const std::string& light);

/// Forgets the suns that are no longer among the lights.
void DropIdleZones(scene::Settings& settings);
}

#endif
