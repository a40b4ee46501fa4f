// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lamps, fog and markers as lines of Python.
 */
#ifndef PythonPoints_h
#define PythonPoints_h

#include <ostream>

namespace cli
{
struct RenderOptions;
}

namespace viewer
{
/// Calls relievo.lamps, fog and markers with data(reader, path), which the program has. What
/// stages say of all of them, such as the fog's mode, is not said here.
void WritePoints(std::ostream& out, const cli::RenderOptions& options);
}

#endif
