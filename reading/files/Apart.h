// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads data files in a separate process where one is available (vtkRelievoReaderProcess).
 */
#ifndef Apart_h
#define Apart_h

#include "ReadingNames.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;

namespace reading
{
class ReadContext;

/// Makes an object from a file. Throws UsageError or WorkError naming the file.
using ReadingWork = vtkSmartPointer<vtkDataObject> (*)(
  const std::string& path, ReadContext& context);

/// Returns the work's result for a file; notes, warnings, errors and opened files are reported as
/// if the work ran here. Throws WorkError if the reading process crashes.
vtkSmartPointer<vtkDataObject> ReadApart(
  ReadingWork work, const std::string& path, ReadContext& context);
}

#endif
