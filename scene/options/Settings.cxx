// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

#include "Arguments.h"
#include "Options.h"
#include "Presets.h"
#include "Values.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoStageDescription.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace scene
{
namespace
{
std::string GetFirstTime(const std::string& times)
{
  ModelChoice model;
  TakeTimes(model, times);
  return WriteNumber(model.Times.front());
}

// The option whose words switch the stage and choose a parameter; nullptr: the stage has none.
const vtkRelievoOption* FindSwitch(const std::string& stage)
{
  const std::vector<vtkRelievoOption>& options = GetRenderCommand().Options;
  const auto found =
    std::find_if(options.begin(), options.end(), [&stage](const vtkRelievoOption& option) {
      return option.IsSwitch && option.GetStage() == stage;
    });
  return found == options.end() ? nullptr : &*found;
}

// The parameter that presets may set, or the first one of the stage; nullptr: none.
const PresetParameter* FindPresetParameter(
  const std::string& stage, const std::string& parameter = {})
{
  const std::vector<PresetParameter>& all = GetPresetParameters();
  const auto found = std::find_if(all.begin(), all.end(), [&](const PresetParameter& each) {
    return each.Stage == stage && (parameter.empty() || each.Parameter == parameter);
  });
  return found == all.end() ? nullptr : &*found;
}

// Whether a stage takes part without being requested.
bool IsThere(const std::string& stage)
{
  const vtkRelievoStageDescription& says = GetNewFrame()->GetStage(stage)->GetDescription();
  return says.OnByDefault || says.ServesWhenOff;
}

std::string GetDefault(const std::string& stage, const std::string& parameter)
{
  vtkRelievoStage* found = GetNewFrame()->GetStage(stage);
  return parameter == "enabled" ? (found->GetDescription().ServesWhenOff ? "off" : "on")
                                : found->GetParameterDefault(parameter);
}
}

//------------------------------------------------------------------------------
Settings Settings::FromWords(const std::vector<std::string>& words)
{
  Settings settings;
  SplitArguments(
    words, GetRenderCommand(),
    [&settings](const vtkRelievoOption& option, const std::string& value) {
      if (option.Name == "--times")
      {
        settings.Set("--time", GetFirstTime(value));
      }
      else if (!option.OfOutputs)
      {
        settings.Values[option.Name].push_back(value);
      }
    },
    [&settings](const std::string& word) { settings.Files.push_back(word); });
  if (!settings.Files.empty() || !settings.Values.empty())
  {
    settings.TakeStages(settings.Parse());
  }
  return settings;
}

//------------------------------------------------------------------------------
void Settings::TakeStages(const RenderOptions& options)
{
  for (const vtkRelievoOption& option : GetRenderCommand().Options)
  {
    if (!option.Implies.empty() && this->Has(option.Name))
    {
      this->Set(option.Implies[0], option.Implies[1]);
    }
    if (!option.Sets.empty() && !option.IsSwitch)
    {
      this->Remove(option.Name); // set as parameters of stages instead
    }
  }
  for (const StageChoice& choice : options.Stages)
  {
    if (choice.Option == "--preset" || IsOfSwitch(choice)) // kept as words
    {
      continue;
    }
    this->AskStage(choice.Name, true);
    for (const auto& [name, value] : choice.Parameters)
    {
      this->SetParameter(choice.Name, name, value);
    }
  }
  for (const PointStage& stage : GetPointStages())
  {
    for (const std::string& parameter : stage.Parameters)
    {
      this->DropValue("--" + stage.Name, parameter);
    }
  }
  for (auto stage = this->Stages.begin(); stage != this->Stages.end();)
  {
    const bool idle = stage->second.empty() && IsThere(stage->first);
    stage = idle ? this->Stages.erase(stage) : std::next(stage);
  }
}

//------------------------------------------------------------------------------
// Files of points are the stage's parameter.
void Settings::DropValue(const std::string& option, const std::string& name)
{
  std::vector<std::string> words = this->GetAll(option);
  for (std::string& word : words)
  {
    std::vector<std::string> parts = SplitEscaped(word, ',');
    const auto dropped = std::remove_if(parts.begin() + 1, parts.end(),
      [&name](const std::string& part) { return part.rfind(name + "=", 0) == 0; });
    parts.erase(dropped, parts.end());
    word = JoinEscaped(parts, ',');
  }
  this->SetAll(option, words);
}

//------------------------------------------------------------------------------
void Settings::ChangePaths(const std::string& folder, PathChange change)
{
  for (std::string& file : this->Files)
  {
    file = file.empty() ? file : change(file, folder);
  }
  const auto changeAll = [&](const std::string& option, const std::string& in) {
    std::vector<std::string> words = this->GetAll(option);
    for (std::string& word : words)
    {
      word = word.empty() ? word : change(word, in);
    }
    this->SetAll(option, words);
  };
  for (const vtkRelievoOption& option : GetRenderCommand().Options)
  {
    if (!option.Files.empty() && !option.OfOutputs)
    {
      // A comma ends the name of a file of points.
      const bool ofPoints = std::any_of(GetPointStages().begin(), GetPointStages().end(),
        [&option](const PointStage& stage) { return "--" + stage.Name == option.Name; });
      changeAll(option.Name, ofPoints ? JoinEscaped({ folder }, ',') : folder);
    }
  }
}

//------------------------------------------------------------------------------
void Settings::MakePathsAbsolute(const std::string& folder)
{
  this->ChangePaths(folder, [](const std::string& path, const std::string& in) {
    return (std::filesystem::path(in) / path).string(); // an absolute path stays unchanged
  });
}

//------------------------------------------------------------------------------
void Settings::MakePathsRelative(const std::string& folder)
{
  this->ChangePaths(folder, [](const std::string& path, const std::string& in) {
    const std::string before = in + "/";
    const bool inside = path.size() > before.size() && path.rfind(before, 0) == 0;
    return inside ? path.substr(before.size()) : path;
  });
}

//------------------------------------------------------------------------------
std::vector<std::string> Settings::GetAllWords(const std::string& option) const
{
  std::vector<std::string> words = this->GetAll(option);
  for (const auto& [name, parameters] :
    option == "--stage" ? this->Stages : std::map<std::string, Parameters>())
  {
    std::string word = name;
    for (const auto& [parameter, value] : parameters)
    {
      word += (word == name ? ":" : ",") + parameter + "=" + value;
    }
    if (!parameters.empty() || !IsThere(name))
    {
      words.push_back(word);
    }
  }
  return words;
}

//------------------------------------------------------------------------------
std::vector<std::string> Settings::GetWords() const
{
  std::vector<std::string> words;
  for (const vtkRelievoOption& option : GetRenderCommand().Options)
  {
    for (const std::string& value : this->GetAllWords(option.Name))
    {
      words.push_back(option.Name);
      if (!option.IsFlag())
      {
        words.push_back(value);
      }
    }
  }
  const bool dashed = std::any_of(this->Files.begin(), this->Files.end(),
    [](const std::string& file) { return !file.empty() && file[0] == '-'; });
  if (dashed)
  {
    words.emplace_back("--");
  }
  words.insert(words.end(), this->Files.begin(), this->Files.end());
  return words;
}

//------------------------------------------------------------------------------
RenderOptions Settings::Parse() const
{
  return ParseOptions(this->GetWords());
}

//------------------------------------------------------------------------------
std::string Settings::Get(const std::string& option) const
{
  const auto found = this->Values.find(option);
  return found == this->Values.end() || found->second.empty() ? "" : found->second.front();
}

//------------------------------------------------------------------------------
std::vector<std::string> Settings::GetAll(const std::string& option) const
{
  const auto found = this->Values.find(option);
  return found == this->Values.end() ? std::vector<std::string>() : found->second;
}

//------------------------------------------------------------------------------
void Settings::Set(const std::string& option, const std::string& value)
{
  this->Values[option] = { value };
}

//------------------------------------------------------------------------------
void Settings::SetAll(const std::string& option, const std::vector<std::string>& values)
{
  values.empty() ? this->Remove(option) : void(this->Values[option] = values);
}

//------------------------------------------------------------------------------
void Settings::AskStage(const std::string& stage, bool asked)
{
  asked ? void(this->Stages[stage]) : void(this->Stages.erase(stage));
}

//------------------------------------------------------------------------------
const std::string* Settings::Find(const std::string& stage, const std::string& parameter) const
{
  const auto found = this->Stages.find(stage);
  if (found != this->Stages.end())
  {
    for (const auto& [name, value] : found->second)
    {
      if (name == parameter)
      {
        return &value;
      }
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
bool Settings::IsSwitchedOn(const vtkRelievoOption& option) const
{
  if (this->Has(option.Name))
  {
    return this->Get(option.Name) != "off";
  }
  const std::vector<StageChoice> stages = this->Parse().Stages;
  const std::string* enabled = FindStageChoice(stages, option.GetStage(), "enabled");
  return enabled && *enabled == "on";
}

//------------------------------------------------------------------------------
std::string Settings::GetParameter(const std::string& stage, const std::string& parameter) const
{
  const vtkRelievoOption* option = FindSwitch(stage);
  if (option && parameter == "enabled")
  {
    return this->IsSwitchedOn(*option) ? "on" : "off";
  }
  if (option && parameter == option->GetParameter() && this->Has(option->Name) &&
    this->IsSwitchedOn(*option))
  {
    return this->Get(option->Name);
  }
  const std::string* value = this->Find(stage, parameter);
  return value ? *value : GetStandard(stage, parameter);
}

//------------------------------------------------------------------------------
// The value without any option: the preset's, if it has one.
std::string Settings::GetStandard(const std::string& stage, const std::string& parameter) const
{
  if (FindPresetParameter(stage, parameter))
  {
    const std::vector<StageChoice> stages = this->Parse().Stages;
    const std::string* value = FindStageChoice(stages, stage, parameter, "--preset");
    return value ? *value : GetDefault(stage, parameter);
  }
  return GetDefault(stage, parameter);
}

//------------------------------------------------------------------------------
bool Settings::IsStageOn(const std::string& stage) const
{
  const bool enabled = this->GetParameter(stage, "enabled") == "on";
  const PresetParameter* preset = FindPresetParameter(stage);
  if (!enabled || FindSwitch(stage))
  {
    return enabled;
  }
  if (!preset)
  {
    return this->IsStageAsked(stage);
  }
  const std::vector<StageChoice> stages = this->Parse().Stages;
  return this->GetParameter(stage, preset->Parameter) != preset->Off &&
    std::any_of(stages.begin(), stages.end(),
      [&stage](const StageChoice& choice) { return choice.Name == stage; });
}

//------------------------------------------------------------------------------
void Settings::SwitchStage(const std::string& stage, bool on)
{
  if (FindSwitch(stage))
  {
    this->SetParameter(stage, "enabled", on ? "on" : "off");
    return;
  }
  this->AskStage(stage, false);
  if (on != this->IsStageOn(stage)) // a preset may set it
  {
    this->SetParameter(stage, "enabled", on ? "on" : "off");
  }
}

//------------------------------------------------------------------------------
void Settings::SetSwitch(const vtkRelievoOption& option, bool on, const std::string& value)
{
  const std::string stage = option.GetStage(), parameter = option.GetParameter();
  const std::string usual = this->GetStandard(stage, parameter);
  this->SetGiven(stage, parameter, usual);
  const bool wasOff = this->Get(option.Name) == "off";
  this->Remove(option.Name);
  if (on)
  {
    // Otherwise the preset's, which are soft.
    if (!wasOff || value != usual || !this->IsSwitchedOn(option))
    {
      this->Set(option.Name, value);
    }
  }
  else if (this->IsSwitchedOn(option)) // by the preset
  {
    this->Set(option.Name, "off");
  }
  else
  {
    this->SetGiven(stage, parameter, value);
  }
}

//------------------------------------------------------------------------------
void Settings::SetParameter(
  const std::string& stage, const std::string& parameter, const std::string& value)
{
  const vtkRelievoOption* option = FindSwitch(stage);
  if (option && parameter == "enabled")
  {
    this->SetSwitch(*option, value == "on", this->GetParameter(stage, option->GetParameter()));
  }
  else if (option && parameter == option->GetParameter())
  {
    this->SetSwitch(*option, this->IsSwitchedOn(*option), value);
  }
  else
  {
    this->SetGiven(stage, parameter, value);
  }
}

//------------------------------------------------------------------------------
void Settings::SetGiven(
  const std::string& stage, const std::string& parameter, const std::string& value)
{
  Parameters& given = this->Stages[stage];
  given.erase(std::remove_if(given.begin(), given.end(),
                [&parameter](const auto& each) { return each.first == parameter; }),
    given.end());
  if (value != this->GetStandard(stage, parameter))
  {
    given.emplace_back(parameter, value);
  }
  else if (given.empty() && IsThere(stage))
  {
    this->Stages.erase(stage);
  }
}

//------------------------------------------------------------------------------
bool Settings::operator==(const Settings& other) const
{
  return this->Files == other.Files && this->Values == other.Values && this->Stages == other.Stages;
}

//------------------------------------------------------------------------------
std::set<std::string> Settings::GetChanges(const Settings& other) const
{
  std::set<std::string> changes;
  if (this->Files != other.Files)
  {
    changes.insert("");
  }
  for (const vtkRelievoOption& option : GetRenderCommand().Options)
  {
    if (this->GetAll(option.Name) != other.GetAll(option.Name))
    {
      changes.insert(option.Name);
    }
  }
  std::map<std::string, Parameters> stages = this->Stages;
  stages.insert(other.Stages.begin(), other.Stages.end());
  for (const auto& stage : stages)
  {
    const std::string& name = stage.first;
    if (this->IsStageAsked(name) != other.IsStageAsked(name))
    {
      changes.insert(name + ":");
    }
    for (const Settings* each : { this, &other })
    {
      const auto found = each->Stages.find(name);
      for (const auto& parameter : found == each->Stages.end() ? Parameters() : found->second)
      {
        const std::string* mine = this->Find(name, parameter.first);
        const std::string* others = other.Find(name, parameter.first);
        if (!mine || !others || *mine != *others)
        {
          changes.insert(name + ":" + parameter.first);
        }
      }
    }
  }
  return changes;
}

//------------------------------------------------------------------------------
void Settings::TakeChanges(const Settings& before, const Settings& after)
{
  for (const std::string& change : before.GetChanges(after))
  {
    const std::size_t colon = change.find(':');
    if (change.empty())
    {
      continue; // each settings object keeps its own files
    }
    if (colon == std::string::npos)
    {
      this->SetAll(change, after.GetAll(change));
      continue;
    }
    const std::string stage = change.substr(0, colon), parameter = change.substr(colon + 1);
    if (parameter.empty() || !after.IsStageAsked(stage))
    {
      this->AskStage(stage, after.IsStageAsked(stage));
    }
    else
    {
      const std::string* value = after.Find(stage, parameter);
      this->SetGiven(stage, parameter, value ? *value : GetStandard(stage, parameter));
    }
  }
}
}
