// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Qt's box for a number, without zeros that say nothing, with a unit that knows its singular, and
 * with a clock's way to write hours.
 */
#ifndef DigitsBox_h
#define DigitsBox_h

#include <QDoubleSpinBox>
#include <QString>

namespace relievoQt
{
class DigitsBox : public QDoubleSpinBox
{
  Q_OBJECT

public:
  explicit DigitsBox(QWidget* parent = nullptr);

  /// In the plural.
  void SetUnit(const QString& unit);
  void SetClock();

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& place) const override;

  /// Of the value that it has.
  void ShowUnit();

private:
  QString Unit;
  bool Clock = false;
};
}

#endif
