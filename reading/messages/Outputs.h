// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files that one run writes: all of them or none. Each is written beside its place under a
 * temporary name, `.relievo-NUMBER.tmp`; Commit() moves them all into place. A run that fails, or
 * is ended by a signal, leaves what was there before.
 */
#ifndef Outputs_h
#define Outputs_h

#include "vtkRelievoTemporaryFile.h"

#include <memory>
#include <string>
#include <vector>

namespace scene
{
class Outputs
{
public:
  Outputs() = default;
  Outputs(const Outputs&) = delete;
  void operator=(const Outputs&) = delete;

  /// A file is going to be written. `option` is named in errors. Fails early: WorkError for a place
  /// that cannot be written, UsageError for a place that is an input or another output.
  void Add(
    const std::string& option, const std::string& path, const std::vector<std::string>& inputs);

  /// UsageError if what is at the place of an output is one of the files that are read.
  static void Check(
    const std::string& option, const std::string& path, const std::vector<std::string>& inputs);

  /// The temporary name to write to instead of the path given to Add().
  std::string Temporary(const std::string& path) const;

  /// A text with the temporary names in it replaced by the names that the user gave.
  std::string WithGivenNames(std::string text) const;

  /// Every file is written: moves them into place. WorkError if one cannot be; then all places have
  /// again what they had before.
  void Commit();

  /// From here on whatever ends the program removes the temporary files first.
  static void RemoveAtEnd();

private:
  struct Entry
  {
    std::string Given;                             // as the user wrote it
    std::string Place;                             // the same, links followed
    std::string Temporary;                         // the name of File
    std::unique_ptr<vtkRelievoTemporaryFile> File; // beside Place
    std::string Kept; // what was there before, until all are in place; empty: nothing
  };
  std::vector<Entry> Entries;
};
}

#endif
