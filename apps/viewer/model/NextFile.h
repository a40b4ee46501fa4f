// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What stays where another file is opened in the place of those that are shown.
 */
#ifndef NextFile_h
#define NextFile_h

#include "Settings.h"

#include <QString>

namespace viewer
{
/// Drops the files, and what belongs to them: places in their coordinates, arrays, times, maps of
/// their surfaces, the layer that is shown. The preset, its look and suns stay. Returns what was
/// dropped, for people, such as "2 lights and the up axis", but for colours by an array, which come
/// back if the next file has it; empty: nothing.
QString DropFiles(scene::Settings& settings);
}

#endif
