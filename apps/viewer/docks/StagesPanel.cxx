// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StagesPanel.h"

#include "Labels.h"
#include "ParameterEdit.h"
#include "PointsEdit.h"

#include "vtkNew.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QSignalBlocker>

namespace viewer
{
namespace
{
QString Words(const std::string& text)
{
  return QString::fromStdString(text);
}

// Stages that work on data take it by an option of their own name.
std::string GetOption(const std::string& stage)
{
  return "--" + stage;
}
}

//------------------------------------------------------------------------------
StagesPanel::StagesPanel(Document* document, QWidget* parent)
  : Panel(document, parent)
{
  vtkNew<vtkRelievoPass> frame;
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    this->AddStage(frame->GetStage(i));
  }
  QObject::connect(document, &Document::changed, this, [this] { this->ShowSettings(); });
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void StagesPanel::AddStage(vtkRelievoStage* stage)
{
  const vtkRelievoStageDescription& description = stage->GetDescription();
  const bool nothingToSet =
    description.OnByDefault && description.Parameters.empty() && !description.TakesData;
  if (nothingToSet || description.Name == "display") // which is chosen among the layers
  {
    return;
  }
  Group& group = this->Groups[description.Name];
  group.Stage = description.Name;
  group.Box = this->AddGroup(WriteLabel(Words(description.Label)), Words(description.Name),
    !description.Parameters.empty() || description.TakesData);
  group.Box->setToolTip("<p>" + Words(description.Help) + "</p>");
  QFormLayout* rows = GetRows(group.Box);
  group.Reason = new QLabel(group.Box);
  group.Reason->setObjectName("reason");
  group.Reason->setWordWrap(true);
  group.Reason->hide();
  rows->addRow(group.Reason);
  const bool isSwitch =
    !description.Parameters.empty() && description.Parameters[0].Name == "visible";
  const bool switched = !description.OnByDefault || description.TakesData || isSwitch;
  if (description.TakesData && !isSwitch)
  {
    group.Points = new PointsEdit(this->Edited, group.Stage, group.Box);
    rows->addRow(group.Points);
  }
  for (const vtkRelievoParameter& parameter : description.Parameters)
  {
    const std::string name = parameter.Name;
    if (isSwitch && name == "visible")
    {
      continue;
    }
    auto* edit = new ParameterEdit(parameter, group.Box);
    edit->setObjectName(Words(name));
    AddParameterRow(rows, parameter, edit);
    group.Edits[name] = edit;
    QObject::connect(
      edit, &ParameterEdit::edited, this, [this, stage = group.Stage, name](const QString& words) {
        this->Edited->Change([&](scene::Settings& settings) {
          settings.SetParameter(stage, name, words.toStdString());
        });
      });
  }
  if (switched)
  {
    group.Box->setCheckable(true);
    QObject::connect(
      group.Box, &QGroupBox::toggled, this, [this, &group](bool on) { this->Switch(group, on); });
  }
}

//------------------------------------------------------------------------------
bool StagesPanel::IsOn(const Group& group) const
{
  const scene::Settings& settings = this->Edited->Get();
  return group.Points ? settings.Has(GetOption(group.Stage)) : settings.IsStageOn(group.Stage);
}

//------------------------------------------------------------------------------
// What is switched off is kept: on again is as it was.
void StagesPanel::Switch(Group& group, bool on)
{
  if (group.Stage == "shadows")
  {
    this->Edited->Change([on](scene::Settings& settings) { settings.SwitchStage("shadows", on); });
    return;
  }
  if (group.Points && on && !group.Kept)
  {
    group.Points->Ask();
    this->ShowSettings(); // off again, if there is none
    return;
  }
  const scene::Settings before = this->Edited->Get();
  const scene::Settings from = on ? group.Kept.value_or(before) : scene::Settings();
  this->Edited->Change([&](scene::Settings& settings) {
    group.Points ? settings.AskStage(group.Stage, false) : settings.SwitchStage(group.Stage, on);
    for (const auto& edit : group.Edits)
    {
      if (from.HasParameter(group.Stage, edit.first))
      {
        settings.SetParameter(group.Stage, edit.first, from.GetParameter(group.Stage, edit.first));
      }
    }
    if (group.Points)
    {
      settings.SetAll(GetOption(group.Stage), from.GetAll(GetOption(group.Stage)));
    }
  });
  group.Kept = on ? std::nullopt : std::optional<scene::Settings>(before);
  this->ShowSettings();
}

//------------------------------------------------------------------------------
void StagesPanel::ShowSettings()
{
  const scene::Settings& settings = this->Edited->Get();
  for (auto& [stage, group] : this->Groups)
  {
    const QSignalBlocker quiet(group.Box);
    const bool on = this->IsOn(group);
    if (group.Box->isCheckable())
    {
      group.Box->setChecked(on);
    }
    if (on)
    {
      group.Kept.reset();
    }
    for (const auto& [name, edit] : group.Edits)
    {
      edit->SetValue(Words((group.Kept ? *group.Kept : settings).GetParameter(stage, name)));
    }
  }
}

//------------------------------------------------------------------------------
void StagesPanel::ShowReasons(vtkRelievoPass* frame)
{
  for (auto& [name, group] : this->Groups)
  {
    vtkRelievoStage* stage = frame ? frame->GetStage(name) : nullptr;
    const bool idle = stage && group.Box->isCheckable() && group.Box->isChecked() &&
      stage->GetReasonCode() != "ran";
    group.Reason->setText(idle ? "Changes nothing: " +
          WriteReason(Words(stage->GetReasonCode()), Words(stage->GetReason()))
                               : QString());
    group.Reason->setVisible(idle);
  }
}
}
