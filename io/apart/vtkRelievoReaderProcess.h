// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads files apart from the program: what the libraries that read them do wrong (crash, loop, take
// all memory) ends another process. A program of ours has it fork a process at its start, which
// forks one more for each file; this one is limited in memory and time and hands back what it made
// of the file. Elsewhere, as in Python, there is none, and files are read in the process itself.
//
// Limits: 8 GiB of memory, 15 s of processor time and 60 s of waiting, as for a disk; for each MiB
// of the files that are opened 32 MiB and 2 s of both more. How long a file takes by the clock does
// not count, since that depends on what else the machine does.
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
  // Is told what is done and its share, and returns whether to go on.
  using Say = std::function<bool(const std::string& what, double share)>;

  // Runs in the process of one file. What it throws is a crash, but for std::bad_alloc.
  using Work = void (*)(relievo::ByteReader& asked, const Say& say, relievo::ByteWriter& made);

  // First thing in a program's main(), before there are threads. False where there can be no such
  // process.
  static bool Start();

  // Whether there is one to read files.
  static bool IsThere();

  // Its number; 0: there is none.
  static int GetProcess();

  // Does the work apart: `ask` writes what it is asked, `take` reads what it made. Returns "", or
  // what became of the reader, as "crashed (segmentation fault)". Threads may do so at once.
  static std::string Run(Work work, const std::function<void(relievo::ByteWriter&)>& ask,
    const Say& say, const std::function<void(relievo::ByteReader&)>& take);

  // Within such work: a file of this size is opened, which takes its memory and time.
  static void Allow(std::uint64_t size);

  // The least seconds of processor time and of waiting, for tests that do not wait so long. Before
  // there are threads that read.
  static void SetLimits(std::uint64_t processorSeconds, std::uint64_t waitingSeconds);

  // Within such work: a library says that it did not get memory, which a crash is then put down to.
  static void LackMemory();
};

#endif
