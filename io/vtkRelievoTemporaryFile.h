// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A file that is written beside its place, and moved there when it is whole. All that Relievo
// writes under another name first is one, so that whatever ends the program finds them all.
#ifndef vtkRelievoTemporaryFile_h
#define vtkRelievoTemporaryFile_h

#include "vtkRelievoIOModule.h" // for the export macro

#include <string>
#include <system_error>

class VTKRELIEVOIO_EXPORT vtkRelievoTemporaryFile
{
public:
  // Makes an empty file in the folder, which must be new, of a name that nobody can know before:
  // `.relievo-NUMBER.tmp`. If that fails, says why and has no name.
  vtkRelievoTemporaryFile(const std::string& folder, std::error_code& trouble);
  // Removes the file, unless it was moved.
  ~vtkRelievoTemporaryFile();
  vtkRelievoTemporaryFile(const vtkRelievoTemporaryFile&) = delete;
  void operator=(const vtkRelievoTemporaryFile&) = delete;

  const std::string& GetName() const { return this->Name; }

  // Gives the file this name, in the place of what had it.
  void MoveTo(const std::string& place, std::error_code& trouble);

  // While it lives, a signal that ends the program waits, and so do all others of these.
  class VTKRELIEVOIO_EXPORT Uninterrupted
  {
  public:
    Uninterrupted();
    ~Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    void operator=(const Uninterrupted&) = delete;
  };

  // For programs: from here on, signals that end the program, and exit(), remove all such files
  // first. Signals that are ignored stay so.
  static void RemoveAtEnd();

  // Removes all such files of this process; may be called from a signal handler.
  static void RemoveAll();

private:
  std::string Name;
};

#endif
