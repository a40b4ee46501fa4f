// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The user's error output. Libraries print to it as well (libpng, assertions of VTK's readers):
 * without a file's name, and before the one line that matters.
 */
#ifndef StandardError_h
#define StandardError_h

#include <cstdio>

namespace scene
{
/// The process is the command or the viewer: its error output is ours, and files are read in other
/// processes. First thing in main(), before there are threads. Elsewhere, as in Python, what others
/// print stays theirs, and files are read in the process itself.
void BeProgram();

/// Where the command itself writes, also while libraries are silent.
std::FILE* StandardError();

/// Writes what is left of the standard output. False if any of it, also before, was lost.
bool FlushStandardOutput();

/// While it lives, what anybody else writes to the error output of a program of ours is dropped.
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
