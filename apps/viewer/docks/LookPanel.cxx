// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LookPanel.h"

#include "ColorButton.h"
#include "Colormaps.h"
#include "NumberEdit.h"
#include "Options.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QSignalBlocker>

namespace viewer
{
namespace
{
std::string Words(const QColor& color)
{
  return color.name().toStdString();
}

QColor FromColor(const cli::Color& color)
{
  return QColor::fromRgbF(color[0], color[1], color[2]);
}
}

//------------------------------------------------------------------------------
LookPanel::LookPanel(Document* document, QWidget* parent)
  : Panel(document, parent)
{
  this->AddSurface();
  this->AddBackground();
  QObject::connect(document, &Document::changed, this, [this] { this->ShowSettings(); });
  QObject::connect(document, &Document::factsChanged, this, [this] { this->ShowArrays(); });
  this->ShowArrays();
}

//------------------------------------------------------------------------------
QComboBox* LookPanel::AddChoice(QGroupBox* group, const QString& title, const char* option)
{
  auto* box = new QComboBox(group);
  box->setObjectName(QString(option).remove('-'));
  GetRows(group)->addRow(title, box);
  QObject::connect(box, static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged),
    this, [this, box, option] {
      this->Edited->Change([&](Settings& settings) {
        const std::string value = box->currentData().toString().toStdString();
        value.empty() ? settings.Remove(option) : settings.Set(option, value);
        if (!value.empty() && std::string(option) == "--color-by")
        {
          settings.Remove("--color");
        }
      });
    });
  return box;
}

//------------------------------------------------------------------------------
QCheckBox* LookPanel::AddFlag(QGroupBox* group, const QString& title, const char* option)
{
  auto* box = new QCheckBox(title, group);
  box->setObjectName(QString(option).remove('-'));
  GetRows(group)->addRow(box);
  QObject::connect(box, &QCheckBox::toggled, this, [this, option](bool on) {
    this->Edited->Change(
      [&](Settings& settings) { on ? settings.Set(option, "") : settings.Remove(option); });
  });
  return box;
}

//------------------------------------------------------------------------------
void LookPanel::AddSurface()
{
  QGroupBox* group = this->AddGroup("Surfaces", "surfaces");
  this->Shading = this->AddChoice(group, "Shading", "--shading");
  this->ColorBy = this->AddChoice(group, "Color by", "--color-by");
  this->Colormap = this->AddChoice(group, "Colormap", "--colormap");
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Shading), QSignalBlocker(this->Colormap) };
  this->Shading->addItem("As in the file", "");
  for (const char* kind : { "flat", "gouraud", "phong", "pbr" })
  {
    this->Shading->addItem(kind, kind);
  }
  for (const std::string& name : cli::GetColormapNames())
  {
    const QString words = QString::fromStdString(name);
    this->Colormap->addItem(words, name == cli::DefaultColormap ? QString() : words);
  }
  this->Bar = this->AddFlag(group, "Show the colours' scale", "--scalar-bar");
  this->Solid = new QCheckBox("One colour", group);
  this->Solid->setObjectName("solid");
  this->Color = new ColorButton(group);
  this->Color->setObjectName("color");
  this->Color->SetColor(Qt::white);
  GetRows(group)->addRow(this->Solid, this->Color);
  const auto paint = [this] {
    this->Edited->Change([this](Settings& settings) {
      settings.Remove("--color");
      if (this->Solid->isChecked())
      {
        for (const char* other : { "--color-by", "--colormap", "--range", "--scalar-bar" })
        {
          settings.Remove(other);
        }
        settings.Set("--color", Words(this->Color->GetColor()));
      }
    });
  };
  QObject::connect(this->Solid, &QCheckBox::toggled, this, paint);
  QObject::connect(this->Color, &ColorButton::edited, this, [this, paint] {
    const QSignalBlocker still(this->Solid);
    this->Solid->setChecked(true);
    paint();
  });
  this->Opacity = new NumberEdit(0.0, 1.0, 0.01, 2, group);
  this->Opacity->setObjectName("opacity");
  GetRows(group)->addRow("Opacity", this->Opacity);
  QObject::connect(this->Opacity, &NumberEdit::edited, this, [this](double value) {
    this->Edited->Change([&](Settings& settings) {
      value == 1.0 ? settings.Remove("--opacity") : settings.Set("--opacity", WriteNumber(value));
    });
  });
  this->Edges = this->AddFlag(group, "Show edges", "--edges");
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
  this->Edited->Change([this](Settings& settings) {
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
void LookPanel::ShowArrays()
{
  {
    const QSignalBlocker quiet(this->ColorBy);
    this->ColorBy->clear();
    this->ColorBy->addItem("As in the file", "");
    for (const auto& array : this->Edited->GetFacts().Components)
    {
      const QString name = QString::fromStdString(array.first);
      this->ColorBy->addItem(name, name);
    }
  }
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void LookPanel::ShowSettings()
{
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Shading), QSignalBlocker(this->ColorBy),
    QSignalBlocker(this->Colormap), QSignalBlocker(this->Background), QSignalBlocker(this->Bar),
    QSignalBlocker(this->Edges), QSignalBlocker(this->Solid) };
  const Settings& settings = this->Edited->Get();
  const auto show = [&settings](QComboBox* box, const char* option) {
    const QString words = QString::fromStdString(settings.Get(option));
    if (box->findData(words) < 0)
    {
      box->addItem(words, words); // a component of an array, for example
    }
    box->setCurrentIndex(box->findData(words));
  };
  show(this->Shading, "--shading");
  show(this->ColorBy, "--color-by");
  show(this->Colormap, "--colormap");
  this->Bar->setChecked(settings.Has("--scalar-bar"));
  this->Edges->setChecked(settings.Has("--edges"));
  const cli::RenderOptions options = settings.Parse();
  this->Solid->setChecked(options.Look.Solid.has_value());
  if (options.Look.Solid)
  {
    this->Color->SetColor(FromColor(*options.Look.Solid));
  }
  this->Opacity->SetValue(options.Look.Opacity);
  const std::vector<cli::Color>& background = options.Look.Background;
  const bool own = settings.Has("--background");
  this->Background->setCurrentIndex(own ? static_cast<int>(background.size()) : 0);
  if (own)
  {
    this->Bottom->SetColor(FromColor(background.front()));
    this->Top->SetColor(FromColor(background.back()));
  }
  this->Bottom->setEnabled(own);
  this->Top->setEnabled(background.size() == 2 && own);
}
}
