// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunGroup.h"

#include "NumberEdit.h"
#include "Options.h"

#include "vtkMath.h"

#include <QComboBox>
#include <QDateEdit>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
const QString Degrees = QString(QChar(0x00b0));

// How large it is stays as it was said.
std::string GetSize(const std::string& word)
{
  const std::string::size_type at = word.find(",size=");
  return at == std::string::npos ? "" : word.substr(at);
}

QFormLayout* GetRows(QWidget* part)
{
  return static_cast<QFormLayout*>(part->layout());
}

bool AreClose(const SunAngles& a, const SunAngles& b)
{
  constexpr double near = 0.01; // degrees
  const double turn = std::remainder(a.Azimuth - b.Azimuth, 360.0);
  return std::abs(a.Elevation - b.Elevation) < near &&
    std::abs(turn) * std::cos(vtkMath::RadiansFromDegrees(a.Elevation)) < near;
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
  , Angles(new QWidget(this))
  , Place(new QWidget(this))
  , By(new QComboBox(this))
  , Date(new QDateEdit(QDate(2026, 6, 21), this))
  , Words(new QLabel(this))
{
  this->setCheckable(true);
  this->setToolTip("A light that stays where it is when the camera moves");
  this->By->setObjectName("by");
  this->By->addItems({ "Angles", "Date and place" });
  auto* column = new QVBoxLayout(this);
  auto* first = new QFormLayout();
  first->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  first->addRow("Placed by", this->By);
  column->addLayout(first);
  for (QWidget* part : { this->Angles, this->Place }) // one of which is hidden
  {
    auto* rows = new QFormLayout(part);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    column->addWidget(part);
  }
  this->Azimuth = this->AddNumber(this->Angles, "Azimuth", "azimuth", 0.0, 360.0, 1.0, 2, Degrees,
    "From north, clockwise seen from above: 90 is east, 180 south");
  this->Azimuth->SetWrapping();
  this->Elevation = this->AddNumber(
    this->Angles, "Elevation", "elevation", -90.0, 90.0, 1.0, 2, Degrees, "Above the horizon");
  this->Date->setObjectName("date");
  this->Date->setDisplayFormat("yyyy-MM-dd");
  this->Date->setCalendarPopup(true);
  this->Date->setDateRange(QDate(1900, 1, 1), QDate(2100, 12, 31));
  GetRows(this->Place)->addRow("Date", this->Date);
  this->Hour = this->AddNumber(
    this->Place, "Time", "hour", 0.0, 24.0, 1.0 / 12.0, 6, "", "What the clock says");
  this->Hour->SetClock();
  this->Latitude = this->AddNumber(
    this->Place, "Latitude", "latitude", -90.0, 90.0, 0.1, 4, Degrees, "North is positive");
  this->Longitude = this->AddNumber(
    this->Place, "Longitude", "longitude", -180.0, 180.0, 0.2, 4, Degrees, "East is positive");
  this->TimeZone = this->AddNumber(this->Place, "Time zone", "timeZone", -12.0, 14.0, 0.25, 2, "h",
    "Hours that the clock is ahead of universal time (UTC), summer time included");
  this->Words->setObjectName("place");
  this->Words->setWordWrap(true);
  column->addWidget(this->Words);
  this->SetTime(SunTime(), false);
  const auto place = [this] { this->PlaceSun(); };
  QObject::connect(
    this->By, static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), this, [this] {
      this->ShowRows();
      if (this->IsByTime()) // the angles are those that it has already
      {
        this->PlaceSun();
      }
      this->ShowSettings();
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
NumberEdit* SunGroup::AddNumber(QWidget* rows, const QString& title, const QString& name,
  double least, double most, double step, int decimals, const QString& unit, const QString& tip)
{
  auto* edit = new NumberEdit(least, most, step, decimals, this);
  edit->setObjectName(name);
  edit->SetUnit(unit);
  edit->setToolTip(tip);
  GetRows(rows)->addRow(title, edit);
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
    this->PlaceSun();
  }
}

//------------------------------------------------------------------------------
void SunGroup::ShowRows()
{
  this->Angles->setVisible(!this->IsByTime());
  this->Place->setVisible(this->IsByTime());
}

//------------------------------------------------------------------------------
void SunGroup::ShowSettings()
{
  const Settings& settings = this->Edited->Get();
  const std::vector<std::string> lights = settings.GetAll("--light");
  if (lights == this->Next)
  {
    this->Own = this->NextOwn;
  }
  else if (lights != this->Lights) // set elsewhere
  {
    const auto sun = std::find_if(lights.begin(), lights.end(), IsSun);
    this->Own = sun == lights.end() ? -1 : static_cast<int>(sun - lights.begin());
    this->Kept.clear();
  }
  this->Lights = this->Next = lights;
  this->NextOwn = this->Own;
  const QSignalBlocker quiet(this);
  this->setChecked(this->Own >= 0);
  this->Words->hide();
  if (this->Own >= 0)
  {
    const std::string& sun = lights[static_cast<std::size_t>(this->Own)];
    const int up = GetUpAxis(settings);
    if (sun != this->Written || up != this->WrittenUp)
    {
      const SunAngles angles = GetSunAngles(cli::ParseLight(sun).Position, up);
      if (sun != this->Written && this->IsByTime() &&
        !AreClose(angles, GetSunAngles(this->GetTime())))
      {
        this->SetTime(this->GetTime(), false); // it was set elsewhere, by its direction
      }
      this->Written = sun;
      this->WrittenUp = up;
      this->Azimuth->SetValue(angles.Azimuth);
      this->Elevation->SetValue(angles.Elevation);
    }
    this->ShowPlace({ this->Azimuth->GetValue(), this->Elevation->GetValue() });
  }
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
void SunGroup::PlaceSun()
{
  if (!this->isChecked())
  {
    return;
  }
  const SunAngles angles = this->IsByTime()
    ? GetSunAngles(this->GetTime())
    : SunAngles{ this->Azimuth->GetValue(), this->Elevation->GetValue() };
  this->Azimuth->SetValue(angles.Azimuth);
  this->Elevation->SetValue(angles.Elevation);
  this->WrittenUp = GetUpAxis(this->Edited->Get());
  const std::string sun = WriteSun(GetSunDirection(angles, this->WrittenUp));
  if (this->Own < 0)
  {
    this->Insert(sun, 0);
    return;
  }
  std::vector<std::string> lights = this->Lights;
  std::string& own = lights[static_cast<std::size_t>(this->Own)];
  own = this->Written = sun + GetSize(own); // angles are not read back: it has other digits
  this->SetLights(lights, this->Own);
}

//------------------------------------------------------------------------------
void SunGroup::Insert(const std::string& sun, std::size_t place)
{
  std::vector<std::string> lights = this->Lights;
  place = std::min(place, lights.size());
  lights.insert(lights.begin() + static_cast<std::ptrdiff_t>(place), sun);
  this->Written = sun;
  this->SetLights(lights, static_cast<int>(place));
}

//------------------------------------------------------------------------------
void SunGroup::SetLights(const std::vector<std::string>& lights, int own)
{
  this->Next = lights;
  this->NextOwn = own;
  this->Edited->Change([&lights](Settings& settings) { settings.SetAll("--light", lights); });
  this->ShowSettings(); // where nothing has changed, too
}

//------------------------------------------------------------------------------
std::vector<std::string> SunGroup::GetOthers() const
{
  std::vector<std::string> others = this->Lights;
  if (this->Own >= 0)
  {
    others.erase(others.begin() + this->Own);
  }
  return others;
}

//------------------------------------------------------------------------------
void SunGroup::SetOthers(const std::vector<std::string>& others)
{
  std::vector<std::string> lights = others;
  int own = this->Own;
  if (own >= 0)
  {
    own = std::min(own, static_cast<int>(others.size()));
    lights.insert(lights.begin() + own, this->Lights[static_cast<std::size_t>(this->Own)]);
  }
  this->SetLights(lights, own);
}

//------------------------------------------------------------------------------
void SunGroup::Switch(bool on)
{
  if (!on && this->Own < 0)
  {
    return;
  }
  if (!on)
  {
    this->KeptPlace = static_cast<std::size_t>(this->Own);
    this->Kept = this->Lights[this->KeptPlace];
    this->SetLights(this->GetOthers(), -1);
    return;
  }
  if (!this->Kept.empty())
  {
    this->Insert(this->Kept, this->KeptPlace);
    this->FollowUpAxis();
    return;
  }
  if (!this->IsByTime() && this->Azimuth->GetValue() == 0.0 && this->Elevation->GetValue() == 0.0)
  {
    this->Azimuth->SetValue(135.0);
    this->Elevation->SetValue(45.0);
  }
  this->PlaceSun();
}
}
