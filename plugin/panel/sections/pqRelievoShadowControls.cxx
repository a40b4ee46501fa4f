// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pqRelievoShadowControls.h"

#include "Number.h"
#include "Rows.h"
#include "pqRelievoScene.h"
#include "vtkPVRelievoView.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace
{
constexpr int SoftSamples = 16; // initial number when switched on
}

//------------------------------------------------------------------------------
pqRelievoShadowControls::pqRelievoShadowControls(QWidget* parent)
  : Superclass(parent)
  , On(new QCheckBox("Shadows", this))
  , Rest(new QWidget(this))
  , Soft(new QCheckBox("Soft shadows", Rest))
  , Softness(new QWidget(Rest))
  , Hint(new QLabel(Rest))
{
  this->On->setObjectName("on");
  MakeHead(this->On);
  this->On->setToolTip("Lights that are blocked leave shadows");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->On);
  layout->addWidget(this->Rest);
  this->Rest->setObjectName("rest");
  auto* parts = new QVBoxLayout(this->Rest);
  Indent(this->Rest);
  this->Hint->setObjectName("hint");
  this->Hint->setWordWrap(true);
  this->AddSoft(this->Rest);
  auto* strength = new relievoQt::Number(0.0, 1.0, 0.01, 2, this->Rest);
  strength->setObjectName("strength");
  strength->setToolTip("The part of a blocked light that is taken away");
  auto* row = new QWidget(this->Rest);
  parts->addWidget(row);
  relievoQt::AddRow(relievoQt::MakeRows(row), "Strength", strength);
  this->Bind(strength, "RelievoShadowStrength", "Strength of shadows");
  this->AddMethods(this->Rest);
  parts->addWidget(this->Hint); // its visibility depends on the picture
  QObject::connect(this->On, &QCheckBox::toggled, this,
    [this](bool on) { pqRelievoViewSettings::SetShadows(this->View, on); });
  QObject::connect(this->Hint, &QLabel::linkActivated, this, [this](const QString& link) {
    link == "sun" ? pqRelievoViewSettings::SetSun(this->View, true)
                  : pqRelievoScene::MakeGround(this->View);
  });
}

//------------------------------------------------------------------------------
void pqRelievoShadowControls::AddSoft(QWidget* parent)
{
  this->Soft->setObjectName("soft");
  this->Soft->setToolTip("Edges as wide as lights of a size make them. A picture that rests is "
                         "refined sample by sample");
  this->Softness->setObjectName("softness");
  parent->layout()->addWidget(this->Soft);
  parent->layout()->addWidget(this->Softness);
  QFormLayout* rows = relievoQt::MakeRows(this->Softness);
  Indent(this->Softness);
  auto* angle = new relievoQt::Number(0.0, 10.0, 0.1, 2, this->Softness);
  angle->setObjectName("angle");
  angle->SetUnit("degrees");
  angle->SetTypedRange(0.0, 90.0);
  angle->setToolTip("How wide the sun is in the sky: the real one half a degree. The wider, the "
                    "softer the edges");
  auto* samples = new relievoQt::Number(2.0, 128.0, 1.0, 0, this->Softness);
  samples->setObjectName("samples");
  samples->SetTypedRange(2.0, 4096.0);
  samples->SetUnit("pictures");
  samples->setToolTip("More are smoother, and take as many pictures");
  relievoQt::AddRow(rows, "Softness", angle);
  relievoQt::AddRow(rows, "Samples", samples);
  this->Bind(angle, "RelievoShadowSunAngle", "Softness of shadows");
  this->Bind(samples, "RelievoShadowSoftSamples", "Samples of soft shadows");
  QObject::connect(this->Soft, &QCheckBox::toggled, this, [this](bool on) {
    this->Apply(on ? "Soft shadows on" : "Soft shadows off",
      { { "RelievoShadowSoftSamples", on ? SoftSamples : 0 } });
  });
}

