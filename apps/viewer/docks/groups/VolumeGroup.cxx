// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeGroup.h"

#include "Number.h"
#include "Numbers.h"
#include "OpacityCurve.h"
#include "OptionEdits.h"
#include "Options.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace viewer
{
namespace
{
const char* const CurveOption = "--opacity-curve";
const char* const StepOption = "--volume-step";
const char* const ShadowOption = "--volume-shadows";
}

//------------------------------------------------------------------------------
VolumeGroup::VolumeGroup(Document* document, Reader read, QWidget* parent)
  : FoldGroup("Volumes", "volumeLook", parent)
  , Edited(document)
  , Read(std::move(read))
  , Curve(new OpacityCurve(this))
  , Found(new QCheckBox("Find the opacity", this))
  , Step(MakeNumber(StepOption, 0.1, 2, this))
{
  this->Found->setObjectName("found");
  this->Found->setToolTip("Transparent below the threshold that separates the values best");
  this->Step->setObjectName("step");
  this->Step->SetUnit("spacings");
  this->Step->setToolTip("Step of rays, in distances of the image's points: smaller steps are "
                         "slower and show fewer rings");
  this->GetRows()->addRow(new QLabel("Opacity curve", this));
  this->GetRows()->addRow(this->Curve);
  this->GetRows()->addRow(this->Found);
  this->GetRows()->addRow("Step", this->Step);
  this->Shadows = AddChoice(document, this->GetRows(), ShadowOption, "both",
    "Whether volumes cast shadows and receive them, also their own");
  QObject::connect(
    this->Curve, &OpacityCurve::edited, this, [this](const OpacityCurve::Points& points) {
      this->Edited->Change([&points](scene::Settings& settings) {
        settings.Set(CurveOption, look::WriteOpacityCurve(points));
      });
    });
  QObject::connect(this->Found, &QCheckBox::toggled, this, [this](bool on) {
    this->Edited->Change([this, on](scene::Settings& settings) {
      SetOption(settings, CurveOption, on ? "" : look::WriteOpacityCurve(this->Curve->GetPoints()));
    });
  });
  QObject::connect(this->Step, &relievoQt::Number::edited, this, [this](double step) {
    this->Edited->Change([step](scene::Settings& settings) {
      SetOption(settings, StepOption, step == 0.5 ? "" : words::WriteNumber(step));
    });
  });
  QObject::connect(document, &Document::changed, this, &VolumeGroup::ShowSettings);
  // Updates when the picture shows the requested data.
  QObject::connect(
    document, &Document::asked, this, &VolumeGroup::ShowVolume, Qt::QueuedConnection);
  QObject::connect(document, &Document::shown, this, &VolumeGroup::ShowVolume);
  this->ShowSettings();
  this->ShowVolume();
}

//------------------------------------------------------------------------------
void VolumeGroup::ShowVolume()
{
  const std::optional<VolumeFacts> facts = this->Read();
  if (facts)
  {
    this->Curve->ShowValues(facts->Range, facts->Histogram);
    if (!this->Edited->Get().Has(CurveOption))
    {
      this->Curve->ShowCurve(facts->Opacity);
    }
  }
  this->setVisible(facts.has_value());
}

//------------------------------------------------------------------------------
void VolumeGroup::ShowSettings()
{
  const QSignalBlocker quiet(this->Found);
  const look::LookChoice look = this->Edited->Get().Parse().Look;
  this->Found->setChecked(look.OpacityCurve.empty());
  if (!look.OpacityCurve.empty())
  {
    this->Curve->ShowCurve(look.OpacityCurve);
  }
  this->Step->SetValue(look.VolumeStep);
  ShowChoice(this->Shadows, this->Edited->Get(), ShadowOption);
}
}
