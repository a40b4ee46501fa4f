// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * All lights of the picture: those of --light as a list to edit, and in grey those of the preset
 * and of the file, which stand as long as there are no others.
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

  /// A place in the picture was chosen for the light that is edited.
  void Place(const std::array<double, 3>& place);

  /// No click in the picture is waited for any more.
  void StopPlacing();

  /// One of those of --light is edited, by its place among them.
  void Select(int own);

Q_SIGNALS:
  /// The next click in the picture is to be told to Place, and what it is for; empty: no longer.
  void placing(const QString& hint);

  /// Of those of --light, which is edited; -1: none.
  void selected(int own);

protected:
  void changeEvent(QEvent* event) override;

private:
  struct Row
  {
    std::string Word; // empty: it is said by no word
    QString Name, Kind, Tip;
    int Own = -1;     // its place among those of --light
    bool IsOn = true; // it lights
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
  void SetLight(int place, const std::string& word);

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
