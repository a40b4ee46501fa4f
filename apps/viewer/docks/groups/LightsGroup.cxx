// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightsGroup.h"

#include "LightEdit.h"
#include "NewLights.h"
#include "Number.h"
#include "OptionEdits.h"
#include "Options.h"
#include "Presets.h"
#include "Rows.h"
#include "SunEdit.h"
#include "TypedZones.h"

#include <QEvent>
#include <QFormLayout>
#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>

#include <algorithm>

namespace viewer
{
namespace
{
constexpr int LightsHeight = 108;
constexpr int LinesOfNote = 2;
constexpr int SwatchSize = 14;
const char* const Kinds[] = { "sun", "spot", "point" };

// A disc of the light's colour, with a rim that keeps white visible.
QIcon MakeSwatch(const look::LightChoice& light, const QPalette& palette)
{
  QPixmap swatch(SwatchSize, SwatchSize);
  swatch.fill(Qt::transparent);
  QPainter painter(&swatch);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(palette.color(QPalette::Mid));
  painter.setBrush(QColor::fromRgbF(static_cast<float>(light.Color[0]),
    static_cast<float>(light.Color[1]), static_cast<float>(light.Color[2])));
  painter.drawEllipse(1, 1, SwatchSize - 3, SwatchSize - 3);
  return swatch;
}

std::vector<std::string> GetLights(const Document* document)
{
  return document->Get().GetAll("--light");
}
}

//------------------------------------------------------------------------------
bool LightsGroup::Row::operator==(const Row& other) const
{
  return this->Word == other.Word && this->Name == other.Name && this->Kind == other.Kind &&
    this->Own == other.Own && this->IsOn == other.IsOn && this->CanOwn == other.CanOwn;
}

//------------------------------------------------------------------------------
LightsGroup::LightsGroup(Document* document, QWidget* parent)
  : FoldGroup("Lights", "lights", parent)
  , Edited(document)
  , List(new QTreeWidget(this))
  , OwnButton(new QPushButton("Make my own", this))
  , Note(new QLabel(this))
  , Light(new LightEdit(document, this))
{
  this->List->setObjectName("list");
  this->List->setColumnCount(2);
  this->List->setHeaderHidden(true);
  this->List->setRootIsDecorated(false);
  this->List->setFixedHeight(LightsHeight);
  this->List->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  this->List->header()->setStretchLastSection(false);
  this->List->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  this->List->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  this->GetRows()->addRow(this->List);
  this->GetRows()->addRow(this->MakeButtons());
  this->Note->setObjectName("note");
  this->Note->setWordWrap(true);
  this->Note->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  this->Note->setFixedHeight(LinesOfNote * this->Note->fontMetrics().lineSpacing());
  this->GetRows()->addRow(this->Note);
  this->GetRows()->addRow(this->Light);
  // The first edit copies a preset's light to the settings: rows must not move under the mouse.
  this->OwnButton->setObjectName("makeOwn");
  QSizePolicy kept = this->OwnButton->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  this->OwnButton->setSizePolicy(kept);
  this->GetRows()->addRow(this->OwnButton);
  this->AddFill();
  QObject::connect(this->List, &QTreeWidget::currentItemChanged, this, [this] {
    this->Light->StopPlacing(); // placing was for another light
    this->ShowCurrent();
  });
  QObject::connect(this->List, &QTreeWidget::itemChanged, this, &LightsGroup::Rename);
  QObject::connect(this->OwnButton, &QPushButton::clicked, this, &LightsGroup::MakeOwn);
  QObject::connect(this->Light, &LightEdit::placing, this, &LightsGroup::placing);
  QObject::connect(this->Light, &LightEdit::edited, this, [this](const QString& word) {
    const Row* row = this->GetCurrent();
    row && row->Own < 0
      ? this->TakeEdit(row->Word, word.toStdString())
      : this->SetLight(row ? row->Own : -1, word.toStdString(), this->Light->HasOwnZone());
  });
  QObject::connect(document, &Document::changed, this, &LightsGroup::ShowSettings);
  QObject::connect(document, &Document::factsChanged, this, &LightsGroup::ShowSettings);
  this->ShowSettings();
}

//------------------------------------------------------------------------------
QWidget* LightsGroup::MakeButtons()
{
  auto* all = new QWidget(this);
  auto* row = new QHBoxLayout(all);
  row->setContentsMargins(0, 0, 0, 0);
  auto* add = new QPushButton("Add", all);
  add->setObjectName("add");
  auto* menu = new QMenu(add);
  for (const char* kind : Kinds)
  {
    QString title = kind;
    title[0] = title[0].toUpper();
    QAction* action = menu->addAction(title);
    action->setObjectName(kind);
    QObject::connect(action, &QAction::triggered, this,
      [this, kind] { this->Add(WriteNewLight(*this->Edited, kind)); });
  }
  add->setMenu(menu);
  this->DuplicateButton = new QPushButton("Duplicate", all);
  this->DuplicateButton->setObjectName("duplicate");
  this->RemoveButton = new QPushButton("Remove", all);
  this->RemoveButton->setObjectName("remove");
  for (QPushButton* button : { add, this->DuplicateButton, this->RemoveButton })
  {
    row->addWidget(button, 1);
  }
  QObject::connect(this->DuplicateButton, &QPushButton::clicked, this, &LightsGroup::Duplicate);
  QObject::connect(this->RemoveButton, &QPushButton::clicked, this, &LightsGroup::Remove);
  return all;
}

//------------------------------------------------------------------------------
void LightsGroup::AddFill()
{
  auto* foot = new QWidget(this);
  QFormLayout* rows = relievoQt::MakeRows(foot);
  this->Fill = MakeNumber("--fill", 0.01, 2, foot);
  this->Fill->setObjectName("fill");
  relievoQt::AddRow(rows, "Fill", this->Fill);
  this->FillLabel = qobject_cast<QLabel*>(rows->labelForField(this->Fill));
  auto* line = new QFrame(this); // separates the rows of one light
  line->setFrameShape(QFrame::HLine);
  line->setFrameShadow(QFrame::Sunken);
  this->GetRows()->addRow(line);
  this->GetRows()->addRow(foot);
  QObject::connect(this->Fill, &relievoQt::Number::edited, this, [this](double share) {
    this->Edited->Change(
      [share](scene::Settings& settings) { settings.Set("--fill", words::WriteNumber(share)); });
  });
}

//------------------------------------------------------------------------------
std::vector<LightsGroup::Row> LightsGroup::FindLights() const
{
  std::vector<Row> rows;
  const std::vector<std::string> lights = GetLights(this->Edited);
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const look::LightChoice light = look::ParseLight(lights[i]);
    Row row;
    row.Word = lights[i];
    row.Own = static_cast<int>(i);
    row.Name = QString::fromStdString(light.Name);
    if (row.Name.isEmpty())
    {
      row.Name = QString("light %1").arg(row.Own); // like in reports
    }
    row.Kind = Kinds[static_cast<int>(light.Is)];
    if (light.IsNight())
    {
      const QString part = relievoQt::SunEdit::NamePartOfDay(light.GetAngles()->Elevation);
      row.Kind += ", " + part.section(' ', -1); // twilight or night
    }
    row.Tip = "Double click to name it";
    rows.push_back(row);
  }
  this->AddPresets(rows, !lights.empty());
  return rows;
}

