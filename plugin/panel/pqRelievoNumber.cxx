// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoNumber.h"

#include <QDial>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int DialPixels = 56;
}

//------------------------------------------------------------------------------
pqRelievoNumber::pqRelievoNumber(Kind kind, double least, double most, double step, QWidget* parent)
  : Superclass(parent)
  , Least(least)
  , Step(step)
  , Round(kind == DIAL)
  , Digits(new QDoubleSpinBox(this))
{
  if (kind == DIAL)
  {
    auto* dial = new QDial(this);
    dial->setWrapping(true);
    dial->setNotchesVisible(true);
    dial->setNotchTarget(22.5);
    dial->setFixedSize(DialPixels, DialPixels);
    this->Slider = dial;
  }
  else
  {
    this->Slider = new QSlider(Qt::Horizontal, this);
    this->Slider->setMinimumWidth(50);
  }
  this->Slider->setObjectName("slider");
  this->Slider->setRange(0, static_cast<int>(std::lround((most - least) / step)));
  this->Slider->setPageStep(std::max(1, this->Slider->maximum() / 10));
  this->Digits->setObjectName("digits");
  this->Digits->setRange(least, most);
  this->Digits->setSingleStep(step);
  this->Digits->setDecimals(step >= 1.0 ? 0 : step >= 0.1 ? 1 : 2);
  this->Digits->setKeyboardTracking(false);
  this->Digits->setAlignment(Qt::AlignRight);
  this->Digits->setFixedWidth(this->fontMetrics().horizontalAdvance("-000.00\u00b0") + 34);

  this->Slider->setValue(this->GetPosition(this->Digits->value()));

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Slider, kind == DIAL ? 0 : 1);
  if (kind == DIAL)
  {
    layout->addStretch(1);
  }
  layout->addWidget(this->Digits);

  QObject::connect(this->Slider, &QAbstractSlider::valueChanged, this, &pqRelievoNumber::OnSlider);
  this->Slider->installEventFilter(this); // a dial moves before it says that it is held
  QObject::connect(
    this->Digits, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double value) {
      const QSignalBlocker quiet(this->Slider);
      this->Slider->setValue(this->GetPosition(value));
      Q_EMIT this->settled(value);
    });
}

//------------------------------------------------------------------------------
void pqRelievoNumber::SetTypedRange(double least, double most)
{
  this->Digits->setRange(least, most);
}

//------------------------------------------------------------------------------
void pqRelievoNumber::SetUnit(Unit unit)
{
  this->Turns = unit == TURNS;
  this->Digits->setSuffix(QString(QChar(0x00b0)));
  if (this->Turns)
  {
    this->SetTypedRange(-3600.0, 3600.0);
  }
}

//------------------------------------------------------------------------------
int pqRelievoNumber::GetPosition(double value) const
{
  const int position = static_cast<int>(std::lround((value - this->Least) / this->Step));
  const int count = this->Slider->maximum();
  return this->Round ? ((position + count / 2) % count + count) % count : position;
}

//------------------------------------------------------------------------------
void pqRelievoNumber::SetValue(double value)
{
  if (this->Turns && (value < 0.0 || value > 360.0))
  {
    value -= 360.0 * std::floor(value / 360.0);
  }
  if (this->Held || value == this->Digits->value())
  {
    return;
  }
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Slider), QSignalBlocker(this->Digits) };
  this->Digits->setValue(value);
  this->Slider->setValue(this->GetPosition(value));
}

//------------------------------------------------------------------------------
double pqRelievoNumber::GetValue() const
{
  return this->Digits->value();
}

//------------------------------------------------------------------------------
bool pqRelievoNumber::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->Slider && event->type() == QEvent::MouseButtonPress)
  {
    this->Held = true;
  }
  else if (watched == this->Slider && event->type() == QEvent::MouseButtonRelease)
  {
    // A dial moves once more when it is let go.
    QTimer::singleShot(0, this, [this] {
      this->Held = false;
      if (this->Trying)
      {
        this->Trying = false;
        Q_EMIT this->settled(this->Digits->value());
      }
    });
  }
  return this->Superclass::eventFilter(watched, event);
}

//------------------------------------------------------------------------------
void pqRelievoNumber::OnSlider(int position)
{
  // A dial begins at the bottom, a compass at the top.
  const int count = this->Slider->maximum();
  const double value =
    this->Least + this->Step * (this->Round ? (position + count / 2) % count : position);
  {
    const QSignalBlocker quiet(this->Digits);
    this->Digits->setValue(value);
  }
  if (this->Held)
  {
    this->Trying = true;
    Q_EMIT this->tried(value);
  }
  else
  {
    Q_EMIT this->settled(value);
  }
}
