// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightEdit.h"

#include "ColorButton.h"
#include "Labels.h"
#include "Number.h"
#include "Rows.h"
#include "SunEdit.h"
#include "TripleEdit.h"
#include "TypedZones.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <array>
#include <cmath>
#include <cstdlib>

namespace viewer
{
namespace
{
using Kind = look::LightChoice::Kind;

constexpr double MostIntensity = 1000.0;
constexpr double MostRadius = 1e9;

QColor ToColor(const look::LightChoice& light)
{
  return QColor::fromRgbF(static_cast<float>(light.Color[0]), static_cast<float>(light.Color[1]),
    static_cast<float>(light.Color[2]));
}

std::vector<double> Concatenate(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return { a[0], a[1], a[2], b[0], b[1], b[2] };
}

// The whole hours between UTC and the sun's mean time at a longitude.
double FindZone(double longitude)
{
  return std::round(longitude / 15.0);
}

QString GetPartOfDay(const look::SunTime& time)
{
  return relievoQt::SunEdit::NamePartOfDay(look::GetSunAngles(time).Elevation);
}
}

//------------------------------------------------------------------------------
LightEdit::LightEdit(Document* document, QWidget* parent)
  : QWidget(parent)
  , Edited(document)
{
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* common = new QWidget(this);
  column->addWidget(common);
  this->AddCommon(relievoQt::MakeRows(common));
  this->Sun = new relievoQt::SunEdit(this);
  column->addWidget(this->Sun);
  this->AddPlace();
  column->addWidget(this->Where);
  const auto placed = [this] { this->WriteSun(); };
  QObject::connect(this->Sun->By,
    static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), this, placed);
  QObject::connect(this->Sun->Date, &QDateEdit::dateChanged, this, placed);
  for (relievoQt::Number* edit : this->Sun->findChildren<relievoQt::Number*>())
  {
    QObject::connect(edit, &relievoQt::Number::edited, this, placed);
  }
}

//------------------------------------------------------------------------------
void LightEdit::AddCommon(QFormLayout* rows)
{
  QWidget* parent = rows->parentWidget();
  this->Name = new QLineEdit(parent);
  this->Name->setObjectName("name");
  this->Name->setToolTip("In the list, and in reports and files");
  relievoQt::AddRow(rows, "Name", this->Name);
  this->Color = new ColorButton(parent);
  this->Color->setObjectName("color");
  relievoQt::AddRow(rows, "Colour", this->Color);
  this->Intensity = new relievoQt::Number(0.0, 2.0, 0.01, 3, parent);
  this->Intensity->setObjectName("intensity");
  this->Intensity->SetTypedRange(0.0, MostIntensity);
  this->Intensity->setToolTip("How bright it is");
  relievoQt::AddRow(rows, "Intensity", this->Intensity);
  auto* size = this->Softness = new QWidget(parent);
  auto* both = new QVBoxLayout(size);
  both->setContentsMargins(0, 0, 0, 0);
  this->Angle = new relievoQt::Number(0.0, 10.0, 0.01, 2, size);
  this->Angle->setObjectName("angle");
  this->Angle->SetTypedRange(0.0, 90.0);
  this->Angle->SetUnit("degrees");
  this->Radius = new relievoQt::Number(0.0, MostRadius, 1e-3, 4, size);
  this->Radius->setObjectName("radius");
  this->Radius->SetUnit("world units");
  both->addWidget(this->Angle);
  both->addWidget(this->Radius);
  size->setObjectName("softness");
  size->setToolTip("How large it is, a sun's angle in the sky or a lamp's radius: the larger, the "
                   "softer are the edges of its shadows");
  relievoQt::AddRow(rows, "Softness", size);
  this->Casts = new QCheckBox("Casts shadows", parent);
  this->Casts->setObjectName("casts");
  relievoQt::AddRow(rows, "", this->Casts);
  QObject::connect(this->Name, &QLineEdit::editingFinished, this,
    [this] { this->SetValue("name", this->Name->text().trimmed().toStdString()); });
  QObject::connect(this->Color, &ColorButton::edited, this,
    [this](const QColor& color) { this->SetValue("color", color.name().toStdString()); });
  QObject::connect(this->Intensity, &relievoQt::Number::edited, this, [this](double value) {
    this->SetValue("intensity", value == 1.0 ? "" : words::WriteNumber(value));
  });
  for (relievoQt::Number* edit : { this->Angle, this->Radius })
  {
    QObject::connect(edit, &relievoQt::Number::edited, this,
      [this](double value) { this->SetValue("size", words::WriteNumber(value)); });
  }
  QObject::connect(this->Casts, &QCheckBox::toggled, this,
    [this](bool on) { this->SetValue("casts", on ? "" : "off"); });
}

