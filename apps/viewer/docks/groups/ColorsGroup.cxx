// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorsGroup.h"

#include "ColorButton.h"
#include "ColormapBox.h"
#include "Colormaps.h"
#include "Labels.h"
#include "OptionEdits.h"
#include "Options.h"
#include "RangeEdit.h"
#include "SceneFacts.h"
#include "StopsEdit.h"

#include "vtkColorTransferFunction.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QToolButton>

#include <algorithm>

namespace viewer
{
namespace
{
constexpr const char* OfValues[] = { "--color-by", "--colormap", "--range", "--scalar-bar",
  "--bar" };

// The row of *Colour by* that leads to the layers; no array has this name.
constexpr const char* LayersRow = "\n";

constexpr int MostSteps = 256;
constexpr int NamedStops = 5; // first number of stops for a named map

// In reverse order.
std::vector<look::ColorStop> TurnRound(std::vector<look::ColorStop> stops)
{
  std::reverse(stops.begin(), stops.end());
  for (look::ColorStop& stop : stops)
  {
    stop.Place = 1.0 - stop.Place;
  }
  return stops;
}

// The array and the component of --color-by, "" for none. Array names may end like a component.
struct ByValue
{
  std::string Name;
  QString Component;
};

ByValue GetByValue(
  const scene::Settings& settings, const look::LookChoice& look, const Facts& facts)
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
ColorsGroup::ColorsGroup(
  Document* document, RangeReader read, RangeReader readSeen, QWidget* parent)
  : FoldGroup("Colours", "colors", parent)
  , Edited(document)
  , ReadRange(std::move(read))
  , ReadSeen(std::move(readSeen))
  , ColorBy(new QComboBox(this))
  , Component(new QComboBox(this))
  , Colormap(new ColormapBox(this))
  , Reversed(new QCheckBox("Reversed", this))
  , Log(new QCheckBox("Logarithmic", this))
  , Steps(new QSpinBox(this))
  , Stops(new StopsEdit(this))
  , Nan(new ColorButton(this))
  , Range(new relievoQt::RangeEdit(this))
  , Symmetric(new QCheckBox("Symmetric around zero", this))
  , Seen(new QPushButton("Fit to visible", this))
  , Bar(MakeFlag(document, "--scalar-bar", this))
  , Solid(new QCheckBox("One colour", this))
  , Color(new ColorButton(this))
{
  QFormLayout* rows = this->GetRows();
  this->ColorBy->setObjectName("colorby");
  // Long names must not make the panel wider.
  this->ColorBy->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->ColorBy->setToolTip("The point or cell array whose values give the colours");
  this->Component->setObjectName("component");
  this->Component->setToolTip("The component of arrays with several numbers per point or cell");
  rows->addRow("Colour by", this->ColorBy);
  rows->addRow("Component", this->Component);
  this->AddMap();
  this->AddRange();
  this->Bar->setToolTip("The colours and their values, at the right of the picture");
  rows->addRow(this->Bar);
  this->BarPlace = AddChoice(document, rows, "--bar", "right, if shown",
    "Where the colour bar is shown; it is horizontal at the bottom and the top");
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
  QObject::connect(this->Solid, &QCheckBox::toggled, this, &ColorsGroup::Paint);
  QObject::connect(this->Color, &ColorButton::edited, this, [this] {
    const QSignalBlocker still(this->Solid);
    this->Solid->setChecked(true);
    this->Paint();
  });
  QObject::connect(document, &Document::changed, this, &ColorsGroup::ShowSettings);
  QObject::connect(document, &Document::factsChanged, this, &ColorsGroup::ShowArrays);
  // Updates when the picture shows the requested data.
  QObject::connect(document, &Document::asked, this, &ColorsGroup::ShowFound, Qt::QueuedConnection);
  QObject::connect(document, &Document::shown, this, &ColorsGroup::ShowFound);
  this->ShowArrays();
  this->ColorBy->view()->installEventFilter(this);
}

//------------------------------------------------------------------------------
void ColorsGroup::AddMap()
{
  QFormLayout* rows = this->GetRows();
  this->Colormap->setObjectName("colormap");
  this->Colormap->setEditable(true);
  this->Colormap->setInsertPolicy(QComboBox::NoInsert);
  this->Colormap->setToolTip(
    "A map, or colours between commas, evenly spaced or at shares of the range, such as "
    "black,0.3=#ff8000,white");
  this->Reversed->setObjectName("reversed");
  this->Reversed->setToolTip("Reverses the colours: the largest value has the first one");
  this->Log->setObjectName("log");
  this->Log->setToolTip(
    "By the logarithm of the values; those not above zero have the first colour");
  this->Steps->setObjectName("steps");
  this->Steps->setRange(1, MostSteps);
  this->Steps->setSpecialValueText("Smooth");
  this->Steps->setSuffix(" colours");
  this->Steps->setKeyboardTracking(false);
  this->Steps->setToolTip("Number of colours; smooth: continuous");
  this->Nan->setObjectName("nan");
  this->Nan->setToolTip("The colour of missing values (NaN)");
  auto* fold = new QToolButton(this);
  fold->setObjectName("editStops");
  fold->setText("Edit colours");
  fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold->setArrowType(Qt::RightArrow);
  fold->setAutoRaise(true);
  fold->setCheckable(true);
  this->Stops->hide();
  rows->addRow("Colour map", this->Colormap);
  rows->addRow("", fold);
  rows->addRow(this->Stops);
  rows->addRow("", this->Reversed);
  rows->addRow("", this->Log);
  rows->addRow("Steps", this->Steps);
  rows->addRow("Missing", this->Nan);
  QObject::connect(fold, &QToolButton::toggled, this, [this, fold](bool open) {
    fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    this->Stops->setVisible(open);
    this->ShowStops();
  });
  QObject::connect(
    this->Colormap->lineEdit(), &QLineEdit::editingFinished, this, [this] { this->TakeMap(); });
  QObject::connect(this->Colormap, static_cast<void (QComboBox::*)(int)>(&QComboBox::activated),
    this, [this] { this->TakeMap(); });
  for (QCheckBox* box : { this->Reversed, this->Log })
  {
    QObject::connect(box, &QCheckBox::toggled, this, [this] { this->TakeMap(); });
  }
  QObject::connect(this->Steps, static_cast<void (QSpinBox::*)(int)>(&QSpinBox::valueChanged), this,
    [this] { this->TakeMap(); });
  QObject::connect(this->Nan, &ColorButton::edited, this, [this] {
    this->ChangeMap(
      [this](look::Colormap& map) { map.Nan = this->Nan->GetColor().name().toStdString(); });
  });
  QObject::connect(
    this->Stops, &StopsEdit::edited, this, [this](const std::vector<look::ColorStop>& stops) {
      this->ChangeMap([&stops](look::Colormap& map) {
        map.Map = look::WriteStops(map.Reversed ? TurnRound(stops) : stops);
      });
    });
}

//------------------------------------------------------------------------------
void ColorsGroup::AddRange()
{
  this->Range->SetAutomaticToolTip("From the smallest to the largest value of all files");
  this->Symmetric->setObjectName("symmetric");
  this->Symmetric->setToolTip("Symmetric around zero, up to the largest absolute value");
  this->Seen->setObjectName("fitSeen");
  this->Seen->setToolTip(
    "Takes the smallest and the largest visible value; hidden ones do not count");
  QFormLayout* rows = this->GetRows();
  rows->addRow("Range", this->Range);
  rows->addRow("", this->Symmetric);
  rows->addRow("", this->Seen);
  QObject::connect(
    this->Range, &relievoQt::RangeEdit::automaticSwitched, this, &ColorsGroup::SwitchRange);
  QObject::connect(this->Range, &relievoQt::RangeEdit::typed, this,
    [this](const QString& least, const QString& most) {
      this->SetRange((least + "," + most).toStdString());
    });
  QObject::connect(this->Symmetric, &QCheckBox::toggled, this,
    [this](bool on) { this->SetRange(on ? "symmetric" : ""); });
  QObject::connect(this->Seen, &QPushButton::clicked, this, [this] {
    if (const std::optional<std::array<double, 2>> range = this->ReadSeen(true))
    {
      this->SetRange(words::WriteNumbers({ (*range)[0], (*range)[1] }));
    }
  });
}

//------------------------------------------------------------------------------
bool ColorsGroup::HasValues(const QString& name, const QString& component) const
{
  return !component.isEmpty() || this->Edited->GetFacts().Valueless.count(name.toStdString()) == 0;
}

//------------------------------------------------------------------------------
void ColorsGroup::SetColorBy(const QString& name, const QString& component)
{
  if (name == LayersRow)
  {
    this->ShowSettings();
    Q_EMIT this->layersWanted();
    return;
  }
  this->Edited->Change([&](scene::Settings& settings) {
    const QString words = name.isEmpty() || component.isEmpty() ? name : name + "," + component;
    SetOption(settings, "--color-by", words.toStdString());
    if (!name.isEmpty())
    {
      settings.Remove("--color");
    }
    if (!name.isEmpty() && this->Edited->Get().Get("--color-by").empty())
    {
      settings.Set("--scalar-bar", ""); // the first array: its values are read from the bar
    }
    if (!this->HasValues(name, component)) // the bar would be empty
    {
      settings.Remove("--scalar-bar");
      settings.Remove("--bar");
    }
  });
  this->ShowSettings();
}

//------------------------------------------------------------------------------
// The value in the controls, or the typed word.
void ColorsGroup::TakeMap()
{
  this->ChangeMap([this](look::Colormap& map) {
    const std::string typed = this->Colormap->currentText().trimmed().toStdString();
    map.Map = typed.empty() ? map.Map : typed;
    map.Reversed = this->Reversed->isChecked();
    map.Log = this->Log->isChecked();
    map.Steps = this->Steps->value() > 1 ? this->Steps->value() : 0;
  });
}

//------------------------------------------------------------------------------
void ColorsGroup::ChangeMap(const std::function<void(look::Colormap&)>& change)
{
  look::Colormap map = look::Colormap::Parse(this->Edited->Get().Parse().Look.Colormap);
  change(map);
  std::string word = map.Write();
  word = word == look::DefaultColormap ? std::string() : word;
  if (word != this->Edited->Get().Get("--colormap"))
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
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Reversed), QSignalBlocker(this->Log),
    QSignalBlocker(this->Steps) };
  const look::Colormap map = look::Colormap::Parse(word);
  this->Reversed->setChecked(map.Reversed);
  this->Log->setChecked(map.Log);
  this->Steps->setValue(std::max(1, map.Steps));
  const look::Color nan =
    map.Nan.empty() ? look::Color{ 0.5, 0.5, 0.5 } : look::ParseColor("nan", map.Nan);
  this->Nan->SetColor(QColor::fromRgbF(nan[0], nan[1], nan[2]));
  this->Colormap->Show(map.Map);
  this->ShowStops();
}

