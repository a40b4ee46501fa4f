// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayersPanel.h"

#include "vtkRelievoLayerCatalogue.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStringList>
#include <QTableWidget>

#include <cmath>

namespace viewer
{
namespace
{
const std::string Stage = "display";
}

//------------------------------------------------------------------------------
QString WriteValues(const ProbeValue& value)
{
  QStringList words;
  for (const double number : value.Values)
  {
    // Ids in full, and metres of a map with their centimetres.
    const double size = std::abs(number);
    const bool whole = size < 1e15 && number == std::floor(number);
    words +=
      whole ? QString::number(number, 'f', 0) : QString::number(number, 'g', size < 1e5 ? 7 : 10);
  }
  return words.join(", ");
}

//------------------------------------------------------------------------------
LayersPanel::LayersPanel(Document* document, QWidget* parent)
  : Panel(document, parent)
{
  QGroupBox* shown = this->AddGroup("Shown as the picture", "shown");
  this->Layer = new QComboBox(shown);
  this->Layer->setObjectName("layer");
  this->Grey = new QCheckBox("In grey", shown);
  this->Grey->setObjectName("grey");
  GetRows(shown)->addRow("Layer", this->Layer);
  GetRows(shown)->addRow(this->Grey);
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
  this->Values->setTabKeyNavigation(false); // Tab goes on to the next control
  GetRows(probe)->addRow(this->Probing);
  GetRows(probe)->addRow(this->Values);
  this->Fill(probe);
  QObject::connect(this->Layer,
    static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged), this, [this] {
      this->Edited->Change([this](scene::Settings& settings) {
        settings.SetParameter(Stage, "layer", this->Layer->currentData().toString().toStdString());
      });
    });
  QObject::connect(this->Grey, &QCheckBox::toggled, this, [this](bool on) {
    this->Edited->Change(
      [on](scene::Settings& settings) { settings.SetParameter(Stage, "grey", on ? "on" : "off"); });
  });
  QObject::connect(this->Probing, &QCheckBox::toggled, this, [this](bool on) {
    this->Values->setRowCount(0);
    Q_EMIT this->probing(on);
  });
  QObject::connect(document, &Document::changed, this, [this] { this->ShowSettings(); });
  QObject::connect(document, &Document::factsChanged, this, [this] { this->ShowLayers(); });
  this->ShowLayers();
}

//------------------------------------------------------------------------------
bool LayersPanel::IsProbing() const
{
  return this->Probing->isChecked();
}

//------------------------------------------------------------------------------
void LayersPanel::ShowLayers()
{
  {
    const QSignalBlocker quiet(this->Layer);
    this->Layer->clear();
    this->Layer->addItem("The picture itself", "");
    for (int i = 0; i < vtkRelievoLayerCatalogue::GetNumberOfLayers(); ++i)
    {
      std::string name = vtkRelievoLayerCatalogue::GetLayerName(i);
      name = vtkRelievoLayerCatalogue::GetIsLayer(name) ? name : "shadow_0";
      const QString words = QString::fromStdString(name);
      this->Layer->addItem(words, words);
      this->Layer->setItemData(this->Layer->count() - 1,
        QString::fromStdString(vtkRelievoLayerCatalogue::GetLayerHelp(i)), Qt::ToolTipRole);
    }
    for (const std::string& name : this->Edited->GetFacts().Layers)
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
  const QSignalBlocker quiet[] = { QSignalBlocker(this->Layer), QSignalBlocker(this->Grey) };
  const scene::Settings& settings = this->Edited->Get();
  const QString words = QString::fromStdString(settings.GetParameter(Stage, "layer"));
  if (this->Layer->findData(words) < 0)
  {
    this->Layer->addItem(words, words);
  }
  this->Layer->setCurrentIndex(this->Layer->findData(words));
  this->Grey->setChecked(settings.GetParameter(Stage, "grey") == "on");
}

//------------------------------------------------------------------------------
void LayersPanel::ShowValues(const std::vector<ProbeValue>& values)
{
  this->Values->setRowCount(static_cast<int>(values.size()));
  for (int row = 0; row < this->Values->rowCount(); ++row)
  {
    const ProbeValue& value = values[static_cast<std::size_t>(row)];
    const QString texts[] = { QString::fromStdString(value.Layer),
      value.IsBackground ? "background" : WriteValues(value) };
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
  this->Values->resizeRowsToContents(); // where many components are on several lines
}
}
