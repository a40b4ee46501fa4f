// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Settings as they were before each edit, to go back to and forth again. Changes of one number, as
 * those of a slider that is dragged, are one edit.
 */
#ifndef History_h
#define History_h

#include "Settings.h"

#include <optional>
#include <vector>

namespace viewer
{
class History
{
public:
  /// A change that is an edit of its own, or, with a number, of one edit with those that came right
  /// before it with the same number.
  void Add(const scene::Settings& before, const scene::Settings& after, int number = 0);

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
  int Number = 0; // of the last edit; 0: nothing goes on with it
};
}

#endif