//------------------------------------------------------------------------------
// Adds the file's lights, or VTK's headlight.
void LightsGroup::AddPresets(std::vector<Row>& rows, bool own) const
{
  scene::Settings without = this->Edited->Get();
  without.SetAll("--light", {});
  const scene::RenderOptions options = without.Parse();
  const std::vector<std::string>& ofFile = this->Edited->GetFacts().Lights;
  const bool preset = !options.Lights.empty();
  const bool yields = !ofFile.empty() && (options.YieldsToFile || !preset);
  for (const std::string& kind : ofFile)
  {
    Row row;
    row.Name = "of the file";
    row.Kind = QString::fromStdString(kind);
    row.IsOn = yields && !own;
    row.Tip = row.IsOn ? "The preset's lights, and those that you add, replace it"
                       : "Off: there are other lights";
    rows.push_back(row);
  }
  if (preset && (!yields || own))
  {
    const QString name = QString::fromStdString(options.Preset);
    Row key;
    key.Word = scene::WriteKeyLight(without, this->Edited->GetUpAxis());
    key.Name = name + ": key light";
    key.Kind = own ? "sun, off" : "sun";
    key.IsOn = !own;
    key.CanOwn = true;
    key.Tip = own ? "Off: your own lights are in its place"
                  : "This light belongs to the preset. Edit it to make your own copy";
    rows.push_back(key);
    if (scene::HasMoon(this->Edited->Get()))
    {
      Row moon;
      moon.Name = name + ": moon";
      moon.Kind = "sun";
      moon.Tip = "A weak light while your suns are below the horizon";
      rows.push_back(moon);
    }
    Row fill;
    fill.Name = name + ": fill";
    fill.Kind = "4 suns";
    fill.IsOn = this->Edited->Get().Parse().Fill.value_or(0.0) > 0.0;
    fill.Tip = "Weak suns without shadows; see Fill below";
    rows.push_back(fill);
  }
  if (rows.empty())
  {
    Row row;
    row.Name = options.Surface.Environment.empty() ? "headlight" : "environment";
    row.Kind = options.Surface.Environment.empty() ? "at the camera" : "all around";
    row.Tip = "Lights that you add replace it";
    rows.push_back(row);
  }
}

