// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Points.h"

#include "DataSets.h"
#include "Errors.h"
#include "Messages.h"
#include "Options.h"
#include "Readers.h"

#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoPointStage.h"

#include <algorithm>
#include <set>

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

vtkSmartPointer<vtkRelievoPointValues> MakePoints(const std::string& stage)
{
  return vtkSmartPointer<vtkRelievoPointValues>::Take(FindStage(stage).Points->NewInstance());
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

//------------------------------------------------------------------------------
std::set<std::string> GetArrays(vtkDataObject* data)
{
  std::set<std::string> names;
  ForEachDataSet(data, [&names](vtkDataSet* part) {
    for (int i = 0; i < part->GetPointData()->GetNumberOfArrays(); ++i)
    {
      const char* own = part->GetPointData()->GetArrayName(i);
      names.insert(own ? own : "");
    }
  });
  return names;
}

// Throws UsageError if the file lacks an array that a value refers to.
void CheckArrays(const PointsChoice& choice, vtkRelievoPointValues* points)
{
  const std::set<std::string> names = GetArrays(points->GetInputDataObject(0, 0));
  for (const auto& given : choice.Values)
  {
    const std::string array = points->GetArray(given.first);
    if (!array.empty() && names.count(array) == 0)
    {
      RefuseValue("--" + choice.Stage + " " + choice.File + "," + given.first, array,
        "a number, or a point array of the file" +
          (names.empty()
              ? ", which has none"
              : ": " + Join(std::vector<std::string>(names.begin(), names.end()), ", ")));
    }
  }
}

// Throws WorkError if no point has an effect; notes points that have none.
void CheckPoints(const std::string& path, vtkRelievoPointValues* points)
{
  const std::string things = points->GetThings(), needs = points->GetNeeds();
  const int count = points->GetNumberOfPoints();
  const int leftOut = points->GetNumberLeftOut();
  Messages::Check(path, count == 0,
    leftOut == 0 ? "holds no points, expected " + things
                 : "holds no points that are " + things + ": " + needs);
  if (leftOut > 0)
  {
    Messages::Note(path + ": left out " + std::to_string(leftOut) + " of " +
      std::to_string(count + leftOut) + " points that are no " + things + ": " + needs);
  }
}

// Sizes given by neither file nor words: their defaults depend on the scene.
void NoteDefaults(const PointsChoice& choice, vtkRelievoPointValues* points)
{
  const std::set<std::string> names = GetArrays(points->GetInputDataObject(0, 0));
  std::string defaults;
  for (const vtkRelievoParameter& parameter : points->GetDescription().Parameters)
  {
    const bool given = std::any_of(choice.Values.begin(), choice.Values.end(),
      [&parameter](const auto& each) { return each.first == parameter.Name; });
    if (!given && parameter.PerPoint && names.count(parameter.Name) == 0 &&
      parameter.Unit.find("world unit") != std::string::npos)
    {
      defaults += (defaults.empty() ? "" : " and ") + parameter.Name + " " + parameter.Default;
    }
  }
  if (!defaults.empty())
  {
    Messages::Note(choice.File + ": " + points->GetThings() + " with " + defaults +
      ", for the file has no such array");
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
void TakePoints(RenderOptions& options, const std::string& name, const std::string& word)
{
  const PointStage& stage = FindStage(name);
  const std::string option = "--" + name;
  PointsChoice choice;
  choice.Stage = name;
  NamedWords values;
  choice.File = ParseFileAndValues(option, word, values);
  const vtkSmartPointer<vtkRelievoPointValues> points = MakePoints(name);
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
    const std::string wrong = points->TrySetParameter(parameter, value);
    if (!wrong.empty())
    {
      throw UsageError(option + " " + parameter + ": " + wrong);
    }
    choice.Values.emplace_back(parameter, value);
  }
  CheckTogether(option, points, choice.Values);
  options.Points.push_back(choice);
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
void CheckPointFile(const PointsChoice& choice)
{
  CheckExtension(choice.File);
  if (IsModel(choice.File))
  {
    throw UsageError("--" + choice.Stage + ": " + choice.File +
      " is a model or a scene; expected a file of points");
  }
  CheckReadable(choice.File);
}

//------------------------------------------------------------------------------
FramePoints ReadFramePoints(const RenderOptions& options, Progress& progress)
{
  FramePoints all;
  for (const PointsChoice& choice : options.Points)
  {
    const vtkSmartPointer<vtkRelievoPointValues> points = MakePoints(choice.Stage);
    points->SetInputData(ReadPoints(choice.File, options.AllowedFolders, progress));
    if (points->GetDescription().Find("up")) // unless it is given
    {
      points->SetParameter("up",
        std::string(options.UpAxis == 0 ? "1" : "0") + "," + (options.UpAxis == 1 ? "1" : "0") +
          "," + (options.UpAxis == 2 ? "1" : "0"));
    }
    for (const auto& [parameter, value] : choice.Values)
    {
      points->SetParameter(parameter, value);
    }
    CheckArrays(choice, points);
    CheckPoints(choice.File, points);
    NoteDefaults(choice, points);
    all.push_back({ choice.Stage, points });
  }
  return all;
}

//------------------------------------------------------------------------------
void AddFramePoints(vtkRelievoPass* pass, const FramePoints& points)
{
  for (const FramePointSet& set : points)
  {
    vtkRelievoPointStage::SafeDownCast(pass->GetStage(set.Stage))->AddPoints(set.Points);
  }
}
}
