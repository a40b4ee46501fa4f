// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Qt's spin box without trailing zeros, with a unit that has a singular, and optionally with clock
 * times.
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

  /// The unit's plural.
  void SetUnit(const QString& unit);
  void SetClock();

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& place) const override;

  /// The unit for the present value.
  void ShowUnit();

private:
  QString Unit;
  bool Clock = false;
};
}

#endif
