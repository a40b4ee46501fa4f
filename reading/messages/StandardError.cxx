// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StandardError.h"

#include "vtkRelievoReaderProcess.h"

#include <initializer_list>

#include <fcntl.h>
#include <unistd.h>

namespace reading
{
namespace
{
bool Ours = false;
}

//------------------------------------------------------------------------------
void BeProgram()
{
  Ours = true;
  // A file opened later must not take a closed stream's descriptor, and with it printed output.
  for (const int each : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
  {
    if (fcntl(each, F_GETFD) < 0)
    {
      open("/dev/null", each == STDERR_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
  vtkRelievoReaderProcess::Start();
}

//------------------------------------------------------------------------------
std::FILE* StandardError()
{
  static std::FILE* const kept = [] {
    const int copy = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
    std::FILE* file = copy < 0 ? nullptr : fdopen(copy, "w");
    if (file)
    {
      std::setvbuf(file, nullptr, _IONBF, 0); // unbuffered, like stderr
    }
    return file ? file : stderr;
  }();
  return kept;
}

//------------------------------------------------------------------------------
bool FlushStandardOutput()
{
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

//------------------------------------------------------------------------------
SilentLibraries::SilentLibraries()
{
  if (!Ours)
  {
    return;
  }
  StandardError(); // copies the stream before it is redirected
  std::fflush(stderr);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0)
  {
    dup2(nowhere, STDERR_FILENO);
    close(nowhere);
  }
}

//------------------------------------------------------------------------------
SilentLibraries::~SilentLibraries()
{
  if (Ours)
  {
    std::fflush(stderr);
    dup2(fileno(StandardError()), STDERR_FILENO);
  }
}
}
