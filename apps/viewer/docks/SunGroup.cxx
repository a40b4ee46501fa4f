// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunGroup.h"

#include "NumberEdit.h"
#include "Options.h"

#include <QComboBox>
#include <QDateEdit>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>

namespace viewer
{
namespace
{
const QString Degrees = QString(QChar(0x00b0));

bool IsSun(const std::string& word)
{
  return word.rfind("sun:", 0) == 0;
}

// How large it is stays as it was said.
std::string GetSize(const std::string& word)
{
  const std::string::size_type at = word.find(",size=");
  return at == std::string::npos ? "" : word.substr(at);
}

int GetUpAxis(const Settings& settings)
{
  const std::string up = settings.Get("--up");
  return up == "x" ? 0 : up == "z" ? 2 : 1;
}
}

//------------------------------------------------------------------------------
SunGroup::SunGroup(Document* document, QWidget* parent)
  : QGroupBox("Sun", parent)
  , Edited(document)
  , Rows(new QFormLayout(this))
  , By(new QComboBox(this))
  , Date(new QDateEdit(QDate(2026, 6, 21), this))
  , Words(new QLabel(this))
{
  this->setCheckable(true);
  this->setToolTip("A light that stays where it is when the camera moves");
  this->Rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  this->By->setObjectName("by");
  this->By->addItems({ "Angles", "Date and place" });
  this->Rows->addRow("Placed by", this->By);
  this->Azimuth = this->AddNumber("Azimuth", "azimuth", 0.0, 360.0, 1.0, 2, Degrees,
    "From north, clockwise seen from above: 90 is east, 180 south");
  this->Elevation =
    this->AddNumber("Elevation", "elevation", -90.0, 90.0, 1.0, 2, Degrees, "Above the horizon");
  this->Date->setObjectName("date");
  this->Date->setDisplayFormat("yyyy-MM-dd");
  this->Date->setCalendarPopup(true);
  this->Date->setDateRange(QDate(1900, 1, 1), QDate(2100, 12, 31));
  this->Rows->addRow("Date", this->Date);
  this->Hour =
    this->AddNumber("Time", "hour", 0.0, 24.0, 0.05, 2, "h", "What the clock says, in hours");
  this->Latitude =
    this->AddNumber("Latitude", "latitude", -90.0, 90.0, 0.1, 4, Degrees, "North is positive");
  this->Longitude =
    this->AddNumber("Longitude", "longitude", -180.0, 180.0, 0.2, 4, Degrees, "East is positive");
  this->TimeZone = this->AddNumber("Time zone", "timeZone", -12.0, 14.0, 0.25, 2, "h",
    "Hours that the clock is ahead of universal time (UTC), summer time included");
  this->Words->setObjectName("place");
  this->Words->setWordWrap(true);
  this->Rows->addRow(this->Words);
  this->SetTime(SunTime(), false);
  const auto place = [this] { this->Place(); };
  QObject::connect(
    this->By, static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), this, [this] {
      this->ShowRows();
      this->Place();
    });
  QObject::connect(this->Date, &QDateEdit::dateChanged, this, place);
  for (NumberEdit* edit : this->findChildren<NumberEdit*>())
  {
    QObject::connect(edit, &NumberEdit::edited, this, place);
  }
  QObject::connect(this, &QGroupBox::toggled, this, &SunGroup::Switch);
  QObject::connect(document, &Document::changed, this, &SunGroup::ShowSettings);
  this->ShowSettings();
}

//------------------------------------------------------------------------------
NumberEdit* SunGroup::AddNumber(const QString& title, const QString& name, double least,
  double most, double step, int decimals, const QString& unit, const QString& tip)
{
  auto* edit = new NumberEdit(least, most, step, decimals, this);
  edit->setObjectName(name);
  edit->SetUnit(unit);
  edit->setToolTip(tip);
  this->Rows->addRow(title, edit);
  return edit;
}

//------------------------------------------------------------------------------
bool SunGroup::IsByTime() const
{
  return this->By->currentIndex() == 1;
}

//------------------------------------------------------------------------------
SunTime SunGroup::GetTime() const
{
  const QDate date = this->Date->date();
  return { date.year(), date.month(), date.day(), this->Hour->GetValue(),
    this->TimeZone->GetValue(), this->Latitude->GetValue(), this->Longitude->GetValue() };
}

