// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The picture as a Python program: VTK's readers, mappers and lights, and the package `relievo`.
 */
#ifndef PythonScript_h
#define PythonScript_h

#include "Picture.h"

#include <string>

namespace viewer
{
/// Writes the same picture, byte for byte, to `png`. Throws cli::WorkError that names what of the
/// picture Python's program cannot say.
std::string WritePython(Picture& picture, const Settings& settings, const std::string& png);
}

#endif