//------------------------------------------------------------------------------
void pqRelievoShadowControls::AddMethods(QWidget* parent)
{
  auto* method = new QComboBox(parent);
  method->setObjectName("method");
  method->addItem("Map", 0);
  method->addItem("Forward", 1);
  method->addItem("Warped", 2);
  method->addItem("Exact", 3);
  method->setItemData(0, "Right for nearly all scenes", Qt::ToolTipRole);
  method->setItemData(1, "Edges as fine as the picture's pixels, not softened", Qt::ToolTipRole);
  method->setItemData(2, "More detail near the camera: for landscapes", Qt::ToolTipRole);
  method->setItemData(3, "A ray for each pixel: no errors at edges, slower", Qt::ToolTipRole);
  auto* row = new QWidget(parent);
  row->setObjectName("main");
  parent->layout()->addWidget(row);
  relievoQt::AddRow(relievoQt::MakeRows(row), "Method", method);
  auto* methods = new QWidget(parent);
  methods->setObjectName("methods");
  parent->layout()->addWidget(MakeFold("Advanced", methods, parent));
  parent->layout()->addWidget(methods);
  QFormLayout* rows = relievoQt::MakeRows(methods);
  Indent(methods);
  auto* size = new QComboBox(methods);
  size->setObjectName("size");
  for (int texels = 256; texels <= 16384; texels *= 2)
  {
    const int mebibytes = texels * texels / 262144; // four bytes per texel
    size->addItem(mebibytes ? QString("%1 texels (%2 MiB)").arg(texels).arg(mebibytes)
                            : QString("%1 texels").arg(texels),
      texels);
  }
  size->setToolTip("Finer maps have sharper edges: twice the size, half the error, four times the "
                   "graphics memory of each light");
  auto* filter = new relievoQt::Number(0.0, 16.0, 1.0, 0, methods);
  filter->setObjectName("filter");
  filter->SetUnit("texels");
  filter->setToolTip("How far edges are smoothed, in texels of the map");
  for (QComboBox* choice : { method, size })
  {
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(8);
  }
  relievoQt::AddRow(rows, "Map size", size);
  relievoQt::AddRow(rows, "Filter radius", filter);
  this->Bind(method, "RelievoShadowMethod", "Shadow method");
  this->Bind(size, "RelievoShadowMapSize", "Shadow map size");
  this->Bind(filter, "RelievoShadowFilterRadius", "Filter radius of shadows");
}

//------------------------------------------------------------------------------
void pqRelievoShadowControls::ShowState()
{
  this->Superclass::ShowState();
  const QSignalBlocker quiet[] = { QSignalBlocker(this->On), QSignalBlocker(this->Soft) };
  this->On->setChecked(this->IsOn("RelievoShadows"));
  this->Rest->setVisible(this->On->isChecked());
  this->Soft->setChecked(this->Get("RelievoShadowSoftSamples").toInt() > 1);
  this->Softness->setVisible(this->Soft->isChecked());
  this->ShowScene();
}

//------------------------------------------------------------------------------
void pqRelievoShadowControls::ShowScene()
{
  const QString hint = this->On->isChecked() ? this->FindHint() : QString();
  this->Hint->setText(hint);
  this->Hint->setVisible(!hint.isEmpty());
}

//------------------------------------------------------------------------------
QString pqRelievoShadowControls::FindHint() const
{
  vtkPVRelievoView* here = pqRelievoViewSettings::FindHere(this->View);
  if (!here || pqRelievoScene::FindSurfaces(this->View).isEmpty())
  {
    return here ? "Only surfaces cast shadows, and none is visible." : "";
  }
  static const QStringList kit = { "shadow_key_light", "shadow_fill_light",
    "shadow_first_back_light", "shadow_second_back_light", "shadow_headlight" };
  const QString all = here->GetShadowLayers();
  const QStringList casting = all.isEmpty() ? QStringList() : all.split(',');
  const bool moving = std::all_of(
    casting.begin(), casting.end(), [](const QString& layer) { return kit.contains(layer); });
  const bool sun = this->IsOn("RelievoSun");
  if (sun && moving && this->IsOn("RelievoSunBy") && here->GetSunAngles()[1] <= 0.0)
  {
    return "It is night: the sun is below the horizon and casts no shadow.";
  }
  if (casting.isEmpty())
  {
    return sun ? "No light casts shadows: the sun's brightness is 0."
               : "No light casts shadows. <a href=\"sun\">Switch the sun on</a>";
  }
  if (moving)
  {
    return "Only the view's own light casts. It comes from behind the camera, and most shadows are "
           "hidden. <a href=\"sun\">Switch the sun on</a>";
  }
  return pqRelievoScene::HasGround(this->View)
    ? ""
    : "Nothing flat is shown that shadows could fall on. <a href=\"ground\">Add a ground plane</a>";
}
