// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A group of rows that folds to its title: by an arrow, and automatically while its switch is off.
 * Expert rows are in a section at its end, folded until opened.
 */
#ifndef FoldGroup_h
#define FoldGroup_h

#include <QGroupBox>

class QFormLayout;
class QToolButton;
class QVBoxLayout;

namespace viewer
{
class FoldGroup : public QGroupBox
{
  Q_OBJECT

public:
  FoldGroup(const QString& title, const QString& name, QWidget* parent = nullptr);

  QFormLayout* GetRows() { return this->Rows; }

  /// The rows of the section Advanced, which the first call creates.
  QFormLayout* GetAdvanced();

  /// Adds a widget below all rows, those of Advanced too: showing it moves no row.
  void AddBelow(QWidget* widget);

  /// Adds the group's own arrow; switching on unfolds the group.
  void Fold(bool folded);

  ///@{
  /// The size of a title with folded rows, without the space that styles reserve for a frame.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  ///@}

protected:
  /// Call after adding or hiding rows.
  void Arrange();

  bool eventFilter(QObject* watched, QEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  QRect GetTitle() const;
  QSize Limit(QSize size) const;

  QWidget* Content;
  QVBoxLayout* Column;
  QFormLayout* Rows;
  QFormLayout* Advanced = nullptr;
  QWidget* Below = nullptr;
  QToolButton* Arrow;
  bool On = true;
  bool Folded = false;
};
}

#endif
