// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The settings that stay when other files replace the displayed ones.
 */
#ifndef NextFile_h
#define NextFile_h

#include "Settings.h"

#include <QString>

namespace viewer
{
/// Drops the files and settings tied to them: places in their coordinates, arrays, times, surface
/// maps, the displayed layer. The preset, its look and suns stay. Returns a description of the
/// dropped settings, such as "2 lights and the up axis", without colours by an array, which return
/// if the next file has it; empty: nothing was dropped.
QString DropFiles(scene::Settings& settings);
}

#endif
