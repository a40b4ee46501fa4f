// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayersPanel.h"

#include "ColormapBox.h"
#include "Labels.h"
#include "LayerWords.h"
#include "Numbers.h"
#include "RangeEdit.h"
#include "Values.h"

#include "vtkRelievoLayer.h"
#include "vtkRelievoLayerCatalogue.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStringList>
#include <QTableWidget>

#include <cmath>
#include <utility>

namespace viewer
{
namespace
{
const std::string Stage = "display";

// A title of the rows that follow, which cannot be chosen.
void AddTitle(QComboBox* box, const QString& title)
{
  box->insertSeparator(box->count());
  box->addItem(title);
  QFont bold = box->font();
  bold.setBold(true);
  box->setItemData(box->count() - 1, bold, Qt::FontRole);
  if (auto* rows = qobject_cast<QStandardItemModel*>(box->model()))
  {
    rows->item(box->count() - 1)->setEnabled(false);
  }
}
}

//------------------------------------------------------------------------------
QString WriteValues(const ProbeValue& value)
{
  QStringList words;
  for (const double number : value.Values)
  {
    // Enough digits for ids, and for centimetres in map coordinates.
    const double size = std::abs(number);
    const bool whole = size < 1e15 && number == std::floor(number);
    words +=
      whole ? QString::number(number, 'f', 0) : QString::number(number, 'g', size < 1e5 ? 7 : 10);
  }
  return words.join(", ");
}

//------------------------------------------------------------------------------
LayersPanel::LayersPanel(Document* document, RangeReader read, QWidget* parent)
  : Panel(document, parent)
  , ReadRange(std::move(read))
{
  QGroupBox* shown = this->AddGroup("Shown as the picture", "shown");
  this->Layer = new QComboBox(shown);
  this->Layer->setObjectName("layer");
  GetRows(shown)->addRow("Layer", this->Layer);
  this->AddColors(shown);
  QGroupBox* probe = this->AddGroup("Under the mouse", "probe");
  this->Probing = new QCheckBox("Read values", probe);
  this->Probing->setObjectName("probing");
  this->Probing->setToolTip("Draws the layers once after each change of the picture");
  this->Values = new QTableWidget(0, 2, probe);
  this->Values->setObjectName("values");
  this->Values->setHorizontalHeaderLabels({ "Layer", "Value" });
  this->Values->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  this->Values->horizontalHeader()->setStretchLastSection(true);
  this->Values->verticalHeader()->hide();
  this->Values->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Values->setMinimumHeight(260);
  this->Values->setTabKeyNavigation(false); // Tab moves to the next control
  GetRows(probe)->addRow(this->Probing);
  GetRows(probe)->addRow(this->Values);
  this->Fill(probe);
  QObject::connect(this->Layer,
    static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), this,
    [this] { this->SetLayer(this->Layer->currentData().toString().toStdString()); });
  QObject::connect(this->Probing, &QCheckBox::toggled, this, [this](bool on) {
    this->Values->setRowCount(0);
    Q_EMIT this->probing(on);
  });
  QObject::connect(document, &Document::changed, this, [this] { this->ShowSettings(); });
  QObject::connect(document, &Document::factsChanged, this, [this] { this->ShowLayers(); });
  this->ShowLayers();
}

