// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The window's settings; signals changes to the panels.
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
#include <set>
#include <string>

namespace viewer
{
class Document : public QObject
{
  Q_OBJECT

public:
  explicit Document(QObject* parent = nullptr);

  /// Parses settings from command-line words without outputs; notes differences in the window's
  /// behaviour. Throws words::UsageError.
  static scene::Settings FromWords(const std::vector<std::string>& words);

  const scene::Settings& Get() const { return this->Now; }

  /// Changes the settings; refuses those that the command line would refuse. `number` (from
  /// MakeEdit) joins the change to that edit, unless BeginEdit has begun one.
  void Set(const scene::Settings& settings, int number = 0);
  void Change(const std::function<void(scene::Settings&)>& edit, int number = 0);

  /// Joins these valid settings to the previous edit: undo reverts both.
  void Amend(const scene::Settings& settings);

  /// Switches shadows; switching twice restores them.
  void SwitchShadows(bool on);

  ///@{
  /// Returns to valid settings, by the user's wish or because a picture of the new ones failed.
  void Return(const scene::Settings& good);
  void Refuse(const scene::Settings& good, const QString& why);
  ///@}

  ///@{
  /// Undoes and redoes single edits.
  void Undo();
  void Redo();
  bool CanUndo() const { return this->Past.CanUndo(); }
  bool CanRedo() const { return this->Past.CanRedo(); }

  /// The settings after the next undo or redo; the present ones if there is none.
  const scene::Settings& GetPast() const { return this->Past.GetPast(this->Now); }
  const scene::Settings& GetFuture() const { return this->Past.GetFuture(this->Now); }
  void ForgetPast();

  ///@}

  ///@{
  /// Joins all following changes into one edit until it ends or another begins, as for dragging a
  /// slider or turning the wheel on a number. Other changes are edits of their own.
  int BeginEdit() { return this->UnderWay = this->MakeEdit(); }
  void EndEdit(int number) { this->UnderWay = this->UnderWay == number ? 0 : this->UnderWay; }

  /// Number of an edit whose parts arrive one by one, possibly between other edits.
  int MakeEdit() { return ++this->Edits; }
  ///@}

  ///@{
  /// Properties of the files shown.
  const Facts& GetFacts() const { return this->Known; }
  void SetFacts(const Facts& facts);
  ///@}

  /// The up axis of the settings, or else of the files: 0, 1, 2 for x, y, z.
  int GetUpAxis() const;

Q_SIGNALS:
  /// The last requested settings are visible, or were refused.
  void shown();
  void changed();

  /// The settings changed and must be shown; panels already show them.
  void asked();
  void factsChanged();
  void pastChanged();
  void refused(const QString& why);

private:
  void GoTo(const std::optional<scene::Settings>& settings);

  scene::Settings Now;
  History Past;
  int Edits = 0;
  int UnderWay = 0; // number of the edit in progress; 0: none
  Facts Known;
  scene::Settings Unswitched, Switched; // before and after the last switch of shadows
};
}

#endif
