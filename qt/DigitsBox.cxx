// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DigitsBox.h"

#include <QLocale>
#include <QRegularExpression>

#include <cmath>

namespace relievoQt
{
namespace
{
const QString Degree = QString(QChar(0x00b0));

const QRegularExpression& GetClockForm()
{
  static const QRegularExpression form("^\\s*(\\d{1,2}):(\\d{0,2})\\s*$");
  return form;
}
}

//------------------------------------------------------------------------------
DigitsBox::DigitsBox(QWidget* parent)
  : QDoubleSpinBox(parent)
{
  QObject::connect(this,
    static_cast<void (QDoubleSpinBox::*)(double)>(&QDoubleSpinBox::valueChanged), this,
    [this] { this->ShowUnit(); });
}

//------------------------------------------------------------------------------
void DigitsBox::SetUnit(const QString& unit)
{
  this->Unit = unit == "degrees" ? Degree : unit;
  this->ShowUnit();
}

//------------------------------------------------------------------------------
void DigitsBox::ShowUnit()
{
  const bool plural = this->Unit.size() > 3 && this->Unit.endsWith('s');
  const bool one = std::abs(this->value()) == 1.0 && plural;
  const QString unit = one ? this->Unit.chopped(1) : this->Unit;
  const bool apart = !unit.isEmpty() && unit != Degree;
  const QString suffix = apart ? " " + unit : unit;
  if (suffix != this->suffix())
  {
    this->setSuffix(suffix);
  }
}

//------------------------------------------------------------------------------
void DigitsBox::SetClock()
{
  this->Clock = true;
  this->setValue(this->value());
}

//------------------------------------------------------------------------------
QString DigitsBox::textFromValue(double value) const
{
  if (this->Clock)
  {
    const int minutes = static_cast<int>(std::lround(60.0 * value));
    return QString("%1:%2").arg(minutes / 60).arg(minutes % 60, 2, 10, QChar('0'));
  }
  QString text = this->QDoubleSpinBox::textFromValue(value);
  if (text.contains(this->locale().decimalPoint()))
  {
    while (text.endsWith(this->locale().zeroDigit()))
    {
      text.chop(1);
    }
    if (text.endsWith(this->locale().decimalPoint()))
    {
      text.chop(1);
    }
  }
  return text;
}

//------------------------------------------------------------------------------
double DigitsBox::valueFromText(const QString& text) const
{
  const QRegularExpressionMatch clock = GetClockForm().match(text);
  return this->Clock && clock.hasMatch()
    ? clock.captured(1).toInt() + clock.captured(2).toInt() / 60.0
    : this->QDoubleSpinBox::valueFromText(text);
}

//------------------------------------------------------------------------------
QValidator::State DigitsBox::validate(QString& text, int& place) const
{
  const QRegularExpressionMatch clock = GetClockForm().match(text);
  if (!this->Clock || !clock.hasMatch())
  {
    return this->QDoubleSpinBox::validate(text, place);
  }
  const bool good = clock.captured(2).toInt() < 60 && this->valueFromText(text) <= this->maximum();
  return good ? QValidator::Acceptable : QValidator::Intermediate;
}
}
