// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is shown, as text to run elsewhere: it gives the same picture.
 */
#ifndef Scripts_h
#define Scripts_h

#include "Settings.h"

#include <string>

namespace viewer
{
/// `relievo render ...` for a shell, one line. `view`: settings with camera and size.
std::string WriteCommand(const scene::Settings& view, const std::string& png);

/// A Python program of the package `relievo`, which writes the picture to `png`.
std::string WritePython(const scene::Settings& view, const std::string& png);
}

#endif
