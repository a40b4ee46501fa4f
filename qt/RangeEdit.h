// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Edits the values of the first and last colour: automatic, or typed.
 */
#ifndef RangeEdit_h
#define RangeEdit_h

#include <QString>
#include <QWidget>

#include <array>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace relievoQt
{
class RangeEdit : public QWidget
{
  Q_OBJECT

public:
  explicit RangeEdit(QWidget* parent = nullptr);

  void SetAutomaticToolTip(const QString& text);

  /// The unit of both values; empty: none.
  void SetUnit(const QString& unit);

  /// Empty texts: automatic. Emits no signal.
  void Show(const QString& least, const QString& most);

  /// Texts for the ends of an automatic range.
  void ShowFound(const std::array<double, 2>& range);

Q_SIGNALS:
  void automaticSwitched(bool on);
  /// Two numbers, in any order.
  void typed(const QString& least, const QString& most);

private:
  void Take();

  QCheckBox* Automatic;
  QLineEdit *Least, *Most;
  QLabel* Unit;
  QString Given[2];
};
}

#endif
