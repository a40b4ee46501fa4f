// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoEnvironmentControls.h"

#include "Number.h"
#include "Rows.h"
#include "pqCoreUtilities.h"
#include "pqFileDialog.h"
#include "pqRelievoFileWidget.h"
#include "pqRelievoScene.h"
#include "pqView.h"
#include "vtkSMProxy.h"

#include <QCheckBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

//------------------------------------------------------------------------------
pqRelievoEnvironmentControls::pqRelievoEnvironmentControls(QWidget* parent)
  : Superclass(parent)
  , File(new QToolButton(this))
  , None(new QToolButton(this))
  , Rest(new QWidget(this))
  , Light(new QPushButton("Light all surfaces with it", Rest))
  , Sky(new QCheckBox("Show as sky", Rest))
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* head = new QLabel("Environment", this);
  MakeHead(head);
  layout->addWidget(head);
  auto* row = new QWidget(this);
  auto* files = new QHBoxLayout(row);
  files->setContentsMargins(0, 0, 0, 0);
  this->File->setObjectName("file");
  this->File->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  this->None->setObjectName("none");
  this->None->setText(QString(QChar(0x00d7)));
  this->None->setToolTip("No environment");
  files->addWidget(this->File, 1);
  files->addWidget(this->None);
  layout->addWidget(row);
  layout->addWidget(this->Rest);
  this->Rest->setObjectName("rest");
  this->Sky->setObjectName("sky");
  this->Light->setObjectName("light");
  QFormLayout* rows = relievoQt::MakeRows(this->Rest);
  Indent(this->Rest);
  auto* rotation = new relievoQt::Number(0.0, 360.0, 1.0, 2, this->Rest);
  rotation->setObjectName("rotation");
  rotation->SetUnit("degrees");
  rotation->SetWrapping();
  auto* intensity = new relievoQt::Number(0.0, 4.0, 0.01, 2, this->Rest);
  intensity->setObjectName("intensity");
  intensity->SetTypedRange(0.0, 1000.0);
  rows->addRow(this->Light);
  rows->addRow(this->Sky);
  relievoQt::AddRow(rows, "Rotation", rotation);
  relievoQt::AddRow(rows, "Intensity", intensity);
  this->Bind(rotation, "RelievoEnvironmentRotation", "Rotation of the environment");
  this->Bind(intensity, "RelievoEnvironmentIntensity", "Intensity of the environment");
  QObject::connect(this->Sky, &QCheckBox::toggled, this, [this](bool on) {
    this->Apply(on ? "Sky on" : "Sky off", { { "RelievoSkybox", on ? 1 : 0 } });
  });
  QObject::connect(this->Light, &QPushButton::clicked, this,
    [this] { pqRelievoScene::LightByEnvironment(this->View); });
  QObject::connect(this->File, &QToolButton::clicked, this, [this] { this->Choose(); });
  QObject::connect(this->None, &QToolButton::clicked, this, [this] {
    this->Apply("No environment", { { "RelievoEnvironment", QString() } });
  });
}

//------------------------------------------------------------------------------
void pqRelievoEnvironmentControls::Choose()
{
  if (!this->View)
  {
    return;
  }
  pqFileDialog dialog(this->View->getServer(), pqCoreUtilities::mainWidget(), "Environment",
    QString(),
    pqRelievoFileWidget::GetFilter(this->View->getProxy()->GetProperty("RelievoEnvironment")));
  dialog.setObjectName("RelievoEnvironmentDialog");
  dialog.setFileMode(pqFileDialog::ExistingFile);
  if (dialog.exec() == QDialog::Accepted && !dialog.getSelectedFiles().isEmpty())
  {
    this->Apply("Environment", { { "RelievoEnvironment", dialog.getSelectedFiles().front() } });
  }
}

//------------------------------------------------------------------------------
void pqRelievoEnvironmentControls::ShowState()
{
  this->Superclass::ShowState();
  const QString path = this->Get("RelievoEnvironment").toString();
  this->File->setText(
    path.isEmpty() ? QString("Choose a picture") + QChar(0x2026) : QFileInfo(path).fileName());
  this->File->setToolTip(path.isEmpty()
      ? "A picture of the light from all directions, which materials mirror and which lights them"
      : path);
  this->None->setVisible(!path.isEmpty());
  this->Rest->setVisible(!path.isEmpty());
  const QSignalBlocker quiet(this->Sky);
  this->Sky->setChecked(this->IsOn("RelievoSkybox"));
  this->ShowScene();
}

//------------------------------------------------------------------------------
void pqRelievoEnvironmentControls::ShowScene()
{
  const bool any = !pqRelievoScene::FindSurfaces(this->View).isEmpty();
  const bool all = pqRelievoScene::IsLitByEnvironment(this->View);
  this->Light->setEnabled(any && !all);
  this->Light->setToolTip(!any ? "No surface is shown"
      : all                    ? "All surfaces mirror it and are lit by it"
                               : "Material and Mirror Environment of all visible surfaces");
}