//------------------------------------------------------------------------------
// The stops shown; for a named map, an approximation.
void ColorsGroup::ShowStops()
{
  if (this->Stops->isHidden())
  {
    return;
  }
  const look::Colormap map = look::Colormap::Parse(this->Edited->Get().Parse().Look.Colormap);
  std::vector<look::ColorStop> stops = look::ParseStops(map.Map);
  if (stops.empty())
  {
    const auto colors = look::MakeColormap(map.Map, { 0.0, 1.0 });
    for (int i = 0; i < NamedStops; ++i)
    {
      look::ColorStop stop;
      stop.Place = static_cast<double>(i) / (NamedStops - 1);
      colors->GetColor(stop.Place, stop.Shown.data());
      stops.push_back(stop);
    }
  }
  this->Stops->Show(map.Reversed ? TurnRound(stops) : stops, this->ReadRange(false), map.Log);
}

//------------------------------------------------------------------------------
void ColorsGroup::SwitchRange(bool automatic)
{
  if (automatic)
  {
    this->SetRange("");
  }
  else if (const std::optional<std::array<double, 2>> range = this->ReadRange(true))
  {
    // A range of one value has no distinct ends.
    const double most = (*range)[0] < (*range)[1] ? (*range)[1] : (*range)[0] + 1.0;
    this->SetRange(words::WriteNumbers({ (*range)[0], most }));
  }
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void ColorsGroup::SetRange(const std::string& words)
{
  if (words != this->Edited->Get().Get("--range"))
  {
    this->Edited->Change([&words](scene::Settings& settings) {
      SetOption(settings, "--range", words);
      if (!words.empty())
      {
        settings.Remove("--color");
      }
    });
  }
  this->ShowSettings();
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
    this->ColorBy->insertSeparator(this->ColorBy->count());
    this->ColorBy->addItem(QString("Depth, normals and others") + QChar(0x2026), LayersRow);
    this->ColorBy->setItemData(
      this->ColorBy->count() - 1, "They are shown by the panel Layers", Qt::ToolTipRole);
    this->EnableLayersRow(this->ColorBy->view()->isVisible());
  }
  this->ShowSettings();
}

