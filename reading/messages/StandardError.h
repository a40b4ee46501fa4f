// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The user's error output. Libraries also print to it (libpng, assertions of VTK's readers),
 * without a file's name and before the line that matters.
 */
#ifndef StandardError_h
#define StandardError_h

#include "ReadingNames.h"

#include <cstdio>

namespace reading
{
/// Declares that the process is the command or the viewer: its error output is ours, and files are
/// read in other processes. Call it first in main(), before threads start. In other programs, such
/// as Python, the output of libraries stays, and files are read in the process itself.
void BeProgram();

/// The command's own output stream, also while libraries are silent.
std::FILE* StandardError();

/// Flushes the standard output. False if any of it, also earlier, was lost.
bool FlushStandardOutput();

/// While it lives, other output to the program's error stream is dropped.
class SilentLibraries
{
public:
  SilentLibraries();
  ~SilentLibraries();
  SilentLibraries(const SilentLibraries&) = delete;
  void operator=(const SilentLibraries&) = delete;
};
}

#endif
