// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A number as digits, with a slider before them where its range is small. Values given to it are
 * not rounded: only what the user changes is as it is shown.
 */
#ifndef NumberEdit_h
#define NumberEdit_h

#include <QString>
#include <QWidget>

class QSlider;

namespace viewer
{
class DigitsBox;

class NumberEdit : public QWidget
{
  Q_OBJECT

public:
  NumberEdit(double least, double most, double step, int decimals, QWidget* parent = nullptr);

  /// In the plural, if there is one: "texels" becomes "texel" behind a 1.
  void SetUnit(const QString& unit);

  /// Goes around: what is behind the end is shown and given from the beginning on, as with angles.
  void SetWrapping();

  /// What is shown instead of the least value.
  void SetSpecial(const QString& text);

  /// Hours are shown as on a clock, 15:30.
  void SetClock();

  /// Sends no signal.
  void SetValue(double value);
  double GetValue() const { return this->Value; }

Q_SIGNALS:
  void edited(double value);

private:
  double Wrap(double value) const;
  void OnEdited(double value);

  double Least, Most, Step;
  double Value = 0.0;
  bool Wrapping = false;
  QSlider* Slider = nullptr;
  DigitsBox* Digits;
};
}

#endif
