// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorsGroup.h"

#include "ColorButton.h"
#include "ColormapBox.h"
#include "Colormaps.h"
#include "Labels.h"
#include "OptionEdits.h"
#include "Options.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

namespace viewer
{
namespace
{
constexpr const char* OfValues[] = { "--color-by", "--colormap", "--range", "--scalar-bar" };

// The array and the component of --color-by, "" for none. Names may end like a component.
struct ByValue
{
  std::string Name;
  QString Component;
};

ByValue GetByValue(
  const scene::Settings& settings, const scene::LookChoice& look, const Facts& facts)
{
  const std::string given = settings.Get("--color-by");
  if (given.empty() || facts.Components.count(given) != 0)
  {
    return { given, "" };
  }
  return { look.ColorBy,
    look.Magnitude     ? QString("magnitude")
      : look.Component ? QString::number(*look.Component)
                       : QString() };
}
}

//------------------------------------------------------------------------------
ColorsGroup::ColorsGroup(Document* document, RangeReader read, QWidget* parent)
  : FoldGroup("Colours", "colors", parent)
  , Edited(document)
  , ReadRange(std::move(read))
  , ColorBy(new QComboBox(this))
  , Component(new QComboBox(this))
  , Colormap(new ColormapBox(this))
  , Reversed(new QCheckBox("Reversed", this))
  , Automatic(new QCheckBox("Automatic", this))
  , Least(new QLineEdit(this))
  , Most(new QLineEdit(this))
  , Bar(MakeFlag(document, "Show a colour bar", "--scalar-bar", this))
  , Solid(new QCheckBox("One colour", this))
  , Color(new ColorButton(this))
{
  QFormLayout* rows = this->GetRows();
  this->ColorBy->setObjectName("colorby");
  this->ColorBy->setToolTip("The point or cell array whose values give the colours");
  this->Component->setObjectName("component");
  this->Component->setToolTip("Of arrays with several numbers for each point or cell");
  rows->addRow("Colour by", this->ColorBy);
  rows->addRow("Component", this->Component);
  rows->addRow("Colour map", this->Colormap);
  this->Colormap->setObjectName("colormap");
  this->Colormap->setEditable(true);
  this->Colormap->setInsertPolicy(QComboBox::NoInsert);
  this->Colormap->setToolTip(
    "A map, or colours between commas, evenly placed, such as black,#ff8000,white");
  QObject::connect(this->Colormap->lineEdit(), &QLineEdit::editingFinished, this,
    [this] { this->TakeMap(this->Colormap->currentText()); });
  this->Reversed->setObjectName("reversed");
  this->Reversed->setToolTip("The first colour for the greatest value");
  rows->addRow("", this->Reversed);
  QObject::connect(this->Reversed, &QCheckBox::toggled, this,
    [this] { this->TakeMap(this->Colormap->currentText()); });
  this->AddRange();
  this->Bar->setToolTip("The colours and their values, at the right of the picture");
  rows->addRow(this->Bar);
  this->Solid->setObjectName("solid");
  this->Solid->setToolTip("One colour for all meshes, instead of values and textures");
  this->Color->setObjectName("color");
  this->Color->SetColor(Qt::white);
  rows->addRow(this->Solid, this->Color);
  const auto changed = static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged);
  QObject::connect(this->ColorBy, changed, this,
    [this] { this->SetColorBy(this->ColorBy->currentData().toString(), ""); });
  QObject::connect(this->Component, changed, this, [this] {
    this->SetColorBy(
      this->ColorBy->currentData().toString(), this->Component->currentData().toString());
  });
  QObject::connect(this->Colormap, static_cast<void (QComboBox::*)(int)>(&QComboBox::activated),
    this, [this] { this->TakeMap(this->Colormap->currentText()); });
  QObject::connect(this->Solid, &QCheckBox::toggled, this, &ColorsGroup::Paint);
  QObject::connect(this->Color, &ColorButton::edited, this, [this] {
    const QSignalBlocker still(this->Solid);
    this->Solid->setChecked(true);
    this->Paint();
  });
  QObject::connect(document, &Document::changed, this, &ColorsGroup::ShowSettings);
  QObject::connect(document, &Document::factsChanged, this, &ColorsGroup::ShowArrays);
  this->ShowArrays();
}

//------------------------------------------------------------------------------
void ColorsGroup::AddRange()
{
  this->Automatic->setObjectName("automaticRange");
  this->Automatic->setToolTip("From the least to the greatest value of all files");
  this->Least->setObjectName("least");
  this->Least->setToolTip("The value of the first colour");
  this->Most->setObjectName("most");
  this->Most->setToolTip("The value of the last colour");
  auto* both = new QHBoxLayout();
  both->addWidget(this->Least, 1);
  both->addWidget(new QLabel("to", this));
  both->addWidget(this->Most, 1);
  QFormLayout* rows = this->GetRows();
  rows->addRow("Range", this->Automatic);
  rows->addRow("", both);
  QObject::connect(this->Automatic, &QCheckBox::toggled, this, &ColorsGroup::SwitchRange);
  for (QLineEdit* edit : { this->Least, this->Most })
  {
    QObject::connect(edit, &QLineEdit::editingFinished, this, &ColorsGroup::SetRange);
  }
}

//------------------------------------------------------------------------------
bool ColorsGroup::HasValues(const QString& name, const QString& component) const
{
  return !component.isEmpty() || this->Edited->GetFacts().Valueless.count(name.toStdString()) == 0;
}