//------------------------------------------------------------------------------
void LightEdit::AddPlace()
{
  this->Where = new QWidget(this);
  QFormLayout* rows = relievoQt::MakeRows(this->Where);
  this->Position = new TripleEdit(this->Where);
  this->Position->setObjectName("position");
  relievoQt::AddRow(rows, "Position", this->Position);
  this->Target = new TripleEdit(this->Where);
  this->Target->setObjectName("target");
  relievoQt::AddRow(rows, "Target", this->Target);
  this->TargetLabel = qobject_cast<QLabel*>(rows->labelForField(this->Target));
  this->Cone = new relievoQt::Number(0.1, 90.0, 0.1, 2, this->Where);
  this->Cone->setObjectName("cone");
  this->Cone->SetTypedRange(0.01, 180.0);
  this->Cone->SetUnit("degrees");
  this->Cone->setToolTip("Half the opening of its cone");
  relievoQt::AddRow(rows, "Cone", this->Cone);
  this->ConeLabel = qobject_cast<QLabel*>(rows->labelForField(this->Cone));
  this->PlaceButton = new QPushButton(this->Where);
  this->PlaceButton->setObjectName("placeInPicture");
  this->PlaceButton->setCheckable(true);
  relievoQt::AddRow(rows, "", this->PlaceButton);
  const auto placed = [this] { this->WritePlace(); };
  QObject::connect(this->Position, &TripleEdit::edited, this, placed);
  QObject::connect(this->Target, &TripleEdit::edited, this, placed);
  QObject::connect(this->Cone, &relievoQt::Number::edited, this, placed);
  QObject::connect(this->PlaceButton, &QPushButton::toggled, this, [this](bool on) {
    const bool spot = this->Kind == Kind::Spot;
    Q_EMIT this->placing(!on ? QString()
        : spot               ? "Click where the spot shall shine. Esc to stop."
                             : "Click on the surface below the light. Esc to stop.");
  });
}

//------------------------------------------------------------------------------
void LightEdit::SetValue(const char* name, const std::string& value)
{
  if (words::FindWords(this->Words.Values, name) != value)
  {
    words::SetWords(this->Words.Values, name, value);
    this->Word = look::WriteLight(this->Words);
    Q_EMIT this->edited(QString::fromStdString(this->Word));
  }
}

//------------------------------------------------------------------------------
void LightEdit::SetNumbers(const std::string& numbers)
{
  if (this->Words.Numbers != numbers)
  {
    this->Words.Numbers = numbers;
    this->Word = look::WriteLight(this->Words); // displayed angles are rounded
    Q_EMIT this->edited(QString::fromStdString(this->Word));
  }
}

//------------------------------------------------------------------------------
void LightEdit::SetWord(const std::string& word, Owner owner)
{
  const look::LightChoice light = look::ParseLight(word);
  const int up = this->Edited->GetUpAxis();
  // The note of the settings may have changed where the word has not.
  this->OwnZone = light.Time &&
    (light.Time->TimeZone != FindZone(light.Time->Longitude) ||
      HasTypedZone(this->Edited->Get(), word));
  this->setEnabled(owner != OFF);
  SetIdle(this->Intensity, owner == PRESET ? "Make it your own to change how bright it is." : "");
  this->ShowSoftness(light); // the size's effect may have changed
  if (word == this->Word && up == this->WordUp)
  {
    this->ShowWords();
    return;
  }
  this->PlaceButton->setChecked(false);
  this->Word = word;
  this->WordUp = up;
  this->Words = look::SplitLight(word);
  this->Kind = light.Is;
  const QSignalBlocker quiet(this->Casts);
  this->Name->setText(QString::fromStdString(light.Name));
  this->Color->SetColor(ToColor(light));
  this->Intensity->SetValue(light.Intensity);
  this->Casts->setChecked(light.Casts);
  this->Sun->setVisible(light.Is == Kind::Sun);
  this->Where->setVisible(light.Is != Kind::Sun);
  if (light.Is == Kind::Sun)
  {
    this->ShowSun(light);
    return;
  }
  const bool spot = light.Is == Kind::Spot;
  this->Position->SetValue(light.Position);
  for (QWidget* each :
    std::array<QWidget*, 4>{ this->Target, this->TargetLabel, this->Cone, this->ConeLabel })
  {
    each->setVisible(spot);
  }
  if (spot)
  {
    this->Target->SetValue(light.FocalPoint);
    this->Cone->SetValue(light.ConeAngle);
  }
  this->PlaceButton->setText(spot ? "Aim in the picture" : "Place in the picture");
  this->PlaceButton->setToolTip(spot
      ? "The next click in the picture sets the target"
      : "The next click in the picture places the light above that surface");
}

//------------------------------------------------------------------------------
void LightEdit::ShowSoftness(const look::LightChoice& light)
{
  const scene::Settings& settings = this->Edited->Get();
  const bool sun = light.Is == Kind::Sun;
  const char* standard = sun ? "sun_angle" : "lamp_radius";
  const double usual =
    QString::fromStdString(settings.GetParameter("shadows", standard)).toDouble();
  this->Angle->setVisible(sun);
  this->Radius->setVisible(!sun);
  (sun ? this->Angle : this->Radius)->SetValue(light.Size.value_or(usual));
  const bool one = std::atoi(settings.GetParameter("shadows", "soft_samples").c_str()) < 2;
  SetIdle(this->Softness,
    !light.Casts                       ? "It casts no shadows."
      : !settings.IsStageOn("shadows") ? "Shadows are off: they are switched on below."
      : one ? "Shadows are hard: they need Samples, below, for soft edges."
            : "");
}

