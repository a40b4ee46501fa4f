// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoSunControls.h"

#include "pqRelievoNumber.h"
#include "vtkPVRelievoView.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDate>
#include <QDateEdit>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <cmath>

namespace
{
const QString Degrees = QString(QChar(0x00b0));

QString GetClock(double hour)
{
  const int minutes = static_cast<int>(std::lround(60.0 * hour));
  return QString("%1:%2").arg(minutes / 60).arg(minutes % 60, 2, 10, QChar('0'));
}
}

//------------------------------------------------------------------------------
pqRelievoSunControls::pqRelievoSunControls(QWidget* parent)
  : Superclass(parent)
  , On(new QCheckBox("Sun", this))
  , Rest(new QWidget(this))
{
  this->On->setObjectName("on");
  MakeHead(this->On);
  this->On->setToolTip("A light that stays where it is when the camera moves");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->On);
  layout->addWidget(this->Rest);
  this->Rest->setObjectName("rest");
  auto* parts = new QVBoxLayout(this->Rest);
  parts->setContentsMargins(0, 0, 0, 0);

  auto* head = new QWidget(this->Rest);
  head->setObjectName("head");
  QFormLayout* rows = MakeRows(head);
  auto* by = new QComboBox(head);
  by->setObjectName("by");
  by->addItem("Angles", 0);
  by->addItem("Date and place", 1);
  AddRow(rows, "Placed by", by);
  this->Bind(by, "RelievoSunBy", "Sun placed by");
  this->Angles = this->MakeAngles();
  this->DateAndPlace = this->MakeDateAndPlace();
  this->Place = new QLabel(this->Rest);
  this->Place->setObjectName("place");
  this->Place->setWordWrap(true);

  auto* foot = new QWidget(this->Rest);
  foot->setObjectName("foot");
  rows = MakeRows(foot);
  this
    ->AddNumber(rows, "Brightness", new pqRelievoNumber(pqRelievoNumber::SLIDER, 0, 2, 0.01, foot),
      "RelievoSunIntensity", "1 lights a white surface that faces the sun fully")
    ->SetTypedRange(0.0, 1000.0);
  this->AddNumber(rows, "Fill", new pqRelievoNumber(pqRelievoNumber::SLIDER, 0, 1, 0.01, foot),
    "RelievoSunFill", "Light from the other sides, without shadows: it shows form in the shade");
  auto* up = new QComboBox(foot);
  up->setObjectName("up");
  up->addItem("x", 0);
  up->addItem("y", 1);
  up->addItem("z", 2);
  up->setToolTip("The axis of the data that points up. North is then z, -z or y");
  AddRow(rows, "Up", up);
  this->Bind(up, "RelievoSunUpAxis", "Up axis of the sun");
  for (QWidget* part :
    { head, this->Angles, this->DateAndPlace, static_cast<QWidget*>(this->Place), foot })
  {
    parts->addWidget(part);
  }
  QObject::connect(this->On, &QCheckBox::toggled, this,
    [this](bool on) { pqRelievoViewSettings::SetSun(this->View, on); });
}

//------------------------------------------------------------------------------
pqRelievoNumber* pqRelievoSunControls::AddNumber(QFormLayout* rows, const QString& title,
  pqRelievoNumber* number, const char* property, const char* tip)
{
  number->setObjectName(QString(property).remove("RelievoSun").toLower());
  number->setToolTip(tip);
  AddRow(rows, title, number);
  this->Bind(number, property, "Sun: " + title.toLower());
  return number;
}

//------------------------------------------------------------------------------
QWidget* pqRelievoSunControls::MakeAngles()
{
  auto* angles = new QWidget(this->Rest);
  angles->setObjectName("angles");
  QFormLayout* rows = MakeRows(angles);
  this
    ->AddNumber(rows, "Azimuth", new pqRelievoNumber(pqRelievoNumber::DIAL, 0, 360, 1, angles),
      "RelievoSunAzimuth", "From north, clockwise seen from above: 90 is east, 180 south")
    ->SetUnit(pqRelievoNumber::TURNS);
  auto* elevation = this->AddNumber(rows, "Elevation",
    new pqRelievoNumber(pqRelievoNumber::SLIDER, 0, 90, 1, angles), "RelievoSunElevation",
    "Above the horizon. Below 0, which can be typed, the sun lights from beneath");
  elevation->SetTypedRange(-90.0, 90.0);
  elevation->SetUnit(pqRelievoNumber::DEGREES);
  return angles;
}

