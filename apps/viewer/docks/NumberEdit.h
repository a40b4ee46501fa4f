// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A number as digits, with a slider before them where its range is small. Values given to it are
 * not rounded: only what the user changes is as it is shown.
 */
#ifndef NumberEdit_h
#define NumberEdit_h

#include <QWidget>

class QDoubleSpinBox;
class QSlider;

namespace viewer
{
class NumberEdit : public QWidget
{
  Q_OBJECT

public:
  NumberEdit(double least, double most, double step, int decimals, QWidget* parent = nullptr);

  void SetUnit(const QString& unit);

  /// Sends no signal.
  void SetValue(double value);
  double GetValue() const;

Q_SIGNALS:
  void edited(double value);

private:
  double Least, Step;
  QSlider* Slider = nullptr;
  QDoubleSpinBox* Digits;
};
}

#endif
