// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The result of a comparison with a baseline: its pictures, and the causes of the differences as a
 * table.
 */
#ifndef ComparisonPanel_h
#define ComparisonPanel_h

#include "ComparisonView.h"

#include "vtkRelievoFrameComparison.h"
#include "vtkSmartPointer.h"

#include <QString>
#include <QStringList>
#include <QWidget>

#include <array>

class QJsonObject;
class QLabel;
class QPushButton;
class QRadioButton;
class QTableWidget;

namespace viewer
{
class ComparisonPanel : public QWidget
{
  Q_OBJECT

public:
  explicit ComparisonPanel(QWidget* parent = nullptr);

  /// Shows the result of a comparison. `about` names the frames.
  void Show(vtkRelievoFrameComparison* comparison, const QString& about);

  /// The displayed comparison; null: none.
  vtkRelievoFrameComparison* GetComparison() const { return this->Compared; }

  /// Says whether the settings have changed since the comparison.
  void SetOutdated(bool on);

Q_SIGNALS:
  void againWanted();
  void reportWanted();

  /// The user chose a difference of this light.
  void lightChosen(const QString& name);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  QWidget* MakeKinds();
  void AddTable();
  void SetKind(ComparisonView::Kind kind);
  bool HoldKey(const QKeyEvent& event, bool isDown);
  void Hold(bool on);
  void ShowCauses(const QJsonObject& result);
  void AddRow(int cause, const QString& word, const QStringList& cells, double pixels);
  void ShowChosen();

  vtkSmartPointer<vtkRelievoFrameComparison> Compared;
  std::map<int, QColor> Colors; // by cause
  ComparisonView::Kind Kind = ComparisonView::CAUSES;
  int Clicked = -1; // row
  QLabel *Summary, *About, *Outdated, *Notes;
  std::array<QRadioButton*, 3> Kinds{};
  ComparisonView* View;
  QTableWidget* Table;
  QPushButton *Again, *Save;
};
}

#endif
