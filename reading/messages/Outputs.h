// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Writes the files of one run: all of them or none. Each is written beside its place under a
 * temporary name, `.relievo-NUMBER.tmp`; Commit() moves them all into place. A run that fails, or
 * is ended by a signal, preserves the previous files.
 */
#ifndef Outputs_h
#define Outputs_h

#include "ReadingNames.h"
#include "vtkRelievoTemporaryFile.h"

#include <memory>
#include <string>
#include <vector>

namespace reading
{
class Outputs
{
public:
  Outputs() = default;
  Outputs(const Outputs&) = delete;
  void operator=(const Outputs&) = delete;

  /// Announces an output. `option` is named in errors. Fails early: WorkError for a place that
  /// cannot be written, UsageError for a place that is an input or another output.
  void Add(
    const std::string& option, const std::string& path, const std::vector<std::string>& inputs);

  /// Throws UsageError if the place of an output is one of the input files.
  static void Check(
    const std::string& option, const std::string& path, const std::vector<std::string>& inputs);

  /// The temporary name to write to, for a path given to Add().
  std::string Temporary(const std::string& path) const;

  /// Replaces temporary names in a text by the names that the user gave.
  std::string WithGivenNames(std::string text) const;

  /// Moves all files, which must be written, into place. WorkError if one cannot be moved; then all
  /// places have their previous contents again.
  void Commit();

  /// From now on, an interrupted program first removes the temporary files.
  static void RemoveAtEnd();

private:
  struct Entry
  {
    std::string Given;                             // as the user wrote it
    std::string Place;                             // Given, with links resolved
    std::string Temporary;                         // name of File
    std::unique_ptr<vtkRelievoTemporaryFile> File; // beside Place
    std::string Previous; // name of the previous file until all are in place; empty: none
  };
  std::vector<Entry> Entries;
};
}

#endif
