// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoEXRThreads.h"

#include <OpenEXR/ImfThreading.h>

#include <mutex>

namespace relievo::exr
{
//------------------------------------------------------------------------------
void StartThreads(int count)
{
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  if (count > Imf::globalThreadCount())
  {
    Imf::setGlobalThreadCount(count);
  }
}
}
