// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A file that is written under a temporary name and moved when it is complete. Relievo uses it for
// all such files, so that all of them are removed when the program ends early.
#ifndef vtkRelievoTemporaryFile_h
#define vtkRelievoTemporaryFile_h

#include "vtkRelievoIOModule.h" // for the export macro

#include <string>
#include <system_error>

class VTKRELIEVOIO_EXPORT vtkRelievoTemporaryFile
{
public:
  // Makes a new, empty file in the folder, with an unpredictable name: `.relievo-NUMBER.tmp`, or
  // with another extension for code that chooses by it. On failure, sets `trouble` and has no name.
  vtkRelievoTemporaryFile(
    const std::string& folder, std::error_code& trouble, const char* extension = ".tmp");
  // Removes the file, unless it was moved.
  ~vtkRelievoTemporaryFile();
  vtkRelievoTemporaryFile(const vtkRelievoTemporaryFile&) = delete;
  void operator=(const vtkRelievoTemporaryFile&) = delete;

  const std::string& GetName() const { return this->Name; }

  // Moves the file to this name, replacing an existing file.
  void MoveTo(const std::string& place, std::error_code& trouble);

  // While it exists, signals that end the program wait, and other objects of this class block.
  class VTKRELIEVOIO_EXPORT Uninterrupted
  {
  public:
    Uninterrupted();
    ~Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    void operator=(const Uninterrupted&) = delete;
  };

  // For programs: from now on, signals that end the program, and exit(), first remove all such
  // files. Ignored signals stay ignored.
  static void RemoveAtEnd();

  // Removes all such files of this process; may be called from a signal handler.
  static void RemoveAll();

private:
  std::string Name;
};

#endif
