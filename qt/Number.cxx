// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Number.h"

#include "DigitsBox.h"

#include <QDial>
#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace relievoQt
{
namespace
{
constexpr double MostSteps = 2000.0;
constexpr double Largest = 1e9; // limit of the spin box
constexpr int DialPixels = 56;

QDial* MakeDial(QWidget* parent)
{
  auto* dial = new QDial(parent);
  dial->setWrapping(true);
  dial->setNotchesVisible(true);
  dial->setNotchTarget(22.5);
  dial->setFixedSize(DialPixels, DialPixels);
  return dial;
}

// A dial begins at the bottom, a compass at the top: adds or subtracts half a turn.
int TurnHalf(int position, int around)
{
  return around > 0 ? ((position + around / 2) % around + around) % around : position;
}
}

//------------------------------------------------------------------------------
Number::Number(double least, double most, double step, int decimals, QWidget* parent, Kind kind)
  : QWidget(parent)
  , Least(std::max(least, -Largest))
  , Most(std::min(most, Largest))
  , Step(step)
  , Digits(new DigitsBox(this))
{
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Digits->setObjectName("digits");
  this->Digits->setDecimals(decimals);
  this->Digits->setRange(this->Least, this->Most);
  this->Digits->setSingleStep(step);
  this->Digits->setKeyboardTracking(false);
  this->Digits->setMinimumWidth(76);
  this->setFocusProxy(this->Digits);
  const double steps = (most - least) / step;
  if (steps <= MostSteps)
  {
    const int count = static_cast<int>(std::lround(steps));
    this->Slider = kind == DIAL ? static_cast<QAbstractSlider*>(MakeDial(this))
                                : new QSlider(Qt::Horizontal, this);
    this->Slider->setObjectName("slider");
    this->Slider->setRange(0, count);
    this->Slider->setPageStep(std::max(1, count / 10));
    this->Slider->installEventFilter(this); // a dial changes before it reports the press
    layout->addWidget(this->Slider, kind == DIAL ? 0 : 1);
    QWidget::setTabOrder(this->Slider, this->Digits);
    QObject::connect(this->Slider, &QAbstractSlider::valueChanged, this, [this](int position) {
      this->Digits->setValue(this->Least + this->Step * TurnHalf(position, this->Around));
    });
  }
  else if (decimals > 0) // relative precision for small and large numbers
  {
    this->Digits->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  }
  if (kind == DIAL)
  {
    this->Around = this->Slider->maximum();
    this->SetWrapping();
    layout->addStretch(1);
  }
  layout->addWidget(this->Digits, this->Slider ? 0 : 1);
  QObject::connect(this->Digits,
    static_cast<void (QDoubleSpinBox::*)(double)>(&QDoubleSpinBox::valueChanged), this,
    [this](double value) {
      this->Show(this->Wrap(value));
      this->Moved = this->Held;
      Q_EMIT this->edited(this->Value, this->Held);
    });
  this->Show(this->Digits->value());
}

//------------------------------------------------------------------------------
void Number::SetUnit(const QString& unit)
{
  this->Digits->SetUnit(unit);
}

//------------------------------------------------------------------------------
void Number::SetSpecial(const QString& text)
{
  this->Digits->setSpecialValueText(text);
}

//------------------------------------------------------------------------------
void Number::SetTypedRange(double least, double most)
{
  this->Digits->setRange(least, most);
}

//------------------------------------------------------------------------------
void Number::SetWrapping()
{
  this->Wrapping = true;
  const double around = this->Most - this->Least;
  this->SetTypedRange(this->Least - 10.0 * around, this->Most + 10.0 * around);
}

//------------------------------------------------------------------------------
void Number::SetClock()
{
  this->Digits->SetClock();
}

//------------------------------------------------------------------------------
void Number::AlignDigits()
{
  this->Digits->setAlignment(Qt::AlignRight);
  this->Digits->setFixedWidth(this->fontMetrics().horizontalAdvance("-000.000\u00b0") + 34);
  if (this->Slider && this->Around == 0)
  {
    this->Slider->setMinimumWidth(50);
  }
}

//------------------------------------------------------------------------------
double Number::Wrap(double value) const
{
  const double around = this->Most - this->Least;
  if (!this->Wrapping || (value >= this->Least && value <= this->Most))
  {
    return value;
  }
  return value - around * std::floor((value - this->Least) / around);
}

//------------------------------------------------------------------------------
void Number::SetValue(double value)
{
  if (!this->Held && value != this->Value) // keeps a text while the user types
  {
    this->Show(value);
  }
}

//------------------------------------------------------------------------------
void Number::Show(double value)
{
  this->Value = value;
  const double shown = this->Wrap(value);
  const QSignalBlocker quiet(this->Digits);
  this->Digits->setValue(shown);
  this->Digits->ShowUnit();
  if (this->Slider)
  {
    const QSignalBlocker quietSlider(this->Slider);
    const int position = static_cast<int>(std::lround((shown - this->Least) / this->Step));
    this->Slider->setValue(TurnHalf(position, this->Around));
  }
}

//------------------------------------------------------------------------------
bool Number::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::MouseButtonPress)
  {
    this->Held = true;
  }
  else if (event->type() == QEvent::MouseButtonRelease)
  {
    // A dial changes once more at its release.
    QTimer::singleShot(0, this, SLOT(LetGo()));
  }
  return this->QWidget::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
void Number::LetGo()
{
  this->Held = false;
  if (this->Moved)
  {
    this->Moved = false;
    Q_EMIT this->edited(this->Value, false);
  }
}
}
