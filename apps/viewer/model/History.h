// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Settings as they were before each edit, to go back to and forth again. What follows soon and
 * changes the same, as a slider that is drawn, is one edit.
 */
#ifndef History_h
#define History_h

#include "Settings.h"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace viewer
{
class History
{
public:
  /// An edit, at a time in milliseconds, in the drag of a number that is not 0, or in none.
  void Add(
    const scene::Settings& before, const scene::Settings& after, std::int64_t time, int drag = 0);

  ///@{
  /// The settings to go to from those of now; none: there are no more.
  std::optional<scene::Settings> Undo(const scene::Settings& now);
  std::optional<scene::Settings> Redo(const scene::Settings& now);
  ///@}

  /// Edits that led away from these settings, to which the program itself went back, were none.
  void DropUntil(const scene::Settings& settings);

  void Clear();

  bool CanUndo() const { return !this->Past.empty(); }
  bool CanRedo() const { return !this->Future.empty(); }

private:
  std::vector<scene::Settings> Past, Future;
  std::set<std::string> Changed; // by the last edit
  std::int64_t Time = 0;         // of it
  int Drag = 0;                  // of it
};
}

#endif
