// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Points.h"

#include "DataSets.h"
#include "Errors.h"
#include "Numbers.h"
#include "Options.h"
#include "PointOptions.h"
#include "ReadContext.h"
#include "Readers.h"

#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkRelievoFogSpheres.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoPointStage.h"

#include <algorithm>
#include <set>

namespace scene
{
namespace
{
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
void CheckPoints(const std::string& path, vtkRelievoPointValues* points, ReadContext& context)
{
  const std::string things = points->GetThings(), needs = points->GetNeeds();
  const int count = points->GetNumberOfPoints();
  const int leftOut = points->GetNumberLeftOut();
  context.Check(path, count == 0,
    leftOut == 0 ? "holds no points, expected " + things
                 : "holds no points that are " + things + ": " + needs);
  if (leftOut > 0)
  {
    context.Note(path + ": left out " + std::to_string(leftOut) + " of " +
      std::to_string(count + leftOut) + " points that are no " + things + ": " + needs);
  }
}

// Fog with neither a density of its own nor a given one: two thirds of the light pass the middle of
// a sphere of the mean radius, whatever the unit of length is.
void FitDensity(
  const PointsChoice& choice, const RenderOptions& options, vtkRelievoPointValues* points)
{
  auto* fog = vtkRelievoFogSpheres::SafeDownCast(points);
  if (!fog || !FindWords(choice.Values, "density").empty() ||
    GetArrays(points->GetInputDataObject(0, 0)).count("density") > 0)
  {
    return;
  }
  const std::vector<double>& rows = fog->GetRows();
  const auto width = static_cast<std::size_t>(fog->GetRowWidth());
  double sum = 0.0;
  for (std::size_t at = vtkRelievoFogSpheres::RADIUS; at < rows.size(); at += width)
  {
    sum += rows[at] * static_cast<double>(width) / static_cast<double>(rows.size());
  }
  if (sum > 0.0)
  {
    const std::string* mode = FindStageChoice(options.Stages, choice.Stage, "mode");
    const double density = mode && *mode == "chord" ? 0.33 : 0.2 / sum; // chord: the share itself
    fog->SetParameter("density", WriteNumber(RoundTo(density, 0.02 * density)));
  }
}

// Sizes given by neither file nor words: their defaults depend on the scene.
void NoteDefaults(const PointsChoice& choice, vtkRelievoPointValues* points, ReadContext& context)
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
      defaults += (defaults.empty() ? "" : " and ") + parameter.Name + " " + parameter.Format();
    }
  }
  if (!defaults.empty())
  {
    context.Note(choice.File + ": " + points->GetThings() + " with " + defaults +
      ", for the file has no such array");
  }
}
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
FramePoints ReadFramePoints(const RenderOptions& options, ReadContext& context)
{
  FramePoints all;
  for (const PointsChoice& choice : options.Points)
  {
    const vtkSmartPointer<vtkRelievoPointValues> points = MakePointValues(choice.Stage);
    points->SetInputData(ReadPoints(choice.File, context));
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
    CheckPoints(choice.File, points, context);
    FitDensity(choice, options, points);
    NoteDefaults(choice, points, context);
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
