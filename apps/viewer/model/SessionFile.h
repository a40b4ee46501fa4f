// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A session file: the words of the command line with camera and size, as JSON. Paths in the
 * session's folder and below are relative, so that they can be moved together.
 */
#ifndef SessionFile_h
#define SessionFile_h

#include "CameraPath.h"
#include "Settings.h"

#include <QString>

#include <vector>

namespace viewer
{
struct Session
{
  scene::Settings View;
  std::vector<scene::CameraKey> Keys; ///< of the camera's path
};

/// Both throw words::WorkError with the file's name. Files are written completely or not at all,
/// and --camera-path reads them as well.
void SaveSession(const QString& path, const Session& session);
Session LoadSession(const QString& path);
}

#endif
