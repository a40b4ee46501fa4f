// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoShadowControls.h"

#include "Number.h"
#include "Rows.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

//------------------------------------------------------------------------------
pqRelievoShadowControls::pqRelievoShadowControls(QWidget* parent)
  : Superclass(parent)
  , On(new QCheckBox("Shadows", this))
  , Rest(new QWidget(this))
{
  this->On->setObjectName("on");
  MakeHead(this->On);
  this->On->setToolTip("Lights that are blocked leave shadows");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->On);
  layout->addWidget(this->Rest);
  this->Rest->setObjectName("rest");
  QFormLayout* rows = relievoQt::MakeRows(this->Rest);

  auto* method = new QComboBox(this->Rest);
  method->setObjectName("method");
  method->addItem("Map", 0);
  method->addItem("Forward", 1);
  method->addItem("Warped", 2);
  method->addItem("Exact", 3);
  method->setItemData(0, "Right for nearly all scenes", Qt::ToolTipRole);
  method->setItemData(1, "Edges as fine as the picture's pixels, not softened", Qt::ToolTipRole);
  method->setItemData(2, "More detail near the camera: for landscapes", Qt::ToolTipRole);
  method->setItemData(3, "A ray for each pixel: no errors at edges, slower", Qt::ToolTipRole);
  auto* size = new QComboBox(this->Rest);
  size->setObjectName("size");
  for (int texels = 256; texels <= 16384; texels *= 2)
  {
    const int mebibytes = texels * texels / 262144; // four bytes a texel
    size->addItem(
      mebibytes ? QString("%1 (%2 MiB)").arg(texels).arg(mebibytes) : QString::number(texels),
      texels);
  }
  size->setToolTip("Finer maps have sharper edges: twice the size, half the error, four times the "
                   "graphics memory of each light");
  auto* softness = new relievoQt::Number(0.0, 16.0, 1.0, 0, this->Rest);
  softness->setObjectName("softness");
  softness->setToolTip("How wide edges are, in texels of the map");
  auto* strength = new relievoQt::Number(0.0, 1.0, 0.01, 2, this->Rest);
  strength->setObjectName("strength");
  strength->setToolTip("The part of a blocked light that is taken away");
  for (QComboBox* choice : { method, size })
  {
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(8);
  }
  relievoQt::AddRow(rows, "Method", method);
  relievoQt::AddRow(rows, "Map size", size);
  relievoQt::AddRow(rows, "Softness", softness);
  relievoQt::AddRow(rows, "Strength", strength);
  this->Bind(method, "RelievoShadowMethod", "Shadow method");
  this->Bind(size, "RelievoShadowMapSize", "Shadow map size");
  this->Bind(softness, "RelievoShadowFilterRadius", "Softness of shadows");
  this->Bind(strength, "RelievoShadowStrength", "Strength of shadows");
  QObject::connect(this->On, &QCheckBox::toggled, this,
    [this](bool on) { pqRelievoViewSettings::SetShadows(this->View, on); });
}

//------------------------------------------------------------------------------
void pqRelievoShadowControls::ShowState()
{
  this->Superclass::ShowState();
  const QSignalBlocker quiet(this->On);
  this->On->setChecked(this->IsOn("RelievoShadows"));
  this->Rest->setVisible(this->On->isChecked());
}
