// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * All lights of the picture: those of --light as a list for editing, and in grey the preset's and
 * the file's, which apply while there are no others.
 */
#ifndef LightsGroup_h
#define LightsGroup_h

#include "Document.h"
#include "FoldGroup.h"

#include <array>
#include <string>
#include <vector>

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace relievoQt
{
class Number;
}

namespace viewer
{
class LightEdit;

class LightsGroup : public FoldGroup
{
  Q_OBJECT

public:
  explicit LightsGroup(Document* document, QWidget* parent = nullptr);

  /// The user chose a place in the picture for the edited light.
  void Place(const std::array<double, 3>& place);

  /// Cancels waiting for a click in the picture.
  void StopPlacing();

  /// The user selected one of --light's lights, by index, for editing.
  void Select(int own);

  /// Selects a light by its name in reports, if the list has it.
  void SelectNamed(const QString& name);

Q_SIGNALS:
  /// The next click in the picture must be passed to Place; the text names its purpose; empty:
  /// cancelled.
  void placing(const QString& hint);

  /// Index of the edited light among those of --light; -1: none.
  void selected(int own);

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Row
  {
    std::string Word; // empty: not in the words
    QString Name, Kind, Tip;
    int Own = -1;     // index among --light's; -1: none
    bool IsOn = true; // whether it shines
    bool CanOwn = false;

    bool operator==(const Row& other) const;
  };

  QWidget* MakeButtons();
  void AddFill();
  std::vector<Row> FindLights() const;
  void AddPresets(std::vector<Row>& rows, bool own) const;
  const Row* GetCurrent() const;
  void ShowSettings();
  void ShowList(const std::vector<Row>& rows);
  void ShowCurrent();
  void ShowFill();
  void Add(const std::string& word);
  void Duplicate();
  void Remove();
  void MakeOwn();
  void TakeEdit(const std::string& before, const std::string& after);
  void Rename(QTreeWidgetItem* item);
  void SetLight(int place, const std::string& word, bool ownZone = false);

  Document* Edited;
  std::vector<Row> Rows;
  QTreeWidget* List;
  QPushButton *DuplicateButton, *RemoveButton, *OwnButton;
  QLabel* Note;
  LightEdit* Light;
  relievoQt::Number* Fill;
  QLabel* FillLabel;
};
}

#endif