//------------------------------------------------------------------------------
void LayersPanel::AddColors(QGroupBox* shown)
{
  this->Colormap = new ColormapBox(shown);
  this->Colormap->setObjectName("shownColormap");
  this->Reversed = new QCheckBox("Reversed", shown);
  this->Reversed->setObjectName("shownReversed");
  this->Reversed->setToolTip("Reverses the colours: the largest value has the first one");
  this->Range = new relievoQt::RangeEdit(shown);
  this->Range->setObjectName("shownRange");
  this->Range->SetAutomaticToolTip(
    "From the smallest to the largest visible value, without those of an endless ground");
  this->Grey = new QCheckBox("In grey", shown);
  this->Grey->setObjectName("grey");
  QFormLayout* rows = GetRows(shown);
  rows->addRow("Colour map", this->Colormap);
  rows->addRow("", this->Reversed);
  rows->addRow("Range", this->Range);
  rows->addRow(this->Grey);
  QObject::connect(this->Colormap,
    static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), this,
    [this] { this->Set("colormap", this->Colormap->currentText().toStdString()); });
  for (const auto& [box, parameter] :
    { std::pair(this->Reversed, "reversed"), std::pair(this->Grey, "grey") })
  {
    QObject::connect(box, &QCheckBox::toggled, this,
      [this, name = parameter](bool on) { this->Set(name, on ? "on" : "off"); });
  }
  QObject::connect(
    this->Range, &relievoQt::RangeEdit::automaticSwitched, this, [this](bool automatic) {
      const std::array<double, 2> range = this->ReadRange(true);
      const bool known = std::isfinite(range[0]) && range[0] < range[1];
      this->Set("range",
        automatic ? "0/0"
          : known ? words::WriteNumber(range[0]) + "/" + words::WriteNumber(range[1])
                  : "0/1");
    });
  QObject::connect(this->Range, &relievoQt::RangeEdit::typed, this,
    [this](const QString& least, const QString& most) {
      least.toDouble() < most.toDouble() ? this->Set("range", (least + "/" + most).toStdString())
                                         : this->ShowSettings();
    });
}

//------------------------------------------------------------------------------
// A range applies only to the layer for which it was given.
void LayersPanel::SetLayer(const std::string& layer)
{
  this->Edited->Change([&layer](scene::Settings& settings) {
    settings.SetParameter(Stage, "layer", layer);
    if (settings.HasParameter(Stage, "range"))
    {
      settings.SetParameter(Stage, "range", "0/0");
    }
  });
  this->ShowSettings(); // restores a refused value
}

//------------------------------------------------------------------------------
void LayersPanel::Set(const char* parameter, const std::string& value)
{
  this->Edited->Change([parameter, &value](scene::Settings& settings) {
    settings.SetParameter(Stage, parameter, value);
  });
  this->ShowSettings(); // restores a refused value
}

//------------------------------------------------------------------------------
// Why the range or the colour map has no effect; empty if it has one.
QString LayersPanel::ExplainIdle(bool ofColors) const
{
  const std::string layer = this->Edited->Get().GetParameter(Stage, "layer");
  const vtkRelievoLayer& known = vtkRelievoLayerCatalogue::GetIsOfLight(layer)
    ? vtkRelievoLayerCatalogue::GetOfLight()
    : vtkRelievoLayerCatalogue::Find(layer);
  if (layer.empty())
  {
    return "Has an effect where a layer is shown.";
  }
  if (ofColors && this->Edited->Get().GetParameter(Stage, "grey") == "on")
  {
    return "Has an effect where the layer is not in grey.";
  }
  return known.Kind == vtkRelievoLayer::NUMBER || known.Kind == vtkRelievoLayer::ARRAY
    ? ""
    : "Applies to layers of single values, such as depth, and to arrays.";
}

//------------------------------------------------------------------------------
bool LayersPanel::IsProbing() const
{
  return this->Probing->isChecked();
}

//------------------------------------------------------------------------------
// A row for a layer of the catalogue, or for each light's shadow.
void LayersPanel::AddLayer(const std::string& name, const QString& help)
{
  relievoQt::LightNames listed = { { name, "" } };
  if (!vtkRelievoLayerCatalogue::GetIsLayer(name))
  {
    listed = this->Lights.empty() ? relievoQt::LightNames{ { "shadow_0", "" } } : this->Lights;
  }
  for (const auto& row : listed)
  {
    this->Layer->addItem(
      relievoQt::NameLayer(row.first, this->Lights), QString::fromStdString(row.first));
    this->Layer->setItemData(this->Layer->count() - 1, help, Qt::ToolTipRole);
  }
}

