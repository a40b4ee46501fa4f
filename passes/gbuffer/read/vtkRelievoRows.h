// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Loops over the rows of an image, in several threads.
#ifndef vtkRelievoRows_h
#define vtkRelievoRows_h

#include "vtkRelievoThreads.h"

// Calls f(from, to) for ranges of 0 to rows, from several threads if the image is large enough.
template <typename Function>
void vtkRelievoForRows(int rows, int width, Function f)
{
  constexpr vtkIdType WorthThreads = 1 << 16;
  if (static_cast<vtkIdType>(rows) * width < WorthThreads)
  {
    f(vtkIdType(0), static_cast<vtkIdType>(rows));
    return;
  }
  vtkRelievoWithThreads([&]() { vtkSMPTools::For(0, rows, f); });
}

#endif
