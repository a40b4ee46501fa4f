// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads files of data in a process of their own, where there is one (vtkRelievoReaderProcess).
 */
#ifndef Apart_h
#define Apart_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;

namespace scene
{
class Progress;

/// Makes something of a file, which may name others in its own folder and in these. Throws
/// UsageError or WorkError with its name.
using ReadingWork = vtkSmartPointer<vtkDataObject> (*)(
  const std::string& path, const std::vector<std::string>& folders, Progress& progress);

/// What the work makes of a file, with its notes, warnings, errors and the files that it opens as
/// if it were done here. Throws WorkError if the process of the file ends badly.
vtkSmartPointer<vtkDataObject> ReadApart(ReadingWork work, const std::string& path,
  const std::vector<std::string>& folders, Progress& progress);

/// While it lives: what the thread does once, instead of waiting, when another process reads a file
/// for it. It may be done never, and throws nothing.
class WhileReading
{
public:
  explicit WhileReading(std::function<void()> work);
  ~WhileReading();
  WhileReading(const WhileReading&) = delete;
  void operator=(const WhileReading&) = delete;
};
}

#endif
