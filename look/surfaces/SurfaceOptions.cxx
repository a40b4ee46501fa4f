// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceOptions.h"

#include "Errors.h"

#include "vtkNew.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoMaterial.h"
#include "vtkRelievoParameter.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <optional>

namespace look
{
namespace
{
// "F" or "F,NUMBER". File names may contain commas: only a number after the last one counts.
std::string TakeNumberBehind(std::string& path)
{
  const std::string::size_type comma = path.rfind(',');
  if (comma == std::string::npos ||
    path.find_first_not_of("0123456789.eE+-", comma + 1) != std::string::npos)
  {
    return "";
  }
  std::string number = path.substr(comma + 1);
  path.erase(comma);
  return number;
}

const char* const MaterialForm = "NAME=VALUE[,NAME=VALUE]...";

vtkRelievoMaterial* GetMaterial()
{
  static const vtkNew<vtkRelievoMaterial> material;
  return material;
}

vtkRelievoEnvironment* GetEnvironment()
{
  static const vtkNew<vtkRelievoEnvironment> environment;
  return environment;
}

// Throws UsageError if the parameters refuse the words.
void CheckValues(
  const std::string& option, const vtkRelievoParameterList& values, const NamedWords& given)
{
  for (const auto& [name, words] : given)
  {
    if (!values.Find(name))
    {
      RefuseValue(option, name + "=" + words, "one of " + values.GetNames());
    }
    const std::string error = values.TrySet(name, words);
    if (!error.empty())
    {
      throw UsageError(option + " " + name + ": " + error);
    }
  }
}

// Removes parameters that have options of their own, and sets the defaults of scenes.
vtkRelievoParameterList TakeOthers(const vtkRelievoParameterList& all,
  const std::set<std::string>& ownOptions, const std::map<std::string, std::string>& defaults)
{
  vtkRelievoParameterList others;
  for (const vtkRelievoParameter& parameter : all.Parameters)
  {
    if (ownOptions.count(parameter.Name) == 0)
    {
      others.Parameters.push_back(parameter);
      const auto found = defaults.find(parameter.Name);
      others.Parameters.back().Default =
        found == defaults.end() ? parameter.Default : found->second;
    }
  }
  return others;
}

// Parses --environment: the part after the file and a number.
NamedWords TakeValuesBehind(std::string& word)
{
  std::vector<std::string> parts;
  for (;;)
  {
    const std::size_t comma = word.rfind(',');
    const std::string last = comma == std::string::npos ? "" : word.substr(comma + 1);
    if (!GetEnvironmentValues().Find(last.substr(0, last.find('='))) ||
      last.find('=') == std::string::npos)
    {
      return ParseNamedWords("--environment", parts, "F[,DEG][,NAME=VALUE]...");
    }
    parts.insert(parts.begin(), last);
    word.erase(comma);
  }
}
}

//------------------------------------------------------------------------------
const vtkRelievoParameterList& GetMaterialValues()
{
  static const vtkRelievoParameterList values = TakeOthers(GetMaterial()->GetDescription(),
    { "height_scale", "relief_method", "reflectivity", "roughness" },
    { { "depth_correction", "on" }, { "self_shadow", "on with shadows" } });
  return values;
}

//------------------------------------------------------------------------------
const vtkRelievoParameterList& GetEnvironmentValues()
{
  // Pictures are made for displays: the sky keeps its displayed colours.
  static const vtkRelievoParameterList values = TakeOthers(
    GetEnvironment()->GetDescription(), { "rotation", "up" }, { { "gamma_correct", "on" } });
  return values;
}

//------------------------------------------------------------------------------
std::string GetSurfaceValue(const SurfaceChoice& surface, const std::string& name)
{
  const bool ofMaterial = GetMaterialValues().Find(name) != nullptr;
  const std::string given =
    FindWords(ofMaterial ? surface.Material : surface.EnvironmentValues, name);
  if (!given.empty())
  {
    return given;
  }
  if (name == "self_shadow")
  {
    return surface.Shadowed ? "on" : "off";
  }
  return (ofMaterial ? GetMaterialValues() : GetEnvironmentValues()).GetDefault(name);
}

//------------------------------------------------------------------------------
std::optional<vtkRelievoParameter::Condition> FindFailing(
  const SurfaceChoice& surface, const vtkRelievoParameter& value)
{
  for (const vtkRelievoParameter::Condition& condition : value.GetConditions())
  {
    const std::string& name = condition.Name;
    const std::string words = name == "height_map" ? surface.HeightMap
      : name == "environment"                      ? surface.Environment
      : name == "relief_method"                    ? surface.ReliefMethod
                                                   : GetSurfaceValue(surface, name);
    const bool holds =
      condition.Value.empty() ? !words.empty() : (words == condition.Value) != condition.Other;
    if (!holds)
    {
      return condition;
    }
  }
  return std::nullopt;
}

//------------------------------------------------------------------------------
void TakeMaterial(SurfaceChoice& surface, const std::string& word)
{
  surface.Material = ParseNamedWords("--material", SplitEscaped(word, ','), MaterialForm);
  CheckValues("--material", GetMaterialValues(), surface.Material);
}

//------------------------------------------------------------------------------
const std::vector<std::string>& GetReliefMethods()
{
  return GetMaterial()->GetDescription().Find("relief_method")->Choices;
}

//------------------------------------------------------------------------------
void TakeHeightMap(SurfaceChoice& surface, const std::string& word)
{
  surface.HeightMap = word;
  const std::string scale = TakeNumberBehind(surface.HeightMap);
  if (surface.HeightMap != word)
  {
    surface.HeightScale = ParseNumberBetween(
      "--height-map " + word, scale, 0.0, std::numeric_limits<double>::infinity());
  }
}

//------------------------------------------------------------------------------
void TakeEnvironment(SurfaceChoice& surface, const std::string& word)
{
  surface.Environment = word;
  surface.EnvironmentValues = TakeValuesBehind(surface.Environment);
  CheckValues("--environment", GetEnvironmentValues(), surface.EnvironmentValues);
  const std::string path = surface.Environment;
  const std::string degrees = TakeNumberBehind(surface.Environment);
  if (surface.Environment != path)
  {
    surface.EnvironmentRotation =
      ParseNumbers("--environment " + word, degrees, 1, "degrees of rotation")[0];
  }
}

//------------------------------------------------------------------------------
void TakeReflectivity(SurfaceChoice& surface, const std::string& word)
{
  const bool both = word.find(',') != std::string::npos;
  const std::vector<double> n =
    ParseNumbers("--reflectivity", word, both ? 2 : 1, both ? "R,ROUGHNESS" : "R");
  if (std::any_of(n.begin(), n.end(), [](double share) { return share < 0.0 || share > 1.0; }))
  {
    RefuseValue("--reflectivity", word, "R[,ROUGHNESS], both from 0 to 1");
  }
  surface.Reflectivity = n[0];
  surface.Roughness = both ? n[1] : surface.Roughness;
}

//------------------------------------------------------------------------------
void CheckSurfaceOptions(const SurfaceChoice& surface, const GivenWords& given)
{
  if (given.count("--relief") && surface.HeightMap.empty())
  {
    throw UsageError("--relief: there are no heights: give --height-map F as well");
  }
  if (given.count("--texture-coordinates") && !surface.IsMapped())
  {
    throw UsageError(
      "--texture-coordinates: there is nothing to place by them: give --normal-map F "
      "or --height-map F as well");
  }
  for (const auto& [name, words] : surface.Material)
  {
    const auto failing = FindFailing(surface, *GetMaterialValues().Find(name));
    if (failing && failing->Value.empty())
    {
      throw UsageError("--material " + name + ": there is " +
        (failing->Name == "environment" ? "nothing to mirror: give --environment F as well"
                                        : "no relief: give --height-map F as well"));
    }
    if (failing)
    {
      throw UsageError("--material " + name + ": got '" + words + "' with --relief " +
        surface.ReliefMethod + ", expected it " +
        (failing->Other ? "with another method" : "with --relief " + failing->Value));
    }
  }
  for (const char* option : { "--skybox", "--reflectivity" })
  {
    if (given.count(option) && surface.Environment.empty())
    {
      throw UsageError(std::string(option) +
        (surface.Skybox ? ": there is no environment to show" : ": there is nothing to mirror") +
        ": give --environment F as well");
    }
  }
}
}
