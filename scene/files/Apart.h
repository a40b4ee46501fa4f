// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads data files in a separate process where one is available (vtkRelievoReaderProcess).
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

/// Makes an object from a file, which may name others in its own folder and in these. Throws
/// UsageError or WorkError naming the file.
using ReadingWork = vtkSmartPointer<vtkDataObject> (*)(
  const std::string& path, const std::vector<std::string>& folders, Progress& progress);

/// Returns the work's result for a file; notes, warnings, errors and opened files are reported as
/// if the work ran here. Throws WorkError if the reading process crashes.
vtkSmartPointer<vtkDataObject> ReadApart(ReadingWork work, const std::string& path,
  const std::vector<std::string>& folders, Progress& progress);

/// While it lives: work for this thread while another process reads a file for it, instead of
/// waiting. The work may never run, and must not throw.
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
