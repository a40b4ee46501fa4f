// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs vtkSMPTools in several threads, even if VTK's default is one thread, as in Debian.
#ifndef vtkRelievoThreads_h
#define vtkRelievoThreads_h

#include "vtkSMP.h" // for VTK's backends
#include "vtkSMPTools.h"

#include <atomic>
#include <cstdlib>
#include <new>
#include <string>

// Runs the work. A backend chosen by the user (vtkSMPTools::SetBackend, or the environment variable
// VTK_SMP_BACKEND_IN_USE) is kept.
template <typename Work>
void vtkRelievoWithThreads(Work&& work)
{
#if VTK_SMP_ENABLE_STDTHREAD
  if (std::string(vtkSMPTools::GetBackend()) == "Sequential" &&
    !std::getenv("VTK_SMP_BACKEND_IN_USE"))
  {
    // The number of threads remains that of vtkSMPTools::Initialize. Names are in capitals, and so
    // without LocalScope: VTK converts names to capitals by the user's locale, and Turkish has no I
    // for i.
    struct Restore
    {
      ~Restore() { vtkSMPTools::SetBackend("SEQUENTIAL"); }
    } const restore;
    vtkSMPTools::SetBackend("STDTHREAD");
    work();
    return;
  }
#endif
  work();
}

// Runs work(from, to) for ranges of `grain` numbers (0: of VTK's choice) from `begin` up to `end`.
// Lack of memory in a thread, where an exception would end the process, is thrown to the caller.
template <typename Work>
void vtkRelievoForRanges(vtkIdType begin, vtkIdType end, vtkIdType grain, Work&& work)
{
  std::atomic<bool> lacks{ false };
  vtkRelievoWithThreads([&]() {
    vtkSMPTools::For(begin, end, grain, [&](vtkIdType from, vtkIdType to) {
      try
      {
        work(from, to);
      }
      catch (const std::bad_alloc&)
      {
        lacks = true;
      }
    });
  });
  if (lacks)
  {
    throw std::bad_alloc();
  }
}

// Runs work(i) for each i below `count`.
template <typename Work>
void vtkRelievoForAll(vtkIdType count, Work&& work, vtkIdType grain = 0)
{
  vtkRelievoForRanges(0, count, grain, [&](vtkIdType from, vtkIdType to) {
    for (vtkIdType i = from; i < to; ++i)
    {
      work(i);
    }
  });
}

#endif
