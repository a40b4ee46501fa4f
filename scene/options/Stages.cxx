// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stages.h"

#include "Arguments.h"
#include "Errors.h"
#include "OptionRows.h"
#include "Values.h"

#include "vtkNew.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"

#include <algorithm>
#include <iterator>

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
bool DarkensByRays(const std::vector<StageChoice>& stages)
{
  if (std::none_of(stages.begin(), stages.end(),
        [](const StageChoice& stage) { return stage.Name == "ambient"; }))
  {
    return false;
  }
  vtkNew<vtkRelievoPass> pass;
  SetStages(pass, stages);
  vtkRelievoStage* ambient = pass->GetStage("ambient");
  return ambient->GetEnabled() && ambient->GetParameter("strength") != "0";
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

//------------------------------------------------------------------------------
vtkRelievoOption& AddOfStage(OptionRows& rows, std::vector<StageChoice>& stages,
  const std::string& use, const std::string& stage, const std::string& parameter,
  const std::string& help, const std::function<std::string(const std::string& word)>& read)
{
  vtkRelievoParameter set = *GetNewFrame()->GetStage(stage)->GetDescription().Find(parameter);
  set.Help = help;
  vtkRelievoOption option = vtkRelievoOption::Of(set, use);
  option.Sets = stage + ":" + parameter;
  option.Take = [=, &stages, check = option.Take, name = option.Name](const std::string& word) {
    const std::string words = read ? read(word) : word;
    const std::string error = check(words);
    set.Parse(set.Default); // resets the new frame, which serves only for its description
    if (error.empty())
    {
      AddStage(stages, stage, name)
        .Parameters.emplace_back(parameter, words.empty() ? "on" : words);
    }
    return error;
  };
  rows.Command.Options.push_back(option);
  return rows.Command.Options.back();
}

//------------------------------------------------------------------------------
vtkRelievoOption& AddSwitch(OptionRows& rows, std::vector<StageChoice>& stages,
  const std::string& name, const std::string& form, const std::string& stage,
  const std::string& parameter, const std::string& help)
{
  const vtkRelievoParameter& set =
    *GetNewFrame()->GetStage(stage)->GetDescription().Find(parameter);
  std::vector<std::string> words = set.Choices;
  words.insert(words.begin(), "off");
  vtkRelievoOption& option =
    rows.AddChoice(name, form, words, help, [=, &stages, usual = set.Default](std::size_t place) {
      AddStage(stages, stage, name).Parameters = { { "enabled", place == 0 ? "off" : "on" },
        { parameter, place == 0 ? usual : words[place] } };
    });
  option.Sets = stage + ":" + parameter;
  option.IsSwitch = true;
  return option;
}

namespace
{
//------------------------------------------------------------------------------
void TakeAmbient(std::vector<StageChoice>& stages, const std::string& word)
{
  const std::vector<std::string> pieces = Split(word, ',');
  StageChoice& choice = AddStage(stages, "ambient", "--ambient");
  choice.Parameters = { { "enabled", "on" }, { "strength", pieces[0] } };
  for (auto piece = std::next(pieces.begin()); piece != pieces.end(); ++piece)
  {
    const std::size_t equals = piece->find('=');
    if (equals == 0 || equals == std::string::npos)
    {
      RefuseValue("--ambient", word,
        "a strength from 0 to 1, then ,radius=R ,weighting=W or ,samples=N, such as 1,radius=0.5");
    }
    choice.Parameters.emplace_back(piece->substr(0, equals), piece->substr(equals + 1));
  }
}
}

//------------------------------------------------------------------------------
void AddAmbientOption(OptionRows& rows, std::vector<StageChoice>& stages)
{
  rows
    .Add("--ambient", "STRENGTH[,radius=R][,NAME=VALUE]...",
      "ambient occlusion by rays: opaque surfaces are darker by up to this share, 0 to 1, "
      "where they see less of the sky; R limits the distance of occluders in world units "
      "(0: no limit). Other values are parameters of the stage ambient, such as samples=N, "
      "rays per pixel (64)",
      stages, TakeAmbient)
    .Sets = "ambient";
}

//------------------------------------------------------------------------------
void AddStageOptions(OptionRows& rows, std::vector<StageChoice>& stages)
{
  vtkRelievoOption& deferred =
    rows
      .Add("--deferred", "",
        "shades opaque surfaces once per pixel, after they are drawn: the picture is "
        "the same except for fill lights, and faster if many surfaces overlap",
        [&stages](const std::string&) { AddStage(stages, "deferred", "--deferred"); })
      .NamedIn("Look", "Deferred shading");
  deferred.Sets = "deferred";
  vtkRelievoOption& stage = rows.Add("--stage", "NAME[:PARAMETER=VALUE,...]",
    "runs a stage of the frame with these parameters; may be repeated; `relievo stages` lists them",
    [&stages](const std::string& word) { stages.push_back(ParseStage(word)); });
  stage.Repeats = true;
  stage.Sets = "any";
}
}
