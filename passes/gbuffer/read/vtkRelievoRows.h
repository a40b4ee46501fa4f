// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Work on the rows of an image, in several threads.
#ifndef vtkRelievoRows_h
#define vtkRelievoRows_h

#include "vtkSMP.h"
#include "vtkSMPTools.h"

#include <cstdlib>
#include <cstring>
#include <string>

// Calls f(from, to) for pieces of 0 to rows, from several threads when the image is worth it. VTK's
// own choice of threads (vtkSMPTools) is kept, but for one: a VTK whose packager chose none, as
// Debian's ParaView, works in standard threads, unless VTK_SMP_BACKEND_IN_USE says otherwise.
template <typename Function>
void vtkRelievoForRows(int rows, int width, Function f)
{
  constexpr vtkIdType WorthThreads = 1 << 16;
  if (static_cast<vtkIdType>(rows) * width < WorthThreads)
  {
    f(vtkIdType(0), static_cast<vtkIdType>(rows));
    return;
  }
#if VTK_SMP_ENABLE_STDTHREAD
  if (std::strcmp(vtkSMPTools::GetBackend(), "Sequential") == 0 &&
    !std::getenv("VTK_SMP_BACKEND_IN_USE"))
  {
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(std::string("STDThread")), [&]() { vtkSMPTools::For(0, rows, f); });
    return;
  }
#endif
  vtkSMPTools::For(0, rows, f);
}

#endif
