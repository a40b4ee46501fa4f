// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Work that may run out of memory in several threads, where an exception would end the process.
#ifndef vtkRelievoForEach_h
#define vtkRelievoForEach_h

#include "vtkRelievoThreads.h"

#include <atomic>
#include <new>

// Runs work(i) for each i below `count`; each takes long. Lack of memory in a thread is thrown to
// the caller.
template <typename Work>
void vtkRelievoForEach(vtkIdType count, Work&& work)
{
  std::atomic<bool> lacks{ false };
  vtkRelievoWithThreads([&]() {
    vtkSMPTools::For(0, count, 1, [&](vtkIdType begin, vtkIdType end) {
      try
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          work(i);
        }
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

#endif
