// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LookPanel.h"

#include "ColorButton.h"
#include "Labels.h"
#include "MaterialGroup.h"
#include "Number.h"
#include "OptionEdits.h"
#include "Options.h"
#include "StageGroup.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QSignalBlocker>

#include <utility>

namespace viewer
{
namespace
{
std::string Words(const QColor& color)
{
  return color.name().toStdString();
}

QColor FromColor(const look::Color& color)
{
  return QColor::fromRgbF(color[0], color[1], color[2]);
}
}

//------------------------------------------------------------------------------
LookPanel::LookPanel(Document* document, ColorsGroup::RangeReader range,
  ColorsGroup::RangeReader seen, VolumeGroup::Reader volume, QWidget* parent)
  : Panel(document, parent)
{
  this->AddSurface();
  this->AddGroup(new ColorsGroup(document, std::move(range), std::move(seen), this->widget()));
  this->AddGroup(new VolumeGroup(document, std::move(volume), this->widget()));
  this->AddGroup(new MaterialGroup(document, this->widget()));
  this->AddBackground();
  this->AddStages();
  this->AddOptions("Look");
  QObject::connect(document, &Document::changed, this, [this] { this->ShowSettings(); });
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void LookPanel::AddSurface()
{
  QGroupBox* group = this->AddGroup("Surfaces", "surfaces");
  this->Shading = AddChoice(this->Edited, GetRows(group), "--shading", "As in the file",
    "How light is computed on surfaces");
  this->Opacity = MakeNumber("--opacity", 0.01, 2, group);
  this->Opacity->setObjectName("opacity");
  this->Opacity->setToolTip("Opacity of all meshes and volumes; 0 is invisible");
  GetRows(group)->addRow("Opacity", this->Opacity);
  QObject::connect(this->Opacity, &relievoQt::Number::edited, this, [this](double value) {
    this->Edited->Change([&](scene::Settings& settings) {
      SetOption(settings, "--opacity", value == 1.0 ? "" : words::WriteNumber(value));
    });
  });
  this->PointSize = MakeNumber("--point-size", 1.0, 1, group);
  this->PointSize->setObjectName("pointSize");
  this->PointSize->SetUnit("pixels");
  this->PointSize->setToolTip("Width of points; wider than 1, they are drawn as balls");
  GetRows(group)->addRow("Point size", this->PointSize);
  QObject::connect(this->PointSize, &relievoQt::Number::edited, this, [this](double value) {
    this->Edited->Change(
      [&](scene::Settings& settings) { settings.Set("--point-size", words::WriteNumber(value)); });
  });
  this->Edges = MakeFlag(this->Edited, "--edges", group);
  this->Edges->setToolTip("Draws the edges of cells");
  GetRows(group)->addRow(this->Edges);
}

//------------------------------------------------------------------------------
void LookPanel::AddStages()
{
  for (StageGroup* stage : StageGroup::MakeAll(this->Edited, StageGroup::LOOK, this->widget()))
  {
    this->AddGroup(stage);
  }
  FoldGroup* group = this->AddGroup("Advanced", "advancedStages");
  for (StageGroup* stage : StageGroup::MakeAll(this->Edited, StageGroup::ADVANCED, group))
  {
    group->GetRows()->addRow(stage);
  }
  group->Fold(true);
}

//------------------------------------------------------------------------------
void LookPanel::AddBackground()
{
  QGroupBox* group = this->AddGroup("Background", "background");
  this->Background = new QComboBox(group);
  this->Background->setObjectName("kind");
  this->Background->addItems({ "VTK's", "One colour", "Two colours" });
  this->Bottom = new ColorButton(group);
  this->Bottom->SetColor(QColor("#c8d0d8"));
  this->Top = new ColorButton(group);
  this->Top->SetColor(QColor("#ffffff"));
  GetRows(group)->addRow("Kind", this->Background);
  GetRows(group)->addRow("Colour", this->Bottom);
  GetRows(group)->addRow("At the top", this->Top);
  QObject::connect(this->Background,
    static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), this,
    [this] { this->SetBackground(); });
  for (ColorButton* button : { this->Bottom, this->Top })
  {
    QObject::connect(button, &ColorButton::edited, this, [this] { this->SetBackground(); });
  }
}

//------------------------------------------------------------------------------
void LookPanel::SetBackground()
{
  this->Edited->Change([this](scene::Settings& settings) {
    const int kind = this->Background->currentIndex();
    if (kind == 0)
    {
      settings.Remove("--background");
      return;
    }
    const std::string top = kind == 2 ? "," + Words(this->Top->GetColor()) : "";
    settings.Set("--background", Words(this->Bottom->GetColor()) + top);
  });
}

//------------------------------------------------------------------------------
void LookPanel::ShowSettings()
{
  const QSignalBlocker quiet(this->Background);
  const scene::Settings& settings = this->Edited->Get();
  const scene::RenderOptions options = settings.Parse();
  ShowChoice(this->Shading, settings, "--shading");
  ShowFlag(this->Edges, settings, "--edges");
  this->Opacity->SetValue(options.Look.Opacity);
  this->PointSize->SetValue(options.Look.PointSize);
  const std::vector<look::Color>& background = options.Look.Background;
  const bool own = settings.Has("--background");
  this->Background->setItemText(0, background.empty() ? "VTK's" : "The preset's");
  this->Background->setCurrentIndex(own ? static_cast<int>(background.size()) : 0);
  if (own)
  {
    this->Bottom->SetColor(FromColor(background.front()));
    this->Top->SetColor(FromColor(background.back()));
  }
  SetIdle(this->Bottom, own ? "" : "Has an effect where Kind is one or two colours.");
  SetIdle(
    this->Top, own && background.size() == 2 ? "" : "Has an effect where Kind is two colours.");
}
}
