// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NumberEdit.h"

#include <QDoubleSpinBox>
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
  , Step(step)
  , Digits(new QDoubleSpinBox(this))
{
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Digits->setObjectName("digits");
  this->Digits->setDecimals(decimals);
  this->Digits->setRange(this->Least, std::min(most, Largest));
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
    QObject::connect(this->Slider, &QSlider::valueChanged, this,
      [this](int position) { this->Digits->setValue(this->Least + position * this->Step); });
  }
  layout->addWidget(this->Digits, this->Slider ? 0 : 1);
  QObject::connect(this->Digits,
    static_cast<void (QDoubleSpinBox::*)(double)>(&QDoubleSpinBox::valueChanged), this,
    [this](double value) {
      this->SetValue(value);
      Q_EMIT this->edited(value);
    });
}

//------------------------------------------------------------------------------
void NumberEdit::SetUnit(const QString& unit)
{
  this->Digits->setSuffix(unit.isEmpty() ? QString() : " " + unit);
}

//------------------------------------------------------------------------------
void NumberEdit::SetValue(double value)
{
  const QSignalBlocker quiet(this->Digits);
  this->Digits->setValue(value);
  if (this->Slider)
  {
    const QSignalBlocker quietSlider(this->Slider);
    this->Slider->setValue(static_cast<int>(std::lround((value - this->Least) / this->Step)));
  }
}

//------------------------------------------------------------------------------
double NumberEdit::GetValue() const
{
  return this->Digits->value();
}
}
