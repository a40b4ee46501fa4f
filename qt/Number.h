// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A number as digits, with a slider if its steps are few, or with a dial. Values set by the program
 * are not rounded to the displayed digits, only the user's changes.
 */
#ifndef Number_h
#define Number_h

#include <QString>
#include <QWidget>

class QAbstractSlider;

namespace relievoQt
{
class DigitsBox;

class Number : public QWidget
{
  Q_OBJECT

public:
  enum Kind
  {
    SLIDER,
    DIAL // circular, with the least value at the top
  };

  /// The slider goes from `least` to `most`.
  Number(double least, double most, double step, int decimals, QWidget* parent = nullptr,
    Kind kind = SLIDER);

  /// The unit's plural, if there is one: "texels" becomes "texel" after a 1.
  void SetUnit(const QString& unit);

  /// The limits for typing, if wider than the slider's range.
  void SetTypedRange(double least, double most);

  /// Wraps around: values beyond the end continue from the beginning, as with angles.
  void SetWrapping();

  /// Text shown instead of the least value.
  void SetSpecial(const QString& text);

  /// Shows hours as on a clock, 15:30.
  void SetClock();

  /// Aligns digits of one width at the right, so that a column lines up for any ranges.
  void AlignDigits();

  /// Emits no signal. Does nothing while the mouse drags the slider.
  void SetValue(double value);
  double GetValue() const { return this->Value; }

Q_SIGNALS:
  /// `held`: the mouse drags the slider; its release emits the signal once more.
  void edited(double value, bool held);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private Q_SLOTS:
  void LetGo();

private:
  double Wrap(double value) const;
  void Show(double value);

  double Least, Most, Step;
  double Value = 0.0;
  bool Wrapping = false;
  bool Held = false;
  bool Moved = false; // changed during a drag
  QAbstractSlider* Slider = nullptr;
  int Around = 0; // steps of a dial
  DigitsBox* Digits;
};
}

#endif
