// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CrashGuard.h"

#include "Outputs.h"

#include <algorithm>
#include <csignal>
#include <cstring>

#include <unistd.h>

namespace cli
{
namespace
{
constexpr int Signals[] = { SIGSEGV, SIGBUS, SIGABRT, SIGFPE };
char Text[4096];
std::size_t TextSize = 0;
void (*Before[4])(int);

extern "C" void SayAndEnd(int)
{
  // Only what a signal handler may call.
  Outputs::RemoveTemporaries();
  if (write(STDERR_FILENO, Text, TextSize) < 0)
  {
    // There is nobody left to tell.
  }
  _exit(1);
}
}

//------------------------------------------------------------------------------
CrashGuard::CrashGuard(const std::string& path)
{
  const std::string text =
    "relievo: " + path + ": VTK's reader crashed on this file; is it whole?\n";
  TextSize = std::min(text.size(), sizeof(Text));
  std::memcpy(Text, text.data(), TextSize);
  for (std::size_t i = 0; i < 4; ++i)
  {
    Before[i] = std::signal(Signals[i], SayAndEnd);
  }
}

//------------------------------------------------------------------------------
CrashGuard::~CrashGuard()
{
  for (std::size_t i = 0; i < 4; ++i)
  {
    std::signal(Signals[i], Before[i]);
  }
}
}
