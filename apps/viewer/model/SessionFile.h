// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A session in a file: the words of the command line with camera and size, as JSON. Files in its
 * folder and below are named from there, so that they may be moved together.
 */
#ifndef SessionFile_h
#define SessionFile_h

#include "Settings.h"

#include <QString>

namespace viewer
{
/// Both throw scene::WorkError with the file's name. No half-written file is left.
void SaveSession(const QString& path, const scene::Settings& view);
scene::Settings LoadSession(const QString& path);
}

#endif