//------------------------------------------------------------------------------
void SunGroup::SetTime(const SunTime& time, bool byTime)
{
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Date), QSignalBlocker(this->By) };
  this->Date->setDate(QDate(time.Year, time.Month, time.Day));
  this->Hour->SetValue(time.Hour);
  this->TimeZone->SetValue(time.TimeZone);
  this->Latitude->SetValue(time.Latitude);
  this->Longitude->SetValue(time.Longitude);
  this->By->setCurrentIndex(byTime ? 1 : 0);
  this->ShowRows();
}

//------------------------------------------------------------------------------
void SunGroup::FollowUpAxis()
{
  if (this->IsByTime())
  {
    this->Place();
  }
}

//------------------------------------------------------------------------------
void SunGroup::ShowRows()
{
  const bool byTime = this->IsByTime();
  for (QWidget* row : std::initializer_list<QWidget*>{ this->Azimuth, this->Elevation })
  {
    row->setVisible(!byTime);
    this->Rows->labelForField(row)->setVisible(!byTime);
  }
  for (QWidget* row : std::initializer_list<QWidget*>{
         this->Date, this->Hour, this->Latitude, this->Longitude, this->TimeZone })
  {
    row->setVisible(byTime);
    this->Rows->labelForField(row)->setVisible(byTime);
  }
}

//------------------------------------------------------------------------------
void SunGroup::ShowSettings()
{
  const Settings& settings = this->Edited->Get();
  const QSignalBlocker quiet(this);
  const std::vector<std::string> words = settings.GetAll("--light");
  const auto sun = std::find_if(words.begin(), words.end(), IsSun);
  this->setChecked(sun != words.end());
  if (sun == words.end() || this->Placing)
  {
    return;
  }
  const SunAngles angles = GetSunAngles(cli::ParseLight(*sun).Position, GetUpAxis(settings));
  this->Azimuth->SetValue(angles.Azimuth);
  this->Elevation->SetValue(angles.Elevation);
  this->ShowPlace(angles);
}

//------------------------------------------------------------------------------
void SunGroup::ShowPlace(const SunAngles& angles)
{
  const bool night = angles.Elevation <= 0.0;
  this->Words->setText(QString("Azimuth %1%3, elevation %2%3")
                         .arg(angles.Azimuth, 0, 'f', 1)
                         .arg(angles.Elevation, 0, 'f', 1)
                         .arg(Degrees) +
    (night ? ": below the horizon, it lights from beneath" : ""));
  this->Words->setVisible(night || this->IsByTime());
}

//------------------------------------------------------------------------------
void SunGroup::Place()
{
  if (!this->isChecked())
  {
    return;
  }
  const SunAngles angles = this->IsByTime()
    ? GetSunAngles(this->GetTime())
    : SunAngles{ this->Azimuth->GetValue(), this->Elevation->GetValue() };
  this->Placing = true; // angles are not read back from the words, which have other digits
  this->Edited->Change([&angles](Settings& settings) {
    std::vector<std::string> words = settings.GetAll("--light");
    auto sun = std::find_if(words.begin(), words.end(), IsSun);
    if (sun == words.end())
    {
      sun = words.insert(words.begin(), "");
    }
    *sun = WriteSun(GetSunDirection(angles, GetUpAxis(settings))) + GetSize(*sun);
    settings.SetAll("--light", words);
  });
  this->Placing = false;
  this->ShowPlace(angles);
}

//------------------------------------------------------------------------------
void SunGroup::Switch(bool on)
{
  if (on)
  {
    if (!this->IsByTime() && this->Azimuth->GetValue() == 0.0 && this->Elevation->GetValue() == 0.0)
    {
      this->Azimuth->SetValue(135.0);
      this->Elevation->SetValue(45.0);
    }
    this->Place();
    return;
  }
  this->Edited->Change([](Settings& settings) {
    std::vector<std::string> words = settings.GetAll("--light");
    words.erase(std::remove_if(words.begin(), words.end(), IsSun), words.end());
    settings.SetAll("--light", words);
  });
}
}
