// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceOptions.h"

#include "Errors.h"
#include "Numbers.h"
#include "Options.h"
#include "Settings.h"
#include "ShadowOptions.h"
#include "Values.h"

#include "vtkNew.h"
#include "vtkRelievoEnvironment.h"
#include "vtkRelievoMaterial.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <optional>

namespace scene
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
    const std::string wrong = values.TrySet(name, words);
    if (!wrong.empty())
    {
      throw UsageError(option + " " + name + ": " + wrong);
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

void SetMaterial(Settings& settings, const NamedWords& values)
{
  values.empty() ? settings.Remove("--material")
                 : settings.Set("--material", WriteNamedWords(values));
}

void SetEnvironment(
  Settings& settings, const std::string& file, double rotation, const NamedWords& values)
{
  settings.Set("--environment",
    WriteFileAndNumber(file, rotation) + (values.empty() ? "" : "," + WriteNamedWords(values)));
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
std::string GetSurfaceValue(const RenderOptions& options, const std::string& name)
{
  const bool ofMaterial = GetMaterialValues().Find(name) != nullptr;
  const std::string given =
    FindWords(ofMaterial ? options.Material : options.EnvironmentValues, name);
  if (!given.empty())
  {
    return given;
  }
  if (name == "self_shadow")
  {
    return ShowsShadows(options) ? "on" : "off";
  }
  return (ofMaterial ? GetMaterialValues() : GetEnvironmentValues()).GetDefault(name);
}

//------------------------------------------------------------------------------
void SetSurfaceValue(Settings& settings, const std::string& name, const std::string& words)
{
  RenderOptions options = settings.Parse();
  if (GetMaterialValues().Find(name))
  {
    SetWords(options.Material, name, words);
    SetMaterial(settings, options.Material);
    return;
  }
  SetWords(options.EnvironmentValues, name, words);
  SetEnvironment(
    settings, options.Environment, options.EnvironmentRotation, options.EnvironmentValues);
}

//------------------------------------------------------------------------------
std::optional<vtkRelievoParameter::Condition> FindFailing(
  const RenderOptions& options, const vtkRelievoParameter& value)
{
  for (const vtkRelievoParameter::Condition& condition : value.GetConditions())
  {
    const std::string& name = condition.Name;
    const std::string words = name == "height_map" ? options.HeightMap
      : name == "environment"                      ? options.Environment
      : name == "relief_method"                    ? options.ReliefMethod
                                                   : GetSurfaceValue(options, name);
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
void SetEnvironmentFile(Settings& settings, const std::string& file, double rotation)
{
  if (file.empty())
  {
    settings.Remove("--environment");
    return;
  }
  std::string before = settings.Get("--environment");
  SetEnvironment(settings, file, rotation, TakeValuesBehind(before));
}

//------------------------------------------------------------------------------
void DropIdleSurface(Settings& settings)
{
  RenderOptions options;
  options.NormalMap = settings.Get("--normal-map");
  options.HeightMap = settings.Get("--height-map");
  options.Environment = settings.Get("--environment");
  const auto dropUnless = [&settings](bool needed, const char* option) {
    needed ? void() : settings.Remove(option);
  };
  dropUnless(!options.HeightMap.empty(), "--relief");
  dropUnless(!options.HeightMap.empty() || !options.NormalMap.empty(), "--texture-coordinates");
  dropUnless(!options.Environment.empty(), "--reflectivity");
  dropUnless(!options.Environment.empty(), "--skybox");
  if (settings.Has("--relief"))
  {
    options.ReliefMethod = settings.Get("--relief");
  }
  if (settings.Has("--material"))
  {
    TakeMaterial(options, settings.Get("--material"));
    NamedWords kept;
    std::copy_if(options.Material.begin(), options.Material.end(), std::back_inserter(kept),
      [&options](const auto& given) {
        return !FindFailing(options, *GetMaterialValues().Find(given.first));
      });
    SetMaterial(settings, kept);
  }
}

//------------------------------------------------------------------------------
void TakeMaterial(RenderOptions& options, const std::string& word)
{
  options.Material = ParseNamedWords("--material", SplitEscaped(word, ','), MaterialForm);
  CheckValues("--material", GetMaterialValues(), options.Material);
}

//------------------------------------------------------------------------------
const std::vector<std::string>& GetReliefMethods()
{
  return GetMaterial()->GetDescription().Find("relief_method")->Choices;
}

//------------------------------------------------------------------------------
void TakeHeightMap(RenderOptions& options, const std::string& word)
{
  options.HeightMap = word;
  const std::string scale = TakeNumberBehind(options.HeightMap);
  if (options.HeightMap != word)
  {
    options.HeightScale = ParseNumberBetween(
      "--height-map " + word, scale, 0.0, std::numeric_limits<double>::infinity());
  }
}

//------------------------------------------------------------------------------
void TakeEnvironment(RenderOptions& options, const std::string& word)
{
  options.Environment = word;
  options.EnvironmentValues = TakeValuesBehind(options.Environment);
  CheckValues("--environment", GetEnvironmentValues(), options.EnvironmentValues);
  const std::string path = options.Environment;
  const std::string degrees = TakeNumberBehind(options.Environment);
  if (options.Environment != path)
  {
    options.EnvironmentRotation =
      ParseNumbers("--environment " + word, degrees, 1, "degrees of rotation")[0];
  }
}

//------------------------------------------------------------------------------
void TakeReflectivity(RenderOptions& options, const std::string& word)
{
  const bool both = word.find(',') != std::string::npos;
  const std::vector<double> n =
    ParseNumbers("--reflectivity", word, both ? 2 : 1, both ? "R,ROUGHNESS" : "R");
  if (std::any_of(n.begin(), n.end(), [](double share) { return share < 0.0 || share > 1.0; }))
  {
    RefuseValue("--reflectivity", word, "R[,ROUGHNESS], both from 0 to 1");
  }
  options.Reflectivity = n[0];
  options.Roughness = both ? n[1] : options.Roughness;
}

//------------------------------------------------------------------------------
void CheckSurfaceOptions(const RenderOptions& options, const std::set<std::string>& given)
{
  if (given.count("--relief") && options.HeightMap.empty())
  {
    throw UsageError("--relief: there are no heights: give --height-map F as well");
  }
  if (given.count("--texture-coordinates") && options.NormalMap.empty() &&
    options.HeightMap.empty())
  {
    throw UsageError(
      "--texture-coordinates: there is nothing to place by them: give --normal-map F "
      "or --height-map F as well");
  }
  for (const auto& [name, words] : options.Material)
  {
    const auto failing = FindFailing(options, *GetMaterialValues().Find(name));
    if (failing && failing->Value.empty())
    {
      throw UsageError("--material " + name + ": there is " +
        (failing->Name == "environment" ? "nothing to mirror: give --environment F as well"
                                        : "no relief: give --height-map F as well"));
    }
    if (failing)
    {
      throw UsageError("--material " + name + ": got '" + words + "' with --relief " +
        options.ReliefMethod + ", expected it " +
        (failing->Other ? "with another method" : "with --relief " + failing->Value));
    }
  }
  for (const char* option : { "--skybox", "--reflectivity" })
  {
    if (given.count(option) && options.Environment.empty())
    {
      throw UsageError(std::string(option) +
        (options.Skybox ? ": there is no environment to show" : ": there is nothing to mirror") +
        ": give --environment F as well");
    }
  }
}
}
