// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A session in a file: the words of the command line with camera and size, and where the sun's
 * controls stand, as JSON.
 */
#ifndef SessionFile_h
#define SessionFile_h

#include "Settings.h"
#include "Sun.h"

#include <QString>

namespace viewer
{
struct Session
{
  scene::Settings View; ///< with --camera and --size
  SunTime Sun;
  bool SunByTime = false;
};

/// Both throw scene::WorkError with the file's name. No half-written file is left.
void SaveSession(const QString& path, const Session& session);
Session LoadSession(const QString& path);
}

#endif
