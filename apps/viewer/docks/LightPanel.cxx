// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightPanel.h"

#include "NumberEdit.h"
#include "Options.h"
#include "SunGroup.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace viewer
{
namespace
{
bool IsSun(const std::string& word)
{
  return word.rfind("sun:", 0) == 0;
}
}

//------------------------------------------------------------------------------
LightPanel::LightPanel(Document* document, QWidget* parent)
  : Panel(document, parent)
{
  this->AddScene();
  this->Sun = new SunGroup(document, this->widget());
  this->Sun->setObjectName("sun");
  this->GetColumn()->addWidget(this->Sun);
  this->AddLights();
  this->AddEnvironment();
  QObject::connect(document, &Document::changed, this, [this] { this->ShowSettings(); });
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void LightPanel::AddScene()
{
  QGroupBox* group = this->AddGroup("Scene", "scene");
  this->Preset = new QComboBox(group);
  this->Preset->setObjectName("preset");
  this->Preset->addItem("None", "");
  for (const char* name : { "studio", "town", "print" })
  {
    this->Preset->addItem(name, name);
  }
  this->Preset->setToolTip("Lights, shadows and background, for what is not set here");
  GetRows(group)->addRow("Preset", this->Preset);
  this->Up = new QComboBox(group);
  this->Up->setObjectName("up");
  this->Up->addItems({ "x", "y", "z" });
  this->Up->setToolTip("The axis of the data that points up. North is then z, -z or y");
  GetRows(group)->addRow("Up", this->Up);
  const auto changed = static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged);
  QObject::connect(this->Preset, changed, this, [this] {
    this->Edited->Change([this](Settings& settings) {
      const std::string name = this->Preset->currentData().toString().toStdString();
      name.empty() ? settings.Remove("--preset") : settings.Set("--preset", name);
    });
  });
  QObject::connect(this->Up, changed, this, [this] {
    this->Edited->Change([this](Settings& settings) {
      const std::string axis = this->Up->currentText().toStdString();
      axis == "y" ? settings.Remove("--up") : settings.Set("--up", axis);
    });
    this->Sun->FollowUpAxis();
  });
}

//------------------------------------------------------------------------------
void LightPanel::AddLights()
{
  QGroupBox* group = this->AddGroup("Other lights", "otherLights");
  this->Lights = new QPlainTextEdit(group);
  this->Lights->setObjectName("lights");
  this->Lights->setPlaceholderText("spot:PX,PY,PZ,FX,FY,FZ,CONE\npoint:PX,PY,PZ,size=R");
  this->Lights->setToolTip("One light in each line, in the words of --light");
  this->Lights->setMaximumHeight(70);
  this->Lights->setTabChangesFocus(true);
  auto* apply = new QPushButton("Apply", group);
  apply->setObjectName("apply");
  GetRows(group)->addRow(this->Lights);
  GetRows(group)->addRow(apply);
  QObject::connect(apply, &QPushButton::clicked, this, [this] {
    this->Edited->Change([this](Settings& settings) {
      std::vector<std::string> words = settings.GetAll("--light");
      words.erase(std::remove_if(words.begin(), words.end(),
                    [](const std::string& word) { return !IsSun(word); }),
        words.end());
      for (const QString& line : this->Lights->toPlainText().split('\n'))
      {
        if (!line.trimmed().isEmpty())
        {
          words.push_back(line.trimmed().toStdString());
        }
      }
      settings.SetAll("--light", words);
    });
  });
}

//------------------------------------------------------------------------------
void LightPanel::AddEnvironment()
{
  this->Environment = this->AddGroup("Environment", "environment");
  this->Environment->setCheckable(true);
  this->Environment->setToolTip(
    "Light from all around, from an image in equirectangular or cross form");
  QFormLayout* rows = GetRows(this->Environment);
  this->File = new QLineEdit(this->Environment);
  this->File->setObjectName("file");
  auto* browse = new QPushButton("...", this->Environment);
  auto* both = new QHBoxLayout();
  both->addWidget(this->File, 1);
  both->addWidget(browse);
  rows->addRow("Image", both);
  const auto add = [&](const char* title, const char* name, double most, double step) {
    auto* edit = new NumberEdit(0.0, most, step, 3, this->Environment);
    edit->setObjectName(name);
    rows->addRow(title, edit);
    QObject::connect(edit, &NumberEdit::edited, this, [this] { this->SetEnvironment(); });
    return edit;
  };
  this->Rotation = add("Rotation", "rotation", 360.0, 1.0);
  this->Rotation->SetUnit(QString(QChar(0x00b0)));
  this->Reflectivity = add("Reflectivity", "reflectivity", 1.0, 0.01);
  this->Roughness = add("Roughness", "roughness", 1.0, 0.01);
  this->Sky = new QCheckBox("Show as sky", this->Environment);
  this->Sky->setObjectName("sky");
  rows->addRow(this->Sky);
  QObject::connect(this->Sky, &QCheckBox::toggled, this, [this] { this->SetEnvironment(); });
  QObject::connect(this->File, &QLineEdit::editingFinished, this, [this] {
    const QString file = this->File->text();
    this->KeptFile = file.isEmpty() ? "" : QFileInfo(file).absoluteFilePath().toStdString();
    this->SetEnvironment();
  });
  const auto ask = [this] {
    const QString file = QFileDialog::getOpenFileName(
      this, "Environment", QString(), "Images (*.exr *.hdr *.png *.jpg *.jpeg *.tif *.tiff)");
    this->KeptFile = file.isEmpty() ? this->KeptFile : file.toStdString();
    this->SetEnvironment();
  };
  QObject::connect(browse, &QPushButton::clicked, this, [this, ask] {
    const QSignalBlocker quiet(this->Environment);
    this->Environment->setChecked(true);
    ask();
  });
  QObject::connect(this->Environment, &QGroupBox::toggled, this,
    [this, ask](bool on) { on&& this->KeptFile.empty() ? ask() : this->SetEnvironment(); });
}

//------------------------------------------------------------------------------
void LightPanel::SetEnvironment()
{
  this->Edited->Change([this](Settings& settings) {
    for (const char* option : { "--environment", "--reflectivity", "--skybox" })
    {
      settings.Remove(option);
    }
    if (!this->Environment->isChecked() || this->KeptFile.empty())
    {
      return;
    }
    const double turn = this->Rotation->GetValue();
    settings.Set("--environment", this->KeptFile + (turn == 0.0 ? "" : "," + WriteNumber(turn)));
    settings.Set("--reflectivity",
      WriteNumbers({ this->Reflectivity->GetValue(), this->Roughness->GetValue() }));
    if (this->Sky->isChecked())
    {
      settings.Set("--skybox", "");
    }
  });
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void LightPanel::ShowSettings()
{
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Preset), QSignalBlocker(this->Up),
    QSignalBlocker(this->Environment), QSignalBlocker(this->Sky), QSignalBlocker(this->File) };
  const Settings& settings = this->Edited->Get();
  this->Preset->setCurrentIndex(
    this->Preset->findData(QString::fromStdString(settings.Get("--preset"))));
  const cli::RenderOptions options = settings.Parse();
  this->Up->setCurrentIndex(options.UpAxis);
  QString lines;
  for (const std::string& word : settings.GetAll("--light"))
  {
    lines += IsSun(word) ? QString() : QString::fromStdString(word) + "\n";
  }
  this->Lights->setPlainText(lines);
  this->Environment->setChecked(!options.Environment.empty());
  if (!options.Environment.empty())
  {
    this->KeptFile = options.Environment;
    this->Rotation->SetValue(options.EnvironmentRotation);
    this->Sky->setChecked(options.Skybox);
  }
  this->File->setText(QString::fromStdString(this->KeptFile));
  this->Reflectivity->SetValue(options.Reflectivity);
  this->Roughness->SetValue(options.Roughness);
}
}
