// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A group of rows that folds to its title: by an arrow, and by itself while its switch is off. Rows
 * that few need are in a section of their own at its end, folded until it is opened.
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

  /// The rows of the section Advanced. It is there from the first call on.
  QFormLayout* GetAdvanced();

  /// Below all rows, those of the section Advanced too: where it comes and goes, no row moves.
  void AddBelow(QWidget* widget);

  /// The group's own arrow; what is switched on afterwards is unfolded.
  void Fold(bool folded);

  ///@{
  /// Of a title alone where the rows are folded: styles leave room for a frame.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  ///@}

protected:
  /// Rows were added or hidden.
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
