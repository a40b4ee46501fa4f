// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads files in a separate process: a crash, an endless loop or an exhausted memory in a reading
// library then ends only that process. A server process forks a process for each file, which is
// limited in memory and time and returns its result. Our programs fork the server at their start.
// Elsewhere, as in Python and ParaView, the server is the program relievo-reader, started with the
// first file. If it is not installed, which causes one warning, or if the environment variable
// RELIEVO_READ_HERE is set, files are read in the process itself.
//
// Limits: 8 GiB of memory, 15 s of processor time and 60 s of waiting, for example for a disk; in
// addition, for each MiB of opened files, 32 MiB and 2 s of both times. Elapsed time does not
// count, since it depends on the machine's other work.
#ifndef vtkRelievoReaderProcess_h
#define vtkRelievoReaderProcess_h

#include "vtkRelievoBytes.h"
#include "vtkRelievoIOModule.h" // for the export macro

#include <cstdint>
#include <functional>
#include <string>

class VTKRELIEVOIO_EXPORT vtkRelievoReaderProcess
{
public:
  // Gets a text on the current step and the share done; returns whether to go on.
  using Say = std::function<bool(const std::string& what, double share)>;

  // Runs in the process of one file. Any exception except std::bad_alloc counts as a crash.
  using Work = void (*)(relievo::ByteReader& asked, const Say& say, relievo::ByteWriter& made);

  // Forks the server. Must come first in a program's main(), before there are threads. False if no
  // such process is possible.
  static bool Start();

  // In relievo-reader: forks the server for the program that started it. False on failure.
  static bool Serve();

  // Whether there is a server process; starts relievo-reader if needed.
  static bool IsThere();

  // Its process number; 0: none.
  static int GetProcess();

  // Calls work(asked, say, made), which fills `made`, in another process, or here without a server.
  // All readers use this. Returns "", or the other process's failure as Run does.
  template <auto work, typename Asked, typename Made>
  static std::string Do(const Asked& asked, const Say& say, Made& made)
  {
    if (!IsThere())
    {
      work(asked, say, made);
      return "";
    }
    const auto answer = [](relievo::ByteReader& reader, const Say& tell,
                          relievo::ByteWriter& writer) {
      Made result;
      work(reader.Get<Asked>(), tell, result);
      writer(result);
    };
    return Run(
      answer, [&asked](relievo::ByteWriter& writer) { writer(asked); }, say,
      [&made](relievo::ByteReader& reader) { reader(made); });
  }

  // Does the work, a function of a shared library or of the program that called Start, in another
  // process: `ask` writes the request, `take` reads the result. Returns "", or the reader's
  // failure, for example "crashed (segmentation fault)". Thread-safe.
  static std::string Run(Work work, const std::function<void(relievo::ByteWriter&)>& ask,
    const Say& say, const std::function<void(relievo::ByteReader&)>& take);

  // Within a work: raises the limits for the size of an opened file.
  static void Allow(std::uint64_t size);

  // Sets the minimum limits, in seconds, of processor time and of waiting, so that tests are short.
  // To be called before threads read.
  static void SetLimits(std::uint64_t processorSeconds, std::uint64_t waitingSeconds);

  // Within a work: a library reports that it got no memory, which then explains a crash.
  static void LackMemory();
};

#endif
