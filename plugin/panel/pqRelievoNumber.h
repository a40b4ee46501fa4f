// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoNumber
 * @brief A number by a slider or a dial, and beside it as digits.
 *
 * While the slider is dragged the number is tried; when it is let go, at a click, a key, or a
 * number typed, it is settled.
 */
#ifndef pqRelievoNumber_h
#define pqRelievoNumber_h

#include <QString>
#include <QWidget>

class QAbstractSlider;
class QDoubleSpinBox;

class pqRelievoNumber : public QWidget
{
  Q_OBJECT
  using Superclass = QWidget;
  Q_PROPERTY(double value READ GetValue)

public:
  enum Kind
  {
    SLIDER,
    DIAL // goes round like a compass: its ends are one, its middle is at the bottom
  };

  /** The slider goes from `least` to `most`. */
  pqRelievoNumber(Kind kind, double least, double most, double step, QWidget* parent = nullptr);

  /** What may be typed, where that is more than the slider's range. */
  void SetTypedRange(double least, double most);

  enum Unit
  {
    DEGREES,
    TURNS // degrees that go round: any may be typed, from 0 to 360 are shown
  };
  void SetUnit(Unit unit);

  /** Shows a number; no signal is sent. Does nothing while the slider is dragged. */
  void SetValue(double value);
  double GetValue() const;

Q_SIGNALS:
  void tried(double value);
  void settled(double value);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void OnSlider(int position);
  int GetPosition(double value) const;

  double Least;
  double Step;
  bool Round;
  bool Turns = false;
  bool Held = false;   // the mouse holds the slider
  bool Trying = false; // and has moved it
  QAbstractSlider* Slider;
  QDoubleSpinBox* Digits;
};

#endif
