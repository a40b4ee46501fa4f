// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Threads for vtkSMPTools, also where VTK has more and takes one by default, as Debian's does.
#ifndef vtkRelievoThreads_h
#define vtkRelievoThreads_h

#include "vtkSMP.h" // for what VTK has
#include "vtkSMPTools.h"

#include <cstdlib>
#include <string>

// Runs the work. A backend that was chosen (vtkSMPTools::SetBackend, or the environment variable
// VTK_SMP_BACKEND_IN_USE) stays.
template <typename Work>
void vtkRelievoWithThreads(Work&& work)
{
#if VTK_SMP_ENABLE_STDTHREAD
  if (std::string(vtkSMPTools::GetBackend()) == "Sequential" &&
    !std::getenv("VTK_SMP_BACKEND_IN_USE"))
  {
    // The number of threads stays what vtkSMPTools::Initialize was given. Names in capitals, and so
    // no LocalScope: VTK makes capitals of them by the user's locale, and Turkish has no I for i.
    vtkSMPTools::SetBackend("STDTHREAD");
    work();
    vtkSMPTools::SetBackend("SEQUENTIAL");
    return;
  }
#endif
  work();
}

#endif