//------------------------------------------------------------------------------
const LightsGroup::Row* LightsGroup::GetCurrent() const
{
  const int row = this->List->indexOfTopLevelItem(this->List->currentItem());
  return row >= 0 && row < static_cast<int>(this->Rows.size())
    ? &this->Rows[static_cast<std::size_t>(row)]
    : nullptr;
}

//------------------------------------------------------------------------------
void LightsGroup::ShowSettings()
{
  const std::vector<Row> rows = this->FindLights();
  if (rows != this->Rows)
  {
    this->ShowList(rows);
  }
  this->ShowCurrent();
  this->ShowFill();
}

//------------------------------------------------------------------------------
void LightsGroup::ShowList(const std::vector<Row>& rows)
{
  const QSignalBlocker quiet(this->List);
  const auto current = static_cast<std::size_t>(
    std::max(0, this->List->indexOfTopLevelItem(this->List->currentItem())));
  const QString name = current < this->Rows.size() ? this->Rows[current].Name : QString();
  this->Rows = rows;
  this->List->clear();
  for (const Row& row : rows)
  {
    auto* item = new QTreeWidgetItem(this->List, { row.Name, row.Kind });
    item->setToolTip(0, row.Tip);
    item->setToolTip(1, row.Tip);
    item->setIcon(0,
      MakeSwatch(
        row.Word.empty() ? look::LightChoice() : look::ParseLight(row.Word), this->palette()));
    if (row.Own >= 0)
    {
      item->setFlags(item->flags() | Qt::ItemIsEditable);
      continue;
    }
    for (int column = 0; column < 2; ++column)
    {
      QFont font = item->font(column);
      font.setStrikeOut(!row.IsOn && column == 0);
      item->setFont(column, font);
      item->setForeground(column, this->palette().brush(QPalette::Disabled, QPalette::Text));
    }
  }
  // A light that is off is not selected in place of one that is gone: its fields are all grey.
  std::size_t next = std::min(current, rows.size() - 1);
  if (!rows[next].IsOn && rows[next].Name != name)
  {
    const auto on = std::find_if(rows.begin(), rows.end(), [](const Row& row) { return row.IsOn; });
    next = on != rows.end() ? static_cast<std::size_t>(on - rows.begin()) : next;
  }
  this->List->setCurrentItem(this->List->topLevelItem(static_cast<int>(next)));
}

//------------------------------------------------------------------------------
// The list's grey depends on whether the window is dark.
void LightsGroup::changeEvent(QEvent* event)
{
  this->FoldGroup::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !this->Rows.empty())
  {
    this->ShowList(std::vector<Row>(this->Rows));
  }
}

//------------------------------------------------------------------------------
void LightsGroup::ShowCurrent()
{
  const Row* row = this->GetCurrent();
  const bool own = row && row->Own >= 0;
  const bool key = row && row->CanOwn && row->IsOn;
  Q_EMIT this->selected(own ? row->Own : -1);
  this->DuplicateButton->setEnabled(own);
  this->RemoveButton->setEnabled(own);
  this->OwnButton->setVisible(row && row->CanOwn);
  this->OwnButton->setToolTip(row && row->IsOn
      ? "The same light as a --light, to be edited: the picture stays"
      : "Adds this light to yours, for editing");
  this->Note->setText(row ? row->Tip + "." : QString());
  this->Light->setVisible(row && !row->Word.empty());
  if (row && !row->Word.empty())
  {
    this->Light->SetWord(row->Word,
      own     ? LightEdit::OWN
        : key ? LightEdit::PRESET
              : LightEdit::OFF);
  }
}

//------------------------------------------------------------------------------
void LightsGroup::ShowFill()
{
  const scene::RenderOptions options = this->Edited->Get().Parse();
  const bool ofFile = options.YieldsToFile && !this->Edited->GetFacts().Lights.empty();
  const bool has = options.Fill && !ofFile;
  for (QWidget* each :
    { static_cast<QWidget*>(this->Fill), static_cast<QWidget*>(this->FillLabel) })
  {
    each->setEnabled(has);
    each->setToolTip(has ? "How much of the preset's fill is there, which no shadow takes away"
        : ofFile         ? "The file's own lights are in the place of the preset's"
        : options.Surface.Environment.empty() || options.Preset == "none"
        ? "The preset " + QString::fromStdString(options.Preset) + " has no fill"
        : "The environment fills");
  }
  this->Fill->SetValue(has ? *options.Fill : 0.0);
}

