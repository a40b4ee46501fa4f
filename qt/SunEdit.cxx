// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunEdit.h"

#include "Number.h"
#include "Rows.h"

#include <QComboBox>
#include <QDateEdit>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace relievoQt
{
namespace
{
constexpr int LinesOfWords = 3;

QFormLayout* AddPart(QWidget* part, const char* name, QWidget* whole)
{
  part->setObjectName(name);
  whole->layout()->addWidget(part);
  return MakeRows(part);
}
}

//------------------------------------------------------------------------------
SunEdit::SunEdit(QWidget* parent)
  : QWidget(parent)
  , By(new QComboBox(this))
  , Date(new QDateEdit(QDate(2026, 6, 21), this))
  , Azimuth(new Number(0.0, 360.0, 1.0, 2, this, Number::DIAL))
  , Elevation(new Number(0.0, 90.0, 1.0, 2, this))
  , Time(new Number(0.0, 24.0, 1.0 / 12.0, 6, this))
  , Latitude(new Number(-90.0, 90.0, 0.1, 4, this))
  , Longitude(new Number(-180.0, 180.0, 0.2, 4, this))
  , TimeZone(new Number(-12.0, 14.0, 0.25, 2, this))
  , Angles(new QWidget(this))
  , Place(new QWidget(this))
  , Words(new QLabel(this))
{
  (new QVBoxLayout(this))->setContentsMargins(0, 0, 0, 0);
  QFormLayout* head = AddPart(new QWidget(this), "head", this);
  QFormLayout* angles = AddPart(this->Angles, "angles", this);
  QFormLayout* place = AddPart(this->Place, "dateAndPlace", this);
  this->By->setObjectName("by");
  this->By->addItem("Angles", 0);
  this->By->addItem("Date and place", 1);
  AddRow(head, "Placed by", this->By);
  this->Date->setObjectName("date");
  this->Date->setDisplayFormat("yyyy-MM-dd");
  this->Date->setCalendarPopup(true);
  this->Date->setDateRange(QDate(1900, 1, 1), QDate(2100, 12, 31));
  AddRow(place, "Date", this->Date);
  const struct
  {
    QFormLayout* Rows;
    Number* Edit;
    const char* Title;
    const char* Unit;
    const char* Tip;
  } numbers[] = { { angles, this->Azimuth, "Azimuth", "degrees",
                    "From north, clockwise seen from above: 90 is east, 180 south" },
    { angles, this->Elevation, "Elevation", "degrees",
      "Above the horizon. Below 0, which can be typed, the sun lights from beneath" },
    { place, this->Time, "Time", "", "Clock time" },
    { place, this->Latitude, "Latitude", "degrees", "North is positive" },
    { place, this->Longitude, "Longitude", "degrees", "East is positive" },
    { place, this->TimeZone, "Time zone", "h",
      "Hours that the clock is ahead of universal time (UTC), summer time included" } };
  for (const auto& number : numbers)
  {
    number.Edit->setObjectName(QString(number.Title).remove(' ').toLower());
    number.Edit->SetUnit(number.Unit);
    number.Edit->setToolTip(number.Tip);
    AddRow(number.Rows, number.Title, number.Edit);
  }
  this->Elevation->SetTypedRange(-90.0, 90.0);
  this->Time->SetClock();
  this->Words->setObjectName("place");
  this->Words->setWordWrap(true);
  this->Words->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  // Rows below must not move when the text changes from one line to three.
  this->Words->setMinimumHeight(LinesOfWords * this->Words->fontMetrics().lineSpacing());
  this->layout()->addWidget(this->Words);
  QObject::connect(this->By, static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged),
    this, &SunEdit::ShowRows);
  this->ShowRows();
}

//------------------------------------------------------------------------------
bool SunEdit::IsByPlace() const
{
  return this->By->currentIndex() == 1;
}

//------------------------------------------------------------------------------
void SunEdit::ShowRows()
{
  this->Angles->setVisible(!this->IsByPlace());
  this->Place->setVisible(this->IsByPlace());
}

//------------------------------------------------------------------------------
void SunEdit::SetWords(const QString& words)
{
  this->Words->setText(words);
  this->Words->setVisible(!words.isEmpty());
}

//------------------------------------------------------------------------------
QString SunEdit::NamePartOfDay(double elevation)
{
  return elevation > 0.0 ? "day"
    : elevation > -6.0   ? "civil twilight"
    : elevation > -12.0  ? "nautical twilight"
    : elevation > -18.0  ? "astronomical twilight"
                         : "night";
}

//------------------------------------------------------------------------------
QString SunEdit::WritePlace(double azimuth, double elevation, bool byPlace)
{
  if (!byPlace)
  {
    return elevation < 0.0 ? "Below the horizon: the sun lights from beneath." : "";
  }
  const QString part = NamePartOfDay(elevation);
  return elevation > 0.0
    ? QString("Day: the sun is %1\u00b0 above the horizon, at azimuth %2\u00b0")
        .arg(elevation, 0, 'f', 1)
        .arg(azimuth, 0, 'f', 1)
    : QString("%1: the sun is %2\u00b0 below the horizon and gives no light.")
        .arg(part.left(1).toUpper() + part.mid(1))
        .arg(-elevation, 0, 'f', 1);
}
}
