// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CrashGuard.h"

#include "vtkRelievoTemporaryFile.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <unistd.h>

namespace scene
{
namespace
{
constexpr int Signals[] = { SIGSEGV, SIGBUS, SIGABRT, SIGFPE };
volatile std::sig_atomic_t Guarding = 0;
int Terminal = STDERR_FILENO;
char Text[4096];
std::size_t TextSize = 0;
void (*Before[4])(int);

extern "C" void SayAndEnd(int)
{
  // Only what a signal handler may call.
  vtkRelievoTemporaryFile::RemoveAll();
  if (write(Terminal, Text, TextSize) < 0)
  {
    // There is nobody left to tell.
  }
  _exit(1);
}

// Some readers end the process by exit().
void SayIfGuarding()
{
  if (Guarding)
  {
    SayAndEnd(0);
  }
}
}

//------------------------------------------------------------------------------
CrashGuard::CrashGuard(const std::string& path)
{
  if (!IsProgram())
  {
    return;
  }
  const std::string text =
    "relievo: " + path + ": VTK's reader crashed on this file; is it whole?\n";
  TextSize = std::min(text.size(), sizeof(Text));
  std::memcpy(Text, text.data(), TextSize);
  Terminal = fileno(StandardError());
  static const int registered = std::atexit(SayIfGuarding);
  Guarding = registered == 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    Before[i] = std::signal(Signals[i], SayAndEnd);
  }
}

//------------------------------------------------------------------------------
CrashGuard::~CrashGuard()
{
  if (!IsProgram())
  {
    return;
  }
  Guarding = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    std::signal(Signals[i], Before[i]);
  }
}
}
