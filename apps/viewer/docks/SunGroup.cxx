// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunGroup.h"

#include "Number.h"
#include "Options.h"
#include "PresetsLights.h"
#include "SunEdit.h"

#include "vtkMath.h"

#include <QComboBox>
#include <QDateEdit>
#include <QFormLayout>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace viewer
{
namespace
{
// How large it is stays as it was said.
std::string GetSize(const std::string& word)
{
  const std::string::size_type at = word.find(",size=");
  return at == std::string::npos ? "" : word.substr(at);
}

bool AreClose(const SunAngles& a, const SunAngles& b)
{
  constexpr double near = 0.01; // degrees
  const double turn = std::remainder(a.Azimuth - b.Azimuth, 360.0);
  return std::abs(a.Elevation - b.Elevation) < near &&
    std::abs(turn) * std::cos(vtkMath::RadiansFromDegrees(a.Elevation)) < near;
}
}

//------------------------------------------------------------------------------
SunGroup::SunGroup(Document* document, QWidget* parent)
  : FoldGroup("Sun", "sun", parent)
  , Edited(document)
  , Sun(new relievoQt::SunEdit(this))
  , Preset(new PresetsLights(document, "a sun of your own", this))
{
  this->setCheckable(true);
  this->setToolTip("A light that stays where it is when the camera moves");
  this->GetRows()->addRow(this->Preset);
  this->GetRows()->addRow(this->Sun);
  this->SetTime(SunTime(), false);
  const auto place = [this] { this->PlaceSun(); };
  QObject::connect(this->Sun->By,
    static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), this, [this] {
      if (this->IsByTime())
      {
        this->PlaceSun();
      }
      else // the angles are those that it has already
      {
        this->ByTime.erase(this->Written);
      }
      this->ShowSettings();
    });
  QObject::connect(this->Sun->Date, &QDateEdit::dateChanged, this, place);
  for (relievoQt::Number* edit : this->Sun->findChildren<relievoQt::Number*>())
  {
    QObject::connect(edit, &relievoQt::Number::edited, this, place);
  }
  QObject::connect(this, &QGroupBox::toggled, this, &SunGroup::Switch);
  QObject::connect(document, &Document::changed, this, &SunGroup::ShowSettings);
  this->ShowSettings();
}

//------------------------------------------------------------------------------
bool SunGroup::IsByTime() const
{
  return this->Sun->IsByPlace();
}

//------------------------------------------------------------------------------
SunTime SunGroup::GetTime() const
{
  const QDate date = this->Sun->Date->date();
  return { date.year(), date.month(), date.day(), this->Sun->Time->GetValue(),
    this->Sun->TimeZone->GetValue(), this->Sun->Latitude->GetValue(),
    this->Sun->Longitude->GetValue() };
}

//------------------------------------------------------------------------------
void SunGroup::SetTime(const SunTime& time, bool byTime)
{
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Sun->Date), QSignalBlocker(this->Sun->By) };
  this->Sun->Date->setDate(QDate(time.Year, time.Month, time.Day));
  this->Sun->Time->SetValue(time.Hour);
  this->Sun->TimeZone->SetValue(time.TimeZone);
  this->Sun->Latitude->SetValue(time.Latitude);
  this->Sun->Longitude->SetValue(time.Longitude);
  this->Sun->By->setCurrentIndex(byTime ? 1 : 0);
  this->Sun->ShowRows();
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
void SunGroup::ShowSettings()
{
  const scene::Settings& settings = this->Edited->Get();
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
  this->Sun->SetWords(QString());
  if (this->Own >= 0)
  {
    const std::string& sun = lights[static_cast<std::size_t>(this->Own)];
    const int up = this->Edited->GetUpAxis();
    if (sun != this->Written || up != this->WrittenUp)
    {
      const SunAngles angles = GetSunAngles(scene::ParseLight(sun).Position, up);
      const auto placed = this->ByTime.find(sun);
      if (placed != this->ByTime.end() && AreClose(angles, GetSunAngles(placed->second)))
      {
        this->SetTime(placed->second, true); // again, as by undoing
      }
      else if (sun != this->Written && this->IsByTime() &&
        !AreClose(angles, GetSunAngles(this->GetTime())))
      {
        this->SetTime(this->GetTime(), false); // it was set elsewhere, by its direction
      }
      this->Written = sun;
      this->WrittenUp = up;
      this->Sun->Azimuth->SetValue(angles.Azimuth);
      this->Sun->Elevation->SetValue(angles.Elevation);
    }
    if (this->IsByTime())
    {
      this->ByTime[sun] = this->GetTime();
    }
    this->ShowPlace({ this->Sun->Azimuth->GetValue(), this->Sun->Elevation->GetValue() });
  }
}

//------------------------------------------------------------------------------
void SunGroup::ShowPlace(const SunAngles& angles)
{
  const bool night = angles.Elevation <= 0.0;
  const QString words = relievoQt::SunEdit::WriteAngles(angles.Azimuth, angles.Elevation) +
    (night ? ": below the horizon, it lights from beneath" : "");
  this->Sun->SetWords(night || this->IsByTime() ? words : QString());
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
    : SunAngles{ this->Sun->Azimuth->GetValue(), this->Sun->Elevation->GetValue() };
  this->Sun->Azimuth->SetValue(angles.Azimuth);
  this->Sun->Elevation->SetValue(angles.Elevation);
  this->WrittenUp = this->Edited->GetUpAxis();
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
  this->Edited->Change(
    [&lights](scene::Settings& settings) { settings.SetAll("--light", lights); });
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
  if (!this->IsByTime() && this->Sun->Azimuth->GetValue() == 0.0 &&
    this->Sun->Elevation->GetValue() == 0.0)
  {
    this->Sun->Azimuth->SetValue(135.0);
    this->Sun->Elevation->SetValue(45.0);
  }
  this->PlaceSun();
}
}
