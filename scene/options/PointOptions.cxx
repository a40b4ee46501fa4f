// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointOptions.h"

#include "Errors.h"
#include "OptionRows.h"
#include "Options.h"
#include "Values.h"

#include "vtkNew.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoPointStage.h"
#include "vtkRelievoStageDescription.h"

#include <algorithm>

namespace scene
{
namespace
{
const char* const Form = "FILE[,NAME=VALUE]...";

std::string DescribePoints(const PointStage& stage)
{
  std::string text = "the points of FILE as " + stage.Points->GetThings() +
    "; may be repeated. Values are numbers for all points, or names of point arrays (the "
    "array with the value's name, else the default)" +
    DescribeValues(stage.Points->GetDescription());
  return stage.Parameters.empty()
    ? text
    : text + "\nand the stage's " + Join(stage.Parameters, ", ") + " (relievo stages)";
}

std::vector<PointStage> FindPointStages()
{
  std::vector<PointStage> found;
  vtkNew<vtkRelievoPass> frame;
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    if (auto* stage = vtkRelievoPointStage::SafeDownCast(frame->GetStage(i)))
    {
      found.push_back({ stage->GetStageName(),
        vtkSmartPointer<vtkRelievoPointValues>::Take(stage->NewPoints()), {}, "" });
      for (int k = 0; k < stage->GetNumberOfParameters(); ++k)
      {
        found.back().Parameters.push_back(stage->GetParameterName(k));
      }
      found.back().Help = DescribePoints(found.back());
    }
  }
  return found;
}

const PointStage& FindStage(const std::string& name)
{
  const std::vector<PointStage>& stages = GetPointStages();
  return *std::find_if(
    stages.begin(), stages.end(), [&name](const PointStage& stage) { return stage.Name == name; });
}

// A stage's parameter applies to all points.
void TakeStageParameter(RenderOptions& options, const std::string& stage, const std::string& name,
  const std::string& value)
{
  const std::string option = "--" + stage + " " + name;
  for (const StageChoice& choice : options.Stages)
  {
    for (const auto& given : choice.Parameters)
    {
      if (choice.Option == option && given.second != value)
      {
        throw UsageError("--" + stage + ": got " + name + "=" + given.second + " and " + name +
          "=" + value + ", expected one " + name + " for all " + stage);
      }
    }
  }
  AddStage(options.Stages, stage, option).Parameters.emplace_back(name, value);
}

// Throws UsageError for parameters without effect beside the others; values of points are exempt,
// because they may be for points of another shape.
void CheckTogether(
  const std::string& option, vtkRelievoPointValues* points, const NamedWords& values)
{
  for (const auto& given : values)
  {
    for (const vtkRelievoParameter::Condition& condition :
      points->GetDescription().Find(given.first)->GetConditions())
    {
      if (!points->IsPerPoint(given.first) &&
        points->GetParameter(condition.Name) != condition.Value)
      {
        throw UsageError(option + " " + given.first + ": got '" + given.second + "', expected " +
          condition.Name + "=" + condition.Value + " with it");
      }
    }
  }
}
}

//------------------------------------------------------------------------------
const std::vector<PointStage>& GetPointStages()
{
  static const std::vector<PointStage> stages = FindPointStages();
  return stages;
}

//------------------------------------------------------------------------------
namespace
{
// Parses FILE[,NAME=VALUE]...: values of points, or parameters of the stage.
void TakePoints(RenderOptions& options, const std::string& name, const std::string& word)
{
  const PointStage& stage = FindStage(name);
  const std::string option = "--" + name;
  PointsChoice choice;
  choice.Stage = name;
  NamedWords values;
  choice.File = ParseFileAndValues(option, word, values);
  const vtkSmartPointer<vtkRelievoPointValues> points = MakePointValues(name);
  for (const auto& [parameter, value] : values)
  {
    const bool ofPoints = points->GetDescription().Find(parameter) != nullptr;
    if (!ofPoints &&
      std::find(stage.Parameters.begin(), stage.Parameters.end(), parameter) !=
        stage.Parameters.end())
    {
      TakeStageParameter(options, name, parameter, value);
      continue;
    }
    if (!ofPoints)
    {
      RefuseValue(option, parameter + "=" + value,
        "one of " + points->GetDescription().GetNames() + (stage.Parameters.empty() ? "" : ", ") +
          Join(stage.Parameters, ", "));
    }
    const std::string error = points->TrySetParameter(parameter, value);
    if (!error.empty())
    {
      throw UsageError(option + " " + parameter + ": " + error);
    }
    choice.Values.emplace_back(parameter, value);
  }
  CheckTogether(option, points, choice.Values);
  options.Points.push_back(choice);
}
}

//------------------------------------------------------------------------------
std::string ParseFileAndValues(
  const std::string& option, const std::string& word, NamedWords& values)
{
  const std::vector<std::string> parts = SplitEscaped(word, ',');
  if (parts.front().empty())
  {
    RefuseValue(option, word, Form);
  }
  values = ParseNamedWords(option, { parts.begin() + 1, parts.end() }, Form);
  return parts.front();
}

//------------------------------------------------------------------------------
std::string WriteFileAndValues(const std::string& file, const NamedWords& values)
{
  const std::string name = JoinEscaped({ file }, ',');
  return values.empty() ? name : name + "," + WriteNamedWords(values);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRelievoPointValues> MakePointValues(const std::string& stage)
{
  return vtkSmartPointer<vtkRelievoPointValues>::Take(FindStage(stage).Points->NewInstance());
}

//------------------------------------------------------------------------------
void AddPointOptions(OptionRows& rows, RenderOptions& all)
{
  for (const PointStage& stage : GetPointStages())
  {
    vtkRelievoOption& points = rows.Add("--" + stage.Name, Form, stage.Help,
      [&all, name = stage.Name](const std::string& word) { TakePoints(all, name, word); });
    points.Repeats = true;
    points.Files = rows.Command.Files;
    const vtkRelievoStageDescription& description =
      GetNewFrame()->GetStage(stage.Name)->GetDescription();
    const bool isLight = description.Slot == vtkRelievoStageDescription::SHADE;
    points.NamedIn(isLight ? "Light" : "Look", description.Label);
  }
}
}
