// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files that one run writes: all of them or none. Each is written beside its place under a
 * temporary name, `.NAME.PID.tmp.EXT`; Commit() moves them all into place. A run that fails, or is
 * ended by an interrupt, leaves what was there before.
 */
#ifndef Outputs_h
#define Outputs_h

#include <string>
#include <vector>

namespace scene
{
class Outputs
{
public:
  Outputs() = default;
  ~Outputs();
  Outputs(const Outputs&) = delete;
  void operator=(const Outputs&) = delete;

  /// A file is going to be written. `option` is named in errors. Fails early: WorkError for a place
  /// that cannot be written, UsageError for a place that is an input or another output.
  void Add(
    const std::string& option, const std::string& path, const std::vector<std::string>& inputs);

  /// The temporary name to write to instead of the path given to Add().
  std::string Temporary(const std::string& path) const;

  /// A text with the temporary names in it replaced by the names that the user gave.
  std::string WithGivenNames(std::string text) const;

  /// Every file is written: moves them into place. WorkError if one cannot be; then all places have
  /// again what they had before.
  void Commit();

  /// From here on an interrupt that ends the run removes the temporary files first.
  static void RemoveOnSignals();

  /// Removes the temporary files; may be called from a signal handler.
  static void RemoveTemporaries();

private:
  struct Entry
  {
    std::string Given;     // as the user wrote it
    std::string Place;     // the same, links followed
    std::string Temporary; // beside Place
    std::string Kept;      // what was there before, until all are in place; empty: nothing
  };
  std::vector<Entry> Entries;
};
}

#endif
