// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The present picture as a shell command or a Python program.
 */
#ifndef Scripts_h
#define Scripts_h

#include "CameraPath.h"
#include "Settings.h"

#include <string>
#include <vector>

namespace viewer
{
/// `relievo render ...` for a shell, one line. `view`: settings with camera and size.
std::string WriteCommand(const scene::Settings& view, const std::string& png);

/// A shell's lines that write the views of a camera path to a new camera-path.csv and draw the
/// film.
std::string WriteFilmCommand(
  const scene::Settings& view, const std::vector<scene::CameraKey>& keys, const std::string& film);

/// A Python program that writes the picture to `png` with the package `relievo`.
std::string WritePython(const scene::Settings& view, const std::string& png);
}

#endif
