// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads files of data in a process of their own, where there is one (vtkRelievoReaderProcess).
 */
#ifndef Apart_h
#define Apart_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;

namespace scene
{
class ReadContext;

/// Makes something of a file. Throws UsageError or WorkError with its name.
using ReadingWork = vtkSmartPointer<vtkDataObject> (*)(
  const std::string& path, ReadContext& context);

/// What the work makes of a file, with its notes, warnings, errors and the files that it opens as
/// if it were done here. Throws WorkError if the process of the file ends badly.
vtkSmartPointer<vtkDataObject> ReadApart(
  ReadingWork work, const std::string& path, ReadContext& context);
}

#endif
