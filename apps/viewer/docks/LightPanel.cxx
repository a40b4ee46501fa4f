// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightPanel.h"

#include "FileEdit.h"
#include "Labels.h"
#include "LightsGroup.h"
#include "Number.h"
#include "OptionNames.h"
#include "Options.h"
#include "ParameterEdit.h"
#include "StageGroup.h"
#include "SurfaceOptions.h"
#include "SurfaceSettings.h"
#include "SurfaceValues.h"
#include "vtkRelievoParameter.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace viewer
{
namespace
{
constexpr const char* EnvironmentWords[] = { "--environment", "--reflectivity", "--skybox" };
}

//------------------------------------------------------------------------------
LightPanel::LightPanel(Document* document, QWidget* parent)
  : Panel(document, parent)
{
  this->Lights = new LightsGroup(document, this->widget());
  this->AddGroup(this->Lights);
  this->AddEnvironment();
  for (StageGroup* stage : StageGroup::MakeAll(document, StageGroup::LIGHT, this->widget()))
  {
    this->AddGroup(stage);
    if (stage->objectName() == "lamps")
    {
      stage->setTitle(FindOptionName("--lamps").Label);
    }
  }
  this->AddOptions("Light");
  QObject::connect(document, &Document::changed, this, [this] { this->ShowSettings(); });
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void LightPanel::AddEnvironment()
{
  this->Environment = this->AddGroup("Environment", "environment");
  this->Environment->setCheckable(true);
  this->Environment->setToolTip(
    "Light from all around, from an image in equirectangular or cross form");
  QFormLayout* rows = GetRows(this->Environment);
  this->Hint = new QLabel("Choose an image of the light from all around.", this->Environment);
  this->Hint->setObjectName("hint");
  this->Hint->setWordWrap(true);
  rows->addRow(this->Hint);
  this->File = new FileEdit("Environment", this->Environment);
  this->File->setObjectName("file");
  rows->addRow("Image", this->File);
  const auto add = [&](const char* title, const char* name, double most, double step) {
    auto* edit = new relievoQt::Number(0.0, most, step, 3, this->Environment);
    edit->setObjectName(name);
    rows->addRow(title, edit);
    return edit;
  };
  this->Rotation = add("Rotation", "rotation", 360.0, 1.0);
  this->Rotation->SetUnit("degrees");
  this->Rotation->SetWrapping();
  this->Reflectivity = add("Reflectivity", "reflectivity", 1.0, 0.01);
  this->Roughness = add("Roughness", "roughness", 1.0, 0.01);
  this->Values = new SurfaceValues(this->Edited, this->Environment);
  for (const vtkRelievoParameterList* list :
    { &look::GetEnvironmentValues(), &look::GetMaterialValues() })
  {
    for (const vtkRelievoParameter& value : list->Parameters)
    {
      if (list == &look::GetEnvironmentValues() || value.OnlyIf == "environment")
      {
        this->Values->Add(value);
      }
    }
  }
  this->Sky = new QCheckBox("Show as sky", this->Environment);
  this->Sky->setObjectName("sky");
  rows->addRow(this->Sky);
  // Each control writes its own option and leaves the other words unchanged.
  QObject::connect(this->File, &FileEdit::edited, this,
    [this](const QString& path) { this->SetFile(path.toStdString(), this->Rotation->GetValue()); });
  QObject::connect(this->Rotation, &relievoQt::Number::edited, this, [this](double rotation) {
    this->SetFile(this->Edited->Get().Parse().Surface.Environment, rotation);
  });
  QObject::connect(this->Reflectivity, &relievoQt::Number::edited, this, [this](double value) {
    this->Edited->Change([this, value](scene::Settings& settings) {
      const bool both = settings.Get("--reflectivity").find(',') != std::string::npos;
      settings.Set("--reflectivity",
        both ? words::WriteNumbers({ value, this->Roughness->GetValue() })
             : words::WriteNumber(value));
    });
  });
  QObject::connect(this->Roughness, &relievoQt::Number::edited, this, [this](double value) {
    this->Edited->Change([this, value](scene::Settings& settings) {
      settings.Set(
        "--reflectivity", words::WriteNumbers({ this->Reflectivity->GetValue(), value }));
    });
  });
  QObject::connect(this->Sky, &QCheckBox::toggled, this, [this](bool on) {
    this->Edited->Change([on](scene::Settings& settings) {
      on ? settings.Set("--skybox", "") : settings.Remove("--skybox");
    });
  });
  QObject::connect(this->Environment, &QGroupBox::toggled, this, &LightPanel::SwitchEnvironment);
}

//------------------------------------------------------------------------------
void LightPanel::SetFile(const std::string& file, double rotation)
{
  this->Edited->Change(
    [&](scene::Settings& settings) { scene::SetEnvironmentFile(settings, file, rotation); });
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void LightPanel::SwitchEnvironment(bool on)
{
  if (!this->Saved.Has("--environment") && this->Edited->Get().Parse().Surface.Environment.empty())
  {
    this->Waiting = on;
    this->ShowSettings();
    return;
  }
  scene::Settings kept;
  if (!on)
  {
    this->SavedMirror = this->GetMirrorValues();
  }
  this->Edited->Change([&](scene::Settings& settings) {
    for (const char* option : EnvironmentWords)
    {
      kept.SetAll(option, settings.GetAll(option));
      settings.SetAll(option, on ? this->Saved.GetAll(option) : std::vector<std::string>());
    }
    for (const auto& [name, words] : on ? this->SavedMirror : words::NamedWords())
    {
      scene::SetSurfaceValue(settings, name, words);
    }
  });
  this->Saved = on ? scene::Settings() : kept;
  this->ShowSettings();
}

//------------------------------------------------------------------------------
// The material's values without effect if there is no environment, as given.
words::NamedWords LightPanel::GetMirrorValues() const
{
  words::NamedWords mirror;
  for (const auto& given : this->Edited->Get().Parse().Surface.Material)
  {
    if (look::GetMaterialValues().Find(given.first)->OnlyIf == "environment")
    {
      mirror.push_back(given);
    }
  }
  return mirror;
}

//------------------------------------------------------------------------------
void LightPanel::ShowSettings()
{
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Environment), QSignalBlocker(this->Sky) };
  const scene::Settings& settings = this->Edited->Get();
  const scene::RenderOptions options = settings.Parse();
  this->Values->ShowSettings();
  this->Waiting = this->Waiting && options.Surface.Environment.empty();
  this->Environment->setChecked(this->Waiting || !options.Surface.Environment.empty());
  this->Hint->setVisible(this->Waiting);
  QList<QWidget*> rest = { this->Rotation, this->Reflectivity, this->Roughness, this->Sky };
  for (ParameterEdit* edit : this->Environment->findChildren<ParameterEdit*>())
  {
    this->Waiting ? rest.append(edit) : void(); // the others report their reasons
  }
  for (QWidget* edit : rest)
  {
    SetIdle(edit, this->Waiting ? "Has an effect with an image." : "");
  }
  if (!options.Surface.Environment.empty())
  {
    this->Saved = scene::Settings();
    this->File->SetPath(QString::fromStdString(options.Surface.Environment));
    this->Rotation->SetValue(options.Surface.EnvironmentRotation);
    this->Sky->setChecked(options.Surface.Skybox);
  }
  else if (!this->Saved.Has("--environment"))
  {
    this->File->SetPath(QString());
  }
  if (!this->Saved.Has("--environment"))
  {
    this->Reflectivity->SetValue(options.Surface.Reflectivity);
    this->Roughness->SetValue(options.Surface.Roughness);
  }
}
}
