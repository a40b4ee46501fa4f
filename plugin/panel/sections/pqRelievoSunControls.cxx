// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoSunControls.h"

#include "Number.h"
#include "Rows.h"
#include "SunEdit.h"
#include "pqRelievoScene.h"
#include "vtkPVRelievoView.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDate>
#include <QDateEdit>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

//------------------------------------------------------------------------------
pqRelievoSunControls::pqRelievoSunControls(QWidget* parent)
  : Superclass(parent)
  , On(new QCheckBox("Sun", this))
  , Rest(new relievoQt::SunEdit(this))
  , Ground(new QPushButton("Ground plane", this))
{
  this->On->setObjectName("on");
  MakeHead(this->On);
  this->On->setToolTip("A light that stays where it is when the camera moves");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->On);
  layout->addWidget(this->Rest);
  layout->addWidget(this->Ground);
  this->Ground->setObjectName("ground");
  this->Ground->setToolTip(
    "Adds a plane below all surfaces that are shown, for shadows to fall on");
  this->Rest->setObjectName("rest");
  Indent(this->Rest);
  auto* foot = new QWidget(this->Rest);
  foot->setObjectName("foot");
  this->Rest->layout()->addWidget(foot);
  QFormLayout* rows = relievoQt::MakeRows(foot);
  auto* brightness = new relievoQt::Number(0.0, 2.0, 0.01, 2, foot);
  brightness->setObjectName("intensity");
  brightness->setToolTip("1 lights a white surface that faces the sun fully");
  brightness->SetTypedRange(0.0, 1000.0);
  relievoQt::AddRow(rows, "Brightness", brightness);
  auto* fill = new relievoQt::Number(0.0, 1.0, 0.01, 2, foot);
  fill->setObjectName("fill");
  fill->setToolTip("Light from the other sides, without shadows: it shows form in the shade");
  relievoQt::AddRow(rows, "Fill", fill);
  auto* up = new QComboBox(foot);
  up->setObjectName("up");
  up->addItem("x", 0);
  up->addItem("y", 1);
  up->addItem("z", 2);
  up->setToolTip("The axis of the data that points up. North is then z, -z or y");
  relievoQt::AddRow(rows, "Up", up);
  this->Bind(this->Rest->By, "RelievoSunBy", "Sun placed by");
  this->Bind(this->Rest->Azimuth, "RelievoSunAzimuth", "Sun: azimuth");
  this->Bind(this->Rest->Elevation, "RelievoSunElevation", "Sun: elevation");
  this->Bind(this->Rest->Time, "RelievoSunTime", "Sun: time");
  this->Bind(this->Rest->Latitude, "RelievoSunLatitude", "Sun: latitude");
  this->Bind(this->Rest->Longitude, "RelievoSunLongitude", "Sun: longitude");
  this->Bind(this->Rest->TimeZone, "RelievoSunTimeZone", "Sun: time zone");
  this->Bind(brightness, "RelievoSunIntensity", "Sun: brightness");
  this->Bind(fill, "RelievoSunFill", "Sun: fill");
  this->Bind(up, "RelievoSunUpAxis", "Up axis of the sun");
  QObject::connect(
    this->Ground, &QPushButton::clicked, this, [this] { pqRelievoScene::MakeGround(this->View); });
  QObject::connect(this->On, &QCheckBox::toggled, this,
    [this](bool on) { pqRelievoViewSettings::SetSun(this->View, on); });
  QObject::connect(this->Rest->Date, &QDateEdit::dateChanged, this, [this](const QDate& date) {
    this->Apply(
      "Sun: date", { { "RelievoSunDate", QVariantList{ date.year(), date.month(), date.day() } } });
  });
}

//------------------------------------------------------------------------------
void pqRelievoSunControls::ShowState()
{
  this->Superclass::ShowState();
  const QSignalBlocker quiet[] = { QSignalBlocker(this->On), QSignalBlocker(this->Rest->Date) };
  this->On->setChecked(this->IsOn("RelievoSun"));
  this->Rest->setVisible(this->On->isChecked());
  this->Rest->ShowRows();
  const QVariantList date = this->Get("RelievoSunDate").toList();
  if (date.size() == 3)
  {
    const QDate first(date[0].toInt(), date[1].toInt(), 1);
    this->Rest->Date->setDate(first.addDays(date[2].toInt() - 1)); // 30 February is in March
  }
  this->ShowPlace();
  this->ShowScene();
}

//------------------------------------------------------------------------------
void pqRelievoSunControls::ShowScene()
{
  this->Ground->setEnabled(!pqRelievoScene::FindSurfaces(this->View).isEmpty());
}

//------------------------------------------------------------------------------
void pqRelievoSunControls::ShowPlace()
{
  QString text;
  if (vtkPVRelievoView* here = pqRelievoViewSettings::FindHere(this->View))
  {
    const double* angles = here->GetSunAngles();
    text = relievoQt::SunEdit::WritePlace(angles[0], angles[1], this->IsOn("RelievoSunBy"));
  }
  this->Rest->SetWords(text);
}