//------------------------------------------------------------------------------
void LayersPanel::ShowLayers()
{
  {
    const QSignalBlocker quiet(this->Layer);
    this->Layer->clear();
    this->Layer->addItem("The picture itself", "");
    for (const char* group : { "Surfaces", "Objects", "Light and effects", "Volumes" })
    {
      AddTitle(this->Layer, group);
      for (int i = 0; i < vtkRelievoLayerCatalogue::GetNumberOfLayers(); ++i)
      {
        const std::string name = vtkRelievoLayerCatalogue::GetLayerName(i);
        if (relievoQt::GroupLayer(name) == group)
        {
          this->AddLayer(name, QString::fromStdString(vtkRelievoLayerCatalogue::GetLayerHelp(i)));
        }
      }
    }
    const std::vector<std::string>& arrays = this->Edited->GetFacts().Layers;
    if (!arrays.empty())
    {
      AddTitle(this->Layer, "Arrays of the files");
    }
    for (const std::string& name : arrays)
    {
      const QString words = QString::fromStdString(name);
      this->Layer->addItem(words, words);
    }
  }
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void LayersPanel::ShowSettings()
{
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Layer), QSignalBlocker(this->Grey),
    QSignalBlocker(this->Reversed) };
  const scene::Settings& settings = this->Edited->Get();
  const QString words = QString::fromStdString(settings.GetParameter(Stage, "layer"));
  if (this->Layer->findData(words) < 0)
  {
    this->Layer->addItem(relievoQt::NameLayer(words.toStdString(), this->Lights), words);
  }
  this->Layer->setCurrentIndex(this->Layer->findData(words));
  this->Grey->setChecked(settings.GetParameter(Stage, "grey") == "on");
  this->Reversed->setChecked(settings.GetParameter(Stage, "reversed") == "on");
  this->Colormap->Show(settings.GetParameter(Stage, "colormap"));
  const std::vector<std::string> ends = words::Split(settings.GetParameter(Stage, "range"), '/');
  const bool given = ends.size() == 2 && ends[0] != ends[1];
  this->Range->Show(given ? QString::fromStdString(ends[0]) : QString(),
    given ? QString::fromStdString(ends[1]) : QString());
  this->Range->SetUnit(relievoQt::GetUnit(words.toStdString()));
  SetIdle(this->Range, this->ExplainIdle(false));
  for (QWidget* of :
    { static_cast<QWidget*>(this->Colormap), static_cast<QWidget*>(this->Reversed) })
  {
    SetIdle(of, this->ExplainIdle(true));
  }
  SetIdle(this->Grey, this->ExplainIdle(false));
  this->ShowRange();
}

//------------------------------------------------------------------------------
void LayersPanel::Follow(const relievoQt::LightNames& lights)
{
  if (this->Lights != lights)
  {
    this->Lights = lights;
    this->ShowLayers();
  }
  this->ShowRange();
}

//------------------------------------------------------------------------------
void LayersPanel::ShowRange()
{
  this->Range->ShowFound(this->Edited->Get().GetParameter(Stage, "layer").empty()
      ? std::array<double, 2>{ 0.0, 0.0 }
      : this->ReadRange(false));
}

//------------------------------------------------------------------------------
void LayersPanel::ShowValues(const std::vector<ProbeValue>& values)
{
  this->Values->setRowCount(static_cast<int>(values.size()));
  for (int row = 0; row < this->Values->rowCount(); ++row)
  {
    const ProbeValue& value = values[static_cast<std::size_t>(row)];
    const QString texts[] = { relievoQt::NameLayer(value.Layer),
      value.IsBackground ? "background" : relievoQt::AddUnit(WriteValues(value), value.Layer) };
    for (int column = 0; column < 2; ++column)
    {
      QTableWidgetItem* item = this->Values->item(row, column);
      if (!item)
      {
        item = new QTableWidgetItem();
        this->Values->setItem(row, column, item);
      }
      item->setText(texts[column]);
      item->setToolTip(texts[column]);
    }
  }
  this->Values->resizeRowsToContents(); // components may fill several lines
}
}
