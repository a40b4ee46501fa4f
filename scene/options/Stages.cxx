// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages.h"

#include "Arguments.h"
#include "Errors.h"
#include "Values.h"

#include "vtkNew.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"

namespace scene
{
namespace
{
// TrySetParameter for the stage's switch.
std::string TrySwitch(vtkRelievoStage* stage, const std::string& words)
{
  const bool enabled = stage->GetEnabled();
  vtkRelievoParameterList list;
  list.AddFlag(
    "enabled", enabled, [stage](bool on) { stage->SetEnabled(on); }, "");
  const std::string error = list.TrySet("enabled", words);
  return error.empty() ? error : stage->GetStageName() + ":enabled: " + error;
}
}

//------------------------------------------------------------------------------
StageChoice& AddStage(
  std::vector<StageChoice>& stages, const std::string& name, const std::string& option)
{
  StageChoice choice;
  choice.Name = name;
  choice.Option = option;
  stages.push_back(choice);
  return stages.back();
}

//------------------------------------------------------------------------------
StageChoice ParseStage(const std::string& word)
{
  const char* const expected = "NAME or NAME:PARAMETER=VALUE,..., such as those of relievo stages";
  StageChoice stage;
  const std::size_t colon = word.find(':');
  stage.Name = word.substr(0, colon);
  if (stage.Name.empty())
  {
    RefuseValue("--stage", word, expected);
  }
  vtkRelievoStage* known = GetNewFrame()->GetStage(stage.Name);
  const bool serves = known && known->GetDescription().ServesWhenOff;
  if (colon == std::string::npos)
  {
    stage.Parameters = serves ? NamedWords{ { "enabled", "on" } } : NamedWords{};
    return stage;
  }
  for (const std::string& piece : Split(word.substr(colon + 1), ','))
  {
    const std::size_t equals = piece.find('=');
    if (equals != std::string::npos && equals > 0)
    {
      const std::string name = piece.substr(0, equals);
      stage.Parameters.emplace_back(
        serves && name == "visible" ? "enabled" : name, piece.substr(equals + 1));
    }
    else if (equals == std::string::npos && !stage.Parameters.empty())
    {
      stage.Parameters.back().second += "," + piece;
    }
    else
    {
      RefuseValue("--stage", word, expected);
    }
  }
  return stage;
}

//------------------------------------------------------------------------------
const std::string* FindStageChoice(const std::vector<StageChoice>& stages, const std::string& name,
  const std::string& parameter, const std::string& option)
{
  const std::string* found = nullptr;
  for (const StageChoice& choice : stages)
  {
    for (const auto& given : choice.Parameters)
    {
      const bool is = choice.Name == name && given.first == parameter;
      found = is && (option.empty() || choice.Option == option) ? &given.second : found;
    }
  }
  return found;
}

//------------------------------------------------------------------------------
vtkRelievoPass* GetNewFrame()
{
  static const vtkNew<vtkRelievoPass> frame;
  return frame;
}

//------------------------------------------------------------------------------
void CheckStages(const std::vector<StageChoice>& stages)
{
  if (!stages.empty())
  {
    vtkNew<vtkRelievoPass> pass;
    SetStages(pass, stages);
  }
}

//------------------------------------------------------------------------------
void SetStages(vtkRelievoPass* pass, const std::vector<StageChoice>& stages)
{
  for (const StageChoice& choice : stages)
  {
    vtkRelievoStage* stage = pass->GetStage(choice.Name);
    if (!stage)
    {
      std::vector<std::string> names;
      for (int i = 0; i < pass->GetNumberOfStages(); ++i)
      {
        names.push_back(pass->GetStage(i)->GetStageName());
      }
      RefuseValue("--stage", choice.Name, "one of " + Join(names, ", "));
    }
    stage->SetEnabled(stage->GetEnabled() || !stage->GetDescription().ServesWhenOff);
    for (const auto& [name, value] : choice.Parameters)
    {
      const std::string error =
        name == "enabled" ? TrySwitch(stage, value) : stage->TrySetParameter(name, value);
      if (!error.empty())
      {
        throw UsageError(choice.Option + " " + error);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::string DescribeStages()
{
  vtkNew<vtkRelievoPass> pass;
  std::string text;
  for (int i = 0; i < pass->GetNumberOfStages(); ++i)
  {
    const vtkRelievoStageDescription& stage = pass->GetStage(i)->GetDescription();
    text += stage.Name + (stage.OnByDefault ? " (always there)" : "") + "\n  " + stage.Help + "\n";
    for (const vtkRelievoParameter& parameter : stage.Parameters)
    {
      const std::string value = parameter.Format();
      text += "    " + parameter.Name + "=" + (value.empty() ? "TEXT" : value) + "\n      " +
        parameter.Help + " Takes " + parameter.GetExpected() + ".\n";
    }
  }
  return text;
}
}
