// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The present picture as a shell command or a Python program.
 */
#ifndef Scripts_h
#define Scripts_h

#include "Settings.h"

#include <string>

namespace viewer
{
/// `relievo render ...` for a shell, one line. `view`: settings with camera and size.
std::string WriteCommand(const scene::Settings& view, const std::string& png);

/// A Python program that writes the picture to `png` with the package `relievo`.
std::string WritePython(const scene::Settings& view, const std::string& png);
}

#endif
