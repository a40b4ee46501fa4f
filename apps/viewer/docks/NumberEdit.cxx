// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NumberEdit.h"

#include "DigitsBox.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
constexpr double MostSteps = 2000.0;
constexpr double Largest = 1e9; // a spin box shows no more
}

//------------------------------------------------------------------------------
NumberEdit::NumberEdit(double least, double most, double step, int decimals, QWidget* parent)
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
    this->Slider = new QSlider(Qt::Horizontal, this);
    this->Slider->setObjectName("slider");
    this->Slider->setRange(0, static_cast<int>(std::lround(steps)));
    layout->addWidget(this->Slider, 1);
    QWidget::setTabOrder(this->Slider, this->Digits);
    QObject::connect(this->Slider, &QSlider::valueChanged, this,
      [this](int position) { this->Digits->setValue(this->Least + position * this->Step); });
  }
  else if (decimals > 0) // small and large numbers alike
  {
    this->Digits->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  }
  layout->addWidget(this->Digits, this->Slider ? 0 : 1);
  QObject::connect(this->Digits,
    static_cast<void (QDoubleSpinBox::*)(double)>(&QDoubleSpinBox::valueChanged), this,
    &NumberEdit::OnEdited);
  this->SetValue(this->Digits->value());
}

//------------------------------------------------------------------------------
void NumberEdit::SetUnit(const QString& unit)
{
  this->Digits->SetUnit(unit);
}

//------------------------------------------------------------------------------
void NumberEdit::SetSpecial(const QString& text)
{
  this->Digits->setSpecialValueText(text);
}

//------------------------------------------------------------------------------
void NumberEdit::SetWrapping()
{
  this->Wrapping = true;
  const double around = this->Most - this->Least;
  this->Digits->setRange(this->Least - 10.0 * around, this->Most + 10.0 * around);
}

//------------------------------------------------------------------------------
void NumberEdit::SetClock()
{
  this->Digits->SetClock();
}

//------------------------------------------------------------------------------
double NumberEdit::Wrap(double value) const
{
  const double around = this->Most - this->Least;
  if (!this->Wrapping || (value >= this->Least && value <= this->Most))
  {
    return value;
  }
  return value - around * std::floor((value - this->Least) / around);
}

//------------------------------------------------------------------------------
void NumberEdit::OnEdited(double value)
{
  this->SetValue(this->Wrap(value));
  Q_EMIT this->edited(this->Value);
}

//------------------------------------------------------------------------------
void NumberEdit::SetValue(double value)
{
  this->Value = value;
  const double shown = this->Wrap(value);
  const QSignalBlocker quiet(this->Digits);
  this->Digits->setValue(shown);
  this->Digits->ShowUnit();
  if (this->Slider)
  {
    const QSignalBlocker quietSlider(this->Slider);
    this->Slider->setValue(static_cast<int>(std::lround((shown - this->Least) / this->Step)));
  }
}
}