//------------------------------------------------------------------------------
// Keys and the wheel step through the closed box, and must not leave the panel.
void ColorsGroup::EnableLayersRow(bool enabled)
{
  if (auto* rows = qobject_cast<QStandardItemModel*>(this->ColorBy->model()))
  {
    rows->item(this->ColorBy->findData(LayersRow))->setEnabled(enabled);
  }
}

//------------------------------------------------------------------------------
bool ColorsGroup::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::Show || event->type() == QEvent::Hide)
  {
    this->EnableLayersRow(event->type() == QEvent::Show); // the list opens or closes
  }
  return this->FoldGroup::eventFilter(watched, event);
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
  if (this->Component->findData(component) < 0) // of a file still being read
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
  const QSignalBlocker quiet[] = { QSignalBlocker(this->ColorBy), QSignalBlocker(this->Symmetric),
    QSignalBlocker(this->Solid) };
  const scene::Settings& settings = this->Edited->Get();
  const look::LookChoice look = settings.Parse().Look;
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
  ShowChoice(this->BarPlace, settings, "--bar");
  SetIdle(this->Bar,
    this->Bar->isChecked() || this->HasValues(name, by.Component)
      ? ""
      : "Has an effect where an array of values gives the colours.");
  const QStringList ends = QString::fromStdString(settings.Get("--range")).split(',');
  this->Range->Show(look.Range ? ends.value(0) : QString(), look.Range ? ends.value(1) : QString());
  this->Symmetric->setChecked(look.Symmetric);
  SetIdle(this->Symmetric,
    look.Range                                   ? "Has an effect where the range is automatic."
      : look::Colormap::Parse(look.Colormap).Log ? "Logarithms need positive values."
                                                 : "");
  SetIdle(this->Seen,
    by.Name.empty()                                            ? "Choose an array to colour by."
      : FindColorLayer(look, this->Edited->GetFacts()).empty() ? "Has an effect on surfaces."
                                                               : "");
  this->ShowFound();
  this->Solid->setChecked(look.Solid.has_value());
  if (look.Solid)
  {
    const look::Color& color = *look.Solid;
    this->Color->SetColor(QColor::fromRgbF(color[0], color[1], color[2]));
  }
}

//------------------------------------------------------------------------------
// Called when the picture has them.
void ColorsGroup::ShowFound()
{
  this->Range->ShowFound(this->ReadRange(false).value_or(std::array<double, 2>{ 0.0, 0.0 }));
  this->ShowStops();
}
}
