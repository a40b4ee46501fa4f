// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// relievo-reader: reads files for Python, ParaView and other programs (vtkRelievoReaderProcess).
#include "vtkRelievoReaderProcess.h"

#include <cstdio>

int main()
{
  if (vtkRelievoReaderProcess::Serve())
  {
    return 0;
  }
  std::fputs("relievo-reader: expected to be started by a program with Relievo's libraries, to "
             "read files\n",
    stderr);
  return 2;
}
