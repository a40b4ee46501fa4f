// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StageGroup.h"

#include "Labels.h"
#include "OptionNames.h"
#include "ParameterEdit.h"
#include "PointsEdit.h"

#include "vtkNew.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"

#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>
#include <iterator>

namespace viewer
{
namespace
{
struct Placed
{
  const char* Stage;
  StageGroup::Place Place;
};

// In display order.
constexpr Placed Places[] = { { "shadows", StageGroup::LIGHT }, { "lamps", StageGroup::LIGHT },
  { "tone", StageGroup::LOOK }, { "fog", StageGroup::LOOK }, { "markers", StageGroup::LOOK },
  { "antialias", StageGroup::LOOK }, { "deferred", StageGroup::ADVANCED },
  { "light_depth", StageGroup::ADVANCED }, { "volumes", StageGroup::ADVANCED },
  { "empty_space", StageGroup::ADVANCED } };

const Placed* FindPlace(const std::string& stage)
{
  return std::find_if(std::begin(Places), std::end(Places),
    [&stage](const Placed& placed) { return stage == placed.Stage; });
}

QString Words(const std::string& text)
{
  return QString::fromStdString(text);
}

// Stages of points take their data by an option of their name.
std::string GetOption(const std::string& stage)
{
  return "--" + stage;
}

bool CanBeSet(const vtkRelievoStageDescription& description)
{
  const bool nothing =
    description.OnByDefault && description.Parameters.empty() && !description.TakesData;
  return !nothing && description.Name != "display"; // chosen among the layers instead
}
}

//------------------------------------------------------------------------------
std::vector<StageGroup*> StageGroup::MakeAll(Document* document, Place place, QWidget* parent)
{
  vtkNew<vtkRelievoPass> frame;
  std::vector<const vtkRelievoStageDescription*> found;
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    const vtkRelievoStageDescription& description = frame->GetStage(i)->GetDescription();
    const Placed* placed = FindPlace(description.Name);
    if (CanBeSet(description) && (placed == std::end(Places) ? LOOK : placed->Place) == place)
    {
      found.push_back(&description);
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [](const auto* a, const auto* b) { return FindPlace(a->Name) < FindPlace(b->Name); });
  std::vector<StageGroup*> groups;
  for (const vtkRelievoStageDescription* description : found)
  {
    groups.push_back(new StageGroup(document, *description, parent));
  }
  return groups;
}

//------------------------------------------------------------------------------
StageGroup::StageGroup(
  Document* document, const vtkRelievoStageDescription& description, QWidget* parent)
  : FoldGroup(WriteLabel(Words(description.Label)), Words(description.Name), parent)
  , Edited(document)
  , Stage(description.Name)
  , Parameters(description)
  , Reason(new QLabel(this))
{
  this->setToolTip("<p>" + Words(description.Help) + "</p>");
  this->Reason->setObjectName("reason");
  this->Reason->setWordWrap(true);
  this->Reason->hide();
  if (description.TakesData)
  {
    this->Points = new PointsEdit(this->Edited, this->Stage, this);
    this->GetRows()->addRow(this->Points);
  }
  for (const vtkRelievoParameter& parameter : this->Parameters.Parameters)
  {
    this->AddParameter(parameter);
  }
  this->AddBelow(this->Reason); // below the rows, so that a changed text does not move them
  if (!description.OnByDefault || description.TakesData)
  {
    this->setCheckable(true);
    QObject::connect(this, &QGroupBox::toggled, this, &StageGroup::Switch);
  }
  QObject::connect(document, &Document::changed, this, &StageGroup::ShowSettings);
  this->ShowSettings();
  this->Arrange();
}

//------------------------------------------------------------------------------
void StageGroup::AddParameter(const vtkRelievoParameter& parameter)
{
  auto* edit = new ParameterEdit(parameter, this);
  edit->setObjectName(Words(parameter.Name));
  AddParameterRow(parameter.Advanced ? this->GetAdvanced() : this->GetRows(), parameter, edit);
  this->Edits[parameter.Name] = edit;
  QObject::connect(
    edit, &ParameterEdit::edited, this, [this, name = parameter.Name](const QString& words) {
      this->Edited->Change([&](scene::Settings& settings) {
        settings.SetParameter(this->Stage, name, words.toStdString());
      });
    });
}

//------------------------------------------------------------------------------
bool StageGroup::IsOn() const
{
  const scene::Settings& settings = this->Edited->Get();
  return this->Points ? settings.Has(GetOption(this->Stage)) : settings.IsStageOn(this->Stage);
}

//------------------------------------------------------------------------------
// Stores the settings of a switched-off stage, to restore them.
void StageGroup::Switch(bool on)
{
  if (this->Stage == "shadows")
  {
    this->Edited->SwitchShadows(on);
    return;
  }
  if (this->Points && !this->Saved && !this->IsOn())
  {
    this->Waiting = on;
    this->ShowSettings();
    return;
  }
  const scene::Settings before = this->Edited->Get();
  const scene::Settings from = on ? this->Saved.value_or(before) : scene::Settings();
  this->Edited->Change([&](scene::Settings& settings) {
    this->Points ? settings.AskStage(this->Stage, false) : settings.SwitchStage(this->Stage, on);
    for (const auto& edit : this->Edits)
    {
      if (from.HasParameter(this->Stage, edit.first))
      {
        settings.SetParameter(this->Stage, edit.first, from.GetParameter(this->Stage, edit.first));
      }
    }
    if (this->Points)
    {
      settings.SetAll(GetOption(this->Stage), from.GetAll(GetOption(this->Stage)));
    }
  });
  this->Saved = on ? std::nullopt : std::optional<scene::Settings>(before);
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void StageGroup::ShowSettings()
{
  const QSignalBlocker quiet(this);
  const bool on = this->IsOn();
  if (this->isCheckable())
  {
    this->Waiting = this->Waiting && !on;
    this->setChecked(on || this->Waiting);
  }
  if (on)
  {
    this->Saved.reset();
  }
  const scene::Settings& settings = this->Saved ? *this->Saved : this->Edited->Get();
  for (const vtkRelievoParameter& parameter : this->Parameters.Parameters)
  {
    const auto edit = this->Edits.find(parameter.Name);
    if (edit != this->Edits.end())
    {
      edit->second->SetValue(Words(settings.GetParameter(this->Stage, parameter.Name)));
      SetIdle(edit->second, this->WhyIdle(parameter, settings));
    }
  }
}

//------------------------------------------------------------------------------
QString StageGroup::WhyIdle(
  const vtkRelievoParameter& parameter, const scene::Settings& settings) const
{
  for (const vtkRelievoParameter::Condition& condition : parameter.GetConditions())
  {
    const std::string value = settings.GetParameter(this->Stage, condition.Name);
    if ((value == condition.Value) == condition.Other)
    {
      return WriteCondition(this->Parameters, condition);
    }
  }
  return QString();
}

//------------------------------------------------------------------------------
void StageGroup::ShowReason(vtkRelievoPass* frame)
{
  vtkRelievoStage* stage = frame ? frame->GetStage(this->Stage) : nullptr;
  const bool idle = stage && this->isCheckable() && this->IsOn() && stage->GetReasonCode() != "ran";
  const QString words = idle ? "Changes nothing: " +
      NameOptions(WriteReason(Words(stage->GetReasonCode()), Words(stage->GetReason())))
                             : QString();
  if (words != this->Reason->text()) // avoids a new layout in every frame
  {
    this->Reason->setText(words);
    this->Reason->setVisible(idle);
    this->Arrange();
  }
}
}