//------------------------------------------------------------------------------
void LightsGroup::SetLight(int place, const std::string& word, bool ownZone)
{
  std::vector<std::string> lights = GetLights(this->Edited);
  if (place >= 0 && place < static_cast<int>(lights.size()))
  {
    std::string& light = lights[static_cast<std::size_t>(place)];
    std::vector<std::string> typed = this->Edited->Get().GetAll(TypedZones);
    if ((ownZone || HasTypedZone(this->Edited->Get(), light)) &&
      !HasTypedZone(this->Edited->Get(), word))
    {
      typed.push_back(word);
    }
    light = word;
    this->Edited->Change([&](scene::Settings& settings) {
      settings.SetAll("--light", lights);
      settings.SetAll(TypedZones, typed);
    });
    this->ShowSettings(); // even if nothing has changed
  }
}

//------------------------------------------------------------------------------
void LightsGroup::Add(const std::string& word)
{
  std::vector<std::string> lights = GetLights(this->Edited);
  lights.push_back(word);
  this->Edited->Change(
    [&lights](scene::Settings& settings) { settings.SetAll("--light", lights); });
  this->List->setCurrentItem(
    this->List->topLevelItem(static_cast<int>(GetLights(this->Edited).size()) - 1));
}

//------------------------------------------------------------------------------
void LightsGroup::Duplicate()
{
  const Row* row = this->GetCurrent();
  if (row && row->Own >= 0)
  {
    this->Add(row->Word);
  }
}

//------------------------------------------------------------------------------
void LightsGroup::Remove()
{
  const Row* row = this->GetCurrent();
  std::vector<std::string> lights = GetLights(this->Edited);
  if (row && row->Own >= 0 && row->Own < static_cast<int>(lights.size()))
  {
    lights.erase(lights.begin() + row->Own);
    this->Edited->Change(
      [&lights](scene::Settings& settings) { settings.SetAll("--light", lights); });
  }
}

//------------------------------------------------------------------------------
void LightsGroup::MakeOwn()
{
  const Row* row = this->GetCurrent();
  if (row && row->CanOwn)
  {
    this->Edited->Change([this](scene::Settings& settings) {
      scene::OwnKeyLight(settings, this->Edited->GetUpAxis());
    });
    this->List->setCurrentItem(
      this->List->topLevelItem(static_cast<int>(GetLights(this->Edited).size()) - 1));
  }
}

//------------------------------------------------------------------------------
// The preset's light, with the user's edits.
void LightsGroup::TakeEdit(const std::string& before, const std::string& after)
{
  const look::LightWords was = look::SplitLight(before), is = look::SplitLight(after);
  this->Edited->Change([&](scene::Settings& settings) {
    scene::OwnKeyLight(settings, this->Edited->GetUpAxis());
    std::vector<std::string> lights = settings.GetAll("--light");
    look::LightWords words = look::SplitLight(lights.back());
    words.Numbers = is.Numbers == was.Numbers ? words.Numbers : is.Numbers;
    for (const look::LightWords* each : { &was, &is })
    {
      for (const auto& value : each->Values)
      {
        const std::string edited = words::FindWords(is.Values, value.first);
        if (edited != words::FindWords(was.Values, value.first))
        {
          words::SetWords(words.Values, value.first, edited);
        }
      }
    }
    lights.back() = look::WriteLight(words);
    settings.SetAll("--light", lights);
  });
}

//------------------------------------------------------------------------------
void LightsGroup::Rename(QTreeWidgetItem* item)
{
  const int place = this->List->indexOfTopLevelItem(item);
  if (place < 0 || place >= static_cast<int>(this->Rows.size()) ||
    item->text(0) == this->Rows[static_cast<std::size_t>(place)].Name)
  {
    return;
  }
  const Row& row = this->Rows[static_cast<std::size_t>(place)];
  look::LightWords words = look::SplitLight(row.Word);
  words::SetWords(words.Values, "name", item->text(0).trimmed().toStdString());
  this->SetLight(row.Own, look::WriteLight(words));
  this->Rows.clear(); // the stored text may differ from the typed one
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void LightsGroup::StopPlacing()
{
  this->Light->StopPlacing();
}

//------------------------------------------------------------------------------
void LightsGroup::Select(int own)
{
  this->List->setCurrentItem(this->List->topLevelItem(own)); // the user's lights come first
}

//------------------------------------------------------------------------------
// Rows of a preset's lights begin with its name.
void LightsGroup::SelectNamed(const QString& name)
{
  for (std::size_t i = 0; i < this->Rows.size(); ++i)
  {
    if (this->Rows[i].Name == name || this->Rows[i].Name.endsWith(": " + name))
    {
      this->List->setCurrentItem(this->List->topLevelItem(static_cast<int>(i)));
      return;
    }
  }
}

//------------------------------------------------------------------------------
void LightsGroup::Place(const std::array<double, 3>& place)
{
  const Row* row = this->GetCurrent();
  if (row && row->Own >= 0)
  {
    this->Light->Place(place);
  }
}
}
