// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A number as digits, with a slider before them where its steps are few, or with a dial. Values
 * given to it are not rounded: only what the user changes is as it is shown.
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
    DIAL // goes around like a compass: its least value is at the top
  };

  /// The slider goes from `least` to `most`.
  Number(double least, double most, double step, int decimals, QWidget* parent = nullptr,
    Kind kind = SLIDER);

  /// In the plural, if there is one: "texels" becomes "texel" behind a 1.
  void SetUnit(const QString& unit);

  /// What may be typed, where that is more than the slider's range.
  void SetTypedRange(double least, double most);

  /// Goes around: what is behind the end is shown and given from the beginning on, as with angles.
  void SetWrapping();

  /// What is shown instead of the least value.
  void SetSpecial(const QString& text);

  /// Hours are shown as on a clock, 15:30.
  void SetClock();

  /// Digits of one width, at the right: those of a column line up, whatever their ranges.
  void AlignDigits();

  /// Sends no signal. Does nothing while the mouse holds the slider.
  void SetValue(double value);
  double GetValue() const { return this->Value; }

Q_SIGNALS:
  /// `held`: the mouse holds the slider; when it lets go, the signal comes once more.
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
  bool Moved = false; // while it is held
  QAbstractSlider* Slider = nullptr;
  int Around = 0; // steps of a dial
  DigitsBox* Digits;
};
}

#endif