//------------------------------------------------------------------------------
QWidget* pqRelievoSunControls::MakeDateAndPlace()
{
  auto* all = new QWidget(this->Rest);
  all->setObjectName("dateAndPlace");
  QFormLayout* rows = MakeRows(all);
  this->Date = new QDateEdit(all);
  this->Date->setObjectName("date");
  this->Date->setDisplayFormat("yyyy-MM-dd");
  this->Date->setCalendarPopup(true);
  this->Date->setDateRange(QDate(1900, 1, 1), QDate(2100, 12, 31));
  AddRow(rows, "Date", this->Date);
  this->Clock = new QLabel("Time", all);
  auto* time = new pqRelievoNumber(pqRelievoNumber::SLIDER, 0, 24, 0.05, all);
  this->AddNumber(rows, "Time", time, "RelievoSunTime", "What the clock says, in hours");
  this->Clock->setObjectName("clock");
  AddRow(rows, "Clock", this->Clock);
  struct
  {
    const char* Title;
    const char* Property;
    double Most;
    const char* Tip;
  } const places[] = { { "Latitude", "RelievoSunLatitude", 90.0, "North is positive" },
    { "Longitude", "RelievoSunLongitude", 180.0, "East is positive" } };
  for (const auto& place : places)
  {
    auto* number = new pqRelievoNumber(pqRelievoNumber::SLIDER, -place.Most, place.Most, 0.01, all);
    this->AddNumber(rows, place.Title, number, place.Property, place.Tip)
      ->SetUnit(pqRelievoNumber::DEGREES);
  }
  auto* zone = new pqRelievoNumber(pqRelievoNumber::SLIDER, -12, 14, 0.25, all);
  this->AddNumber(rows, "Time zone", zone, "RelievoSunTimeZone",
    "Hours that the clock is ahead of universal time (UTC), summer time included");
  QObject::connect(this->Date, &QDateEdit::dateChanged, this, [this](const QDate& date) {
    this->Apply(
      "Sun: date", { { "RelievoSunDate", QVariantList{ date.year(), date.month(), date.day() } } });
  });
  return all;
}

//------------------------------------------------------------------------------
void pqRelievoSunControls::ShowState()
{
  this->Superclass::ShowState();
  const QSignalBlocker quiet[] = { QSignalBlocker(this->On), QSignalBlocker(this->Date) };
  this->On->setChecked(this->IsOn("RelievoSun"));
  this->Rest->setVisible(this->On->isChecked());
  const bool byDate = this->IsOn("RelievoSunBy");
  this->Angles->setVisible(!byDate);
  this->DateAndPlace->setVisible(byDate);
  const QVariantList date = this->Get("RelievoSunDate").toList();
  if (date.size() == 3)
  {
    const QDate first(date[0].toInt(), date[1].toInt(), 1);
    this->Date->setDate(first.addDays(date[2].toInt() - 1)); // 30 February is in March
  }
  this->Clock->setText(GetClock(this->Get("RelievoSunTime").toDouble()));
  this->ShowPlace();
}

//------------------------------------------------------------------------------
void pqRelievoSunControls::ShowPlace()
{
  const bool byDate = this->IsOn("RelievoSunBy");
  vtkPVRelievoView* here = pqRelievoViewSettings::FindHere(this->View);
  QString text;
  if (here && byDate)
  {
    const double* angles = here->GetSunAngles();
    text = QString("Azimuth %1%3, elevation %2%3")
             .arg(angles[0], 0, 'f', 1)
             .arg(angles[1], 0, 'f', 1)
             .arg(Degrees);
    text += angles[1] > 0.0 ? "" : ": night. The sun is below the horizon and gives no light.";
  }
  else if (here && this->Get("RelievoSunElevation").toDouble() < 0.0)
  {
    text = "Below the horizon: the sun lights from beneath.";
  }
  this->Place->setText(text);
  this->Place->setVisible(!text.isEmpty());
}