//------------------------------------------------------------------------------
void LightEdit::ShowSun(const look::LightChoice& light)
{
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Sun->By), QSignalBlocker(this->Sun->Date) };
  this->Time = light.Time.value_or(this->Time);
  this->Sun->Date->setDate(QDate(this->Time.Year, this->Time.Month, this->Time.Day));
  this->Sun->Time->SetValue(this->Time.Hour);
  this->Sun->TimeZone->SetValue(this->Time.TimeZone);
  this->Sun->Latitude->SetValue(this->Time.Latitude);
  this->Sun->Longitude->SetValue(this->Time.Longitude);
  const look::SunAngles angles = light.Time ? look::GetSunAngles(*light.Time)
    : light.Angles                          ? *light.Angles
                                            : look::GetSunAngles(light.Position, this->WordUp);
  this->Sun->Azimuth->SetValue(angles.Azimuth);
  this->Sun->Elevation->SetValue(angles.Elevation);
  this->Sun->By->setCurrentIndex(light.Time ? 1 : 0);
  this->Sun->ShowRows();
  this->ShowWords();
}

//------------------------------------------------------------------------------
void LightEdit::ShowWords()
{
  const bool byPlace = this->Sun->IsByPlace();
  QString words = relievoQt::SunEdit::WritePlace(
    this->Sun->Azimuth->GetValue(), this->Sun->Elevation->GetValue(), byPlace);
  if (byPlace && !this->OwnZone)
  {
    look::SunTime summer = this->Time;
    summer.TimeZone += 1.0;
    const auto nameZone = [](double zone) {
      return QString("UTC%1%2").arg(zone < 0.0 ? QChar(0x2212) : QChar('+')).arg(std::abs(zone));
    };
    words += QString(" Clock: %1 (from the longitude, no summer time).")
               .arg(nameZone(this->Time.TimeZone));
    const QString part = GetPartOfDay(summer);
    if (part != GetPartOfDay(this->Time))
    {
      words += QString(" In summer time (%1) it is %2.").arg(nameZone(summer.TimeZone), part);
    }
  }
  this->Sun->SetWords(words);
}

//------------------------------------------------------------------------------
void LightEdit::WriteSun()
{
  if (!this->Sun->IsByPlace()) // by angles
  {
    this->SetNumbers(
      words::WriteNumbers({ this->Sun->Azimuth->GetValue(), this->Sun->Elevation->GetValue() }));
  }
  else
  {
    const QDate date = this->Sun->Date->date();
    this->OwnZone = this->OwnZone || this->Sun->TimeZone->GetValue() != this->Time.TimeZone;
    if (!this->OwnZone && this->Sun->Longitude->GetValue() != this->Time.Longitude)
    {
      this->Sun->TimeZone->SetValue(FindZone(this->Sun->Longitude->GetValue()));
    }
    this->Time = { date.year(), date.month(), date.day(), this->Sun->Time->GetValue(),
      this->Sun->TimeZone->GetValue(), this->Sun->Latitude->GetValue(),
      this->Sun->Longitude->GetValue() };
    const look::SunAngles angles = look::GetSunAngles(this->Time);
    this->Sun->Azimuth->SetValue(angles.Azimuth);
    this->Sun->Elevation->SetValue(angles.Elevation);
    this->SetNumbers(look::WriteSunTime(this->Time));
  }
  this->ShowWords();
}

//------------------------------------------------------------------------------
void LightEdit::WritePlace()
{
  std::vector<double> numbers = Concatenate(this->Position->GetValue(), this->Target->GetValue());
  numbers.push_back(this->Cone->GetValue());
  numbers.resize(this->Kind == Kind::Spot ? 7 : 3);
  this->SetNumbers(words::WriteNumbers(numbers));
}

//------------------------------------------------------------------------------
void LightEdit::StopPlacing()
{
  this->PlaceButton->setChecked(false);
}

//------------------------------------------------------------------------------
void LightEdit::Place(const std::array<double, 3>& place)
{
  this->PlaceButton->setChecked(false);
  if (this->Kind == Kind::Spot)
  {
    this->Target->SetValue(place);
  }
  else
  {
    // Keeps the light's height if that is above the clicked place.
    const auto up = static_cast<std::size_t>(this->WordUp);
    const std::array<double, 6>& b = this->Edited->GetFacts().Bounds;
    const double high =
      0.25 * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]); // distance above the clicked place
    std::array<double, 3> position = place;
    const double before = this->Position->GetValue()[up];
    position[up] = before > place[up] ? before : place[up] + high;
    this->Position->SetValue(position);
  }
  this->WritePlace();
}
}
