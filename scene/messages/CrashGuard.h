// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CrashGuard_h
#define CrashGuard_h

#include "StandardError.h"

#include <string>

namespace scene
{
/// While it lives, a crash of the command or the viewer, or its end by exit(), is said in one
/// line that names the file being read, and ends it with exit status 1. Some of VTK's readers
/// (PLY's is one) crash on files that are cut short, and a user must not be left to guess which
/// of the files it was. What libraries print meanwhile is dropped.
class CrashGuard
{
public:
  explicit CrashGuard(const std::string& path);
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  void operator=(const CrashGuard&) = delete;

private:
  SilentLibraries Silence;
};
}

#endif