//------------------------------------------------------------------------------
void ColorsGroup::SetColorBy(const QString& name, const QString& component)
{
  this->Edited->Change([&](scene::Settings& settings) {
    const QString words = name.isEmpty() || component.isEmpty() ? name : name + "," + component;
    SetOption(settings, "--color-by", words.toStdString());
    if (!name.isEmpty())
    {
      settings.Remove("--color");
    }
    if (!this->HasValues(name, component)) // a bar would have nothing to show
    {
      settings.Remove("--scalar-bar");
    }
  });
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void ColorsGroup::TakeMap(const QString& map)
{
  std::string word = map.trimmed().toStdString();
  if (this->Reversed->isChecked())
  {
    word += scene::ReversedColormap;
  }
  word = word == scene::DefaultColormap ? std::string() : word;
  if (!map.trimmed().isEmpty() && word != this->Edited->Get().Get("--colormap"))
  {
    this->Edited->Change([&word](scene::Settings& settings) {
      SetOption(settings, "--colormap", word);
      settings.Remove("--color");
    });
  }
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void ColorsGroup::ShowMap(const std::string& word)
{
  const QSignalBlocker quiet(this->Reversed);
  QString map = QString::fromStdString(word);
  const bool reversed = map.endsWith(scene::ReversedColormap);
  map.chop(reversed ? static_cast<int>(QString(scene::ReversedColormap).size()) : 0);
  this->Reversed->setChecked(reversed);
  this->Colormap->Show(map.toStdString());
}

//------------------------------------------------------------------------------
void ColorsGroup::SwitchRange(bool automatic)
{
  if (automatic)
  {
    this->Edited->Change([](scene::Settings& settings) { settings.Remove("--range"); });
  }
  else if (const std::optional<std::array<double, 2>> range = this->ReadRange())
  {
    this->Edited->Change([&range](scene::Settings& settings) {
      // A range of one value has no first and last colour.
      const double most = (*range)[0] < (*range)[1] ? (*range)[1] : (*range)[0] + 1.0;
      settings.Set("--range", scene::WriteNumbers({ (*range)[0], most }));
      settings.Remove("--color");
    });
  }
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void ColorsGroup::SetRange()
{
  const std::string words =
    (this->Least->text().trimmed() + "," + this->Most->text().trimmed()).toStdString();
  if (!this->Automatic->isChecked() && words != this->Edited->Get().Get("--range"))
  {
    this->Edited->Change([&words](scene::Settings& settings) { settings.Set("--range", words); });
  }
}

//------------------------------------------------------------------------------
void ColorsGroup::Paint()
{
  this->Edited->Change([this](scene::Settings& settings) {
    settings.Remove("--color");
    if (this->Solid->isChecked())
    {
      for (const char* other : OfValues)
      {
        settings.Remove(other);
      }
      settings.Set("--color", this->Color->GetColor().name().toStdString());
    }
  });
}

//------------------------------------------------------------------------------
void ColorsGroup::ShowArrays()
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
void ColorsGroup::ShowComponents(const std::string& name, const QString& component)
{
  const std::map<std::string, int>& all = this->Edited->GetFacts().Components;
  const auto found = all.find(name);
  const int count = found == all.end() ? 1 : found->second;
  const QSignalBlocker quiet(this->Component);
  this->Component->clear();
  this->Component->addItem("automatic", "");
  this->Component->setItemData(
    0, "The magnitude; bytes of 3 or 4 components are colours", Qt::ToolTipRole);
  this->Component->addItem("magnitude", "magnitude");
  for (int i = 0; i < count; ++i)
  {
    this->Component->addItem(QString::number(i), QString::number(i));
  }
  if (this->Component->findData(component) < 0) // of a file that is not read yet
  {
    this->Component->addItem(component, component);
  }
  this->Component->setCurrentIndex(this->Component->findData(component));
  SetIdle(this->Component,
    !name.empty() && (count > 1 || !component.isEmpty())
      ? ""
      : "Has an effect on arrays with several numbers for each point or cell.");
}

//------------------------------------------------------------------------------
void ColorsGroup::ShowSettings()
{
  const QSignalBlocker quiet[] = { QSignalBlocker(this->ColorBy), QSignalBlocker(this->Automatic),
    QSignalBlocker(this->Solid) };
  const scene::Settings& settings = this->Edited->Get();
  const scene::LookChoice look = settings.Parse().Look;
  const ByValue by = GetByValue(settings, look, this->Edited->GetFacts());
  const QString name = QString::fromStdString(by.Name);
  if (this->ColorBy->findData(name) < 0)
  {
    this->ColorBy->addItem(name, name);
  }
  this->ColorBy->setCurrentIndex(this->ColorBy->findData(name));
  this->ShowComponents(by.Name, by.Component);
  this->ShowMap(look.Colormap);
  ShowFlag(this->Bar, settings, "--scalar-bar");
  SetIdle(this->Bar,
    this->Bar->isChecked() || this->HasValues(name, by.Component)
      ? ""
      : "Has an effect where an array of values gives the colours.");
  const bool ranged = settings.Has("--range");
  this->Automatic->setChecked(!ranged);
  const QStringList ends = QString::fromStdString(settings.Get("--range")).split(',');
  this->Least->setText(ends.value(0));
  this->Most->setText(ends.value(1));
  for (QLineEdit* end : { this->Least, this->Most })
  {
    SetIdle(end, ranged ? "" : "Has an effect where the range is not automatic.");
  }
  this->Solid->setChecked(look.Solid.has_value());
  if (look.Solid)
  {
    const scene::Color& color = *look.Solid;
    this->Color->SetColor(QColor::fromRgbF(color[0], color[1], color[2]));
  }
}
}
