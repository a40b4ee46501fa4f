// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Undo and redo of settings. Changes of one number, such as a dragged slider's, form one edit.
 */
#ifndef History_h
#define History_h

#include "Settings.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace viewer
{
class History
{
public:
  /// Records a change: an edit of its own, or, with a number, joined to the directly preceding
  /// changes of that number.
  void Add(const scene::Settings& before, const scene::Settings& after, int number = 0);

  ///@{
  /// The settings to restore, given the present ones; none: there are no more.
  std::optional<scene::Settings> Undo(const scene::Settings& now);
  std::optional<scene::Settings> Redo(const scene::Settings& now);
  ///@}

  /// Forgets edits that led away from these settings, to which the program itself returned.
  void DropUntil(const scene::Settings& settings);

  void Clear();

  bool CanUndo() const { return !this->Past.empty(); }
  bool CanRedo() const { return !this->Future.empty(); }

  ///@{
  /// The settings that undoing or redoing restores, else the present ones.
  const scene::Settings& GetPast(const scene::Settings& now) const;
  const scene::Settings& GetFuture(const scene::Settings& now) const;
  ///@}

private:
  std::vector<scene::Settings> Past, Future;
  int Number = 0; // of the last edit; 0: closed
};
}

#endif
