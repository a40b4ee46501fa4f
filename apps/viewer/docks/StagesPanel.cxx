// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StagesPanel.h"

#include "ParameterEdit.h"

#include "vtkNew.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
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
  group.Box = this->AddGroup(Words(description.Label), Words(description.Name));
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
    this->AddFiles(group);
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
    auto* label = new QLabel(Words(parameter.GetLabel()), group.Box);
    label->setToolTip(edit->toolTip());
    label->setBuddy(edit);
    rows->addRow(label, edit);
    group.Edits[name] = edit;
    QObject::connect(
      edit, &ParameterEdit::edited, this, [this, stage = group.Stage, name](const QString& words) {
        this->Edited->Change(
          [&](Settings& settings) { settings.SetParameter(stage, name, words.toStdString()); });
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
void StagesPanel::AddFiles(Group& group)
{
  group.Files = new QListWidget(group.Box);
  group.Files->setObjectName("files");
  group.Files->setMaximumHeight(60);
  auto* add = new QPushButton("Add file...", group.Box);
  auto* remove = new QPushButton("Remove", group.Box);
  auto* buttons = new QHBoxLayout();
  buttons->addWidget(add);
  buttons->addWidget(remove);
  GetRows(group.Box)->addRow(group.Files);
  GetRows(group.Box)->addRow(buttons);
  QObject::connect(
    add, &QPushButton::clicked, this, [this, stage = group.Stage] { this->AskFile(stage); });
  QObject::connect(remove, &QPushButton::clicked, this, [this, &group] {
    const int row = group.Files->currentRow();
    this->Edited->Change([&](Settings& settings) {
      const std::string option = GetOption(group.Stage);
      std::vector<std::string> words = settings.GetAll(option);
      if (row >= 0 && row < static_cast<int>(words.size()))
      {
        words.erase(words.begin() + row);
        settings.SetAll(option, words);
      }
    });
  });
}

//------------------------------------------------------------------------------
void StagesPanel::AskFile(const std::string& stage)
{
  const QString file = QFileDialog::getOpenFileName(this, "Points for " + Words(stage));
  if (!file.isEmpty())
  {
    this->Edited->Change([&](Settings& settings) {
      std::vector<std::string> words = settings.GetAll(GetOption(stage));
      words.push_back(file.toStdString());
      settings.SetAll(GetOption(stage), words);
    });
  }
  this->ShowSettings();
}

//------------------------------------------------------------------------------
bool StagesPanel::IsOn(const Group& group) const
{
  const Settings& settings = this->Edited->Get();
  return group.Files           ? settings.Has(GetOption(group.Stage))
    : group.Stage == "shadows" ? settings.GetParameter("shadows", "visible") == "on"
                               : settings.IsStageAsked(group.Stage);
}

//------------------------------------------------------------------------------
void StagesPanel::Switch(Group& group, bool on)
{
  if (group.Files && on && group.Kept.empty())
  {
    this->AskFile(group.Stage);
    return;
  }
  this->Edited->Change([&](Settings& settings) {
    if (group.Files)
    {
      const std::string option = GetOption(group.Stage);
      const std::vector<std::string> kept = group.Kept;
      group.Kept = on ? std::vector<std::string>() : settings.GetAll(option);
      settings.SetAll(option, on ? kept : std::vector<std::string>());
    }
    else if (group.Stage == "shadows")
    {
      settings.SetParameter("shadows", "visible", on ? "on" : "off");
    }
    else
    {
      settings.AskStage(group.Stage, on);
    }
  });
}

//------------------------------------------------------------------------------
void StagesPanel::ShowSettings()
{
  const Settings& settings = this->Edited->Get();
  for (auto& [stage, group] : this->Groups)
  {
    const QSignalBlocker quiet(group.Box);
    if (group.Box->isCheckable())
    {
      group.Box->setChecked(this->IsOn(group));
    }
    for (const auto& [name, edit] : group.Edits)
    {
      edit->SetValue(Words(settings.GetParameter(stage, name)));
    }
    if (group.Files)
    {
      const std::vector<std::string> words = settings.GetAll(GetOption(stage));
      group.Files->clear();
      for (const std::string& word : words)
      {
        group.Files->addItem(Words(word));
      }
      if (!words.empty())
      {
        group.Kept.clear();
      }
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
    group.Reason->setVisible(idle);
    group.Reason->setText(idle ? "Changes nothing: " + Words(stage->GetReason()) : QString());
  }
}
}
