// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The settings that the window shows, and who is told when they change.
 */
#ifndef Document_h
#define Document_h

#include "Facts.h"
#include "History.h"
#include "Settings.h"

#include <QObject>
#include <QString>

#include <functional>
#include <optional>

namespace viewer
{
class Document : public QObject
{
  Q_OBJECT

public:
  explicit Document(QObject* parent = nullptr);

  /// Settings in the words of the command line, outputs left out; notes what a window does
  /// otherwise. Throws scene::UsageError.
  static scene::Settings FromWords(const std::vector<std::string>& words);

  const scene::Settings& Get() const { return this->Now; }

  /// Refuses settings that the command line would refuse. A number (MakeEdit): that of the edit
  /// that this is a part of, unless one is under way (BeginEdit).
  void Set(const scene::Settings& settings, int number = 0);
  void Change(const std::function<void(scene::Settings&)>& edit, int number = 0);

  /// These settings, known to be good, are a part of the edit before: undoing undoes both.
  void Amend(const scene::Settings& settings);

  /// Switched twice, shadows are as they were.
  void SwitchShadows(bool on);

  ///@{
  /// Goes back to settings that are known to be good: because the user wants so, or after a picture
  /// of the new ones failed.
  void Return(const scene::Settings& good);
  void Refuse(const scene::Settings& good, const QString& why);
  ///@}

  ///@{
  /// Edits are undone one by one, and done again.
  void Undo();
  void Redo();
  bool CanUndo() const { return this->Past.CanUndo(); }
  bool CanRedo() const { return this->Past.CanRedo(); }
  void ForgetPast();

  ///@}

  ///@{
  /// What changes from here on is one edit, until it ends or another begins: that of a slider that
  /// is dragged, or of a number that the wheel turns. Everything else is an edit of its own.
  int BeginEdit() { return this->UnderWay = this->MakeEdit(); }
  void EndEdit(int number) { this->UnderWay = this->UnderWay == number ? 0 : this->UnderWay; }

  /// The number of an edit whose parts come one by one, while others may be made.
  int MakeEdit() { return ++this->Edits; }
  ///@}

  ///@{
  /// Of what is shown.
  const Facts& GetFacts() const { return this->Known; }
  void SetFacts(const Facts& facts);
  ///@}

  /// That of the settings, or, where they leave it to that, of the files: 0, 1, 2 for x, y, z.
  int GetUpAxis() const;

Q_SIGNALS:
  /// What was asked for last is seen, or was refused.
  void shown();
  void changed();

  /// Others than before, to be shown; panels show them already.
  void asked();
  void factsChanged();
  void pastChanged();
  void refused(const QString& why);

private:
  void GoTo(const std::optional<scene::Settings>& settings);

  scene::Settings Now;
  History Past;
  int Edits = 0;
  int UnderWay = 0; // an edit's number; 0: none
  Facts Known;
  scene::Settings Unswitched, Switched; // before and after shadows were switched
};
}

#endif
