// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowOptions.h"

#include "Errors.h"
#include "Numbers.h"
#include "OptionRows.h"
#include "Options.h"

#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoParameter.h"

#include <algorithm>
#include <limits>

namespace scene
{
namespace
{
constexpr int MostCertified = 100000000; // rays

// Whether shadows are shown, or any of their parameters is set.
bool SetsShadows(const RenderOptions& options)
{
  return ShowsShadows(options) ||
    std::any_of(options.Stages.begin(), options.Stages.end(),
      [](const StageChoice& stage) { return stage.Name == "shadows" && !IsOfSwitch(stage); });
}
}

//------------------------------------------------------------------------------
void ShowShadows(RenderOptions& options, const NamedWords& parameters)
{
  // Placed first, because --stage and options take precedence.
  StageChoice& choice = *options.Stages.insert(
    options.Stages.begin(), { "shadows", { { "enabled", "on" } }, "--preset" });
  choice.Parameters.insert(choice.Parameters.end(), parameters.begin(), parameters.end());
}

//------------------------------------------------------------------------------
void CheckShadowWishes(RenderOptions& options)
{
  for (const vtkRelievoOption& wish : GetRenderCommand().Options)
  {
    if (wish.Implies.empty() || !options.Has(wish.Name))
    {
      continue;
    }
    for (const std::string& choice : { wish.Implies.front(), std::string("--shadow-size") })
    {
      if (options.Has(choice))
      {
        throw UsageError(wish.Name + " and " + choice +
          ": the first chooses the method and the size of maps; give one of them");
      }
    }
    ShowShadows(options);
  }
  if (options.Has("--certify") && !SetsShadows(options) &&
    std::all_of(options.Layers.begin(), options.Layers.end(),
      [](const std::string& name) { return vtkRelievoLayerCatalogue::GetLight(name) < 0; }))
  {
    throw UsageError("--certify: there are no shadows to judge: give --shadows METHOD or "
                     "--shadow-tolerance SHARE as well");
  }
}

//------------------------------------------------------------------------------
bool ShowsShadows(const RenderOptions& options)
{
  const std::string* enabled = FindStageChoice(options.Stages, "shadows", "enabled");
  return enabled && *enabled == "on";
}

//------------------------------------------------------------------------------
void CheckShadowLayers(const RenderOptions& options, int lights, const std::string& whose)
{
  for (const std::string& name : options.Layers)
  {
    if (vtkRelievoLayerCatalogue::GetLight(name) >= lights)
    {
      const std::string last =
        vtkRelievoLayerCatalogue::GetOfLight().Name + std::to_string(lights - 1);
      RefuseValue("--layers", name,
        (lights == 1 ? "no shadow layer but " + last : "none beyond " + last) + ": there " +
          (lights == 1 ? "is 1 " : "are " + std::to_string(lights) + " ") + whose +
          ", counted from 0");
    }
  }
}

//------------------------------------------------------------------------------
void AddShadowOptions(OptionRows& rows, RenderOptions& all)
{
  AddSwitch(rows, all.Stages, "--shadows", "METHOD", "shadows", "method",
    "shadows of the lights in the picture: @choices@ (map with studio and town, else off)")
    .Is(OptionRows::Option::KEEPS_STYLE)
    .NamedIn("Light", "Shadows");
  rows
    .AddChoice("--volume-shadows", "KIND", { "both", "casts", "receives", "none" },
      "whether volumes (--image volume) cast shadows and receive them, also their own, if there "
      "are shadows: @choices@ (both)")
    .NamedIn("Look", "Volume shadows");
  AddOfStage(rows, all.Stages, "--shadow-size N", "shadows", "map_size", "Side of each shadow map")
    .NamedIn("Light", "Map size");
  AddOfStage(rows, all.Stages, "--soft-shadows N", "shadows", "soft_samples", "-")
    .NamedIn("Light", "Samples")
    .Help = "shadows of lights with a size: the mean of N samples of each light's shape, 0 to "
            "4096 (24 with studio and town, 4 with --image volume, unless --shadows, --certify, "
            "--shadow-tolerance, --time-budget or --layers is given; else 0: hard shadows)";
  AddOfStage(rows, all.Stages, "--colored-shadows", "shadows", "colored_shadows",
    "Translucent meshes cast shadows too, and colour the light that passes them; needs "
    "--shadows exact, except for coloured volumes (--image volume), which then colour it")
    .NamedIn("Light", "Coloured shadows");
  AddOfStage(rows, all.Stages, "--shadow-tolerance S", "shadows", "tolerance", "-",
    [](const std::string& word) { return WriteNumber(ParseShare("--shadow-tolerance", word)); })
    .NamedIn("Light", "Tolerance")
    .Help = "shadows by the cheapest method with an expected share of wrong pixels of at most S, "
            "such as 0.05% or 0.0005";
  // The method is chosen later.
  rows.Command.Options.back().Implies = { "--shadows", "map" };
  AddOfStage(rows, all.Stages, "--time-budget MS", "shadows", "time_budget", "-",
    [](const std::string& word) {
      return WriteNumber(
        ParseNumberBetween("--time-budget", word, 0.0, std::numeric_limits<double>::infinity()));
    })
    .NamedIn("Light", "Time budget")
    .Help = "shadows by the most accurate method whose frames are expected to take at most MS "
            "milliseconds";
  rows.Command.Options.back().Implies = { "--shadows", "map" };
  rows
    .Add("--certify", "N",
      "checks N shadow verdicts, chosen at random, by rays in double precision, and prints "
      "the share of wrong ones with its 95 % bound",
      [&all](const std::string& word) {
        all.Numbers.Set("--certify", ParseWhole("--certify", word, 1, MostCertified));
      })
    .RefuseLens("it checks only a pinhole's picture")
    .OfOutputs = true;
}

//------------------------------------------------------------------------------
// Rejects options about shadows that have no effect without shadows.
void CheckShadowsAsked(const RenderOptions& options)
{
  const auto find = [&options](const std::string& parameter) {
    return FindStageChoice(options.Stages, "shadows", parameter);
  };
  const bool asked = find("enabled") ||
    std::any_of(options.Layers.begin(), options.Layers.end(),
      [](const std::string& name) { return vtkRelievoLayerCatalogue::GetLight(name) >= 0; });
  const bool sizes = options.Has("--shadow-size");
  const bool softens = options.Has("--soft-shadows");
  if (!asked && (sizes || softens))
  {
    throw UsageError(std::string(sizes ? "--shadow-size: there are no shadows to size"
                                       : "--soft-shadows: there are no shadows") +
      ": give --shadows map, --stage shadows, or a layer shadow_N, as well");
  }
  const std::string* method = find("method");
  if (options.Has("--colored-shadows") && options.Image.Is != ImageChoice::Kind::Volume &&
    (!method || *method != "exact"))
  {
    throw UsageError("--colored-shadows: shadow maps store no colour of surfaces: give --shadows "
                     "exact as well, or a volume (--image volume)");
  }
  const bool sized =
    std::any_of(options.Lights.begin(), options.Lights.end(), [](const LightChoice& light) {
      return light.Size ? *light.Size > 0.0 : light.Is == LightChoice::Kind::Sun;
    });
  if (softens && !options.Lights.empty() && !sized && !find("lamp_radius"))
  {
    throw UsageError("--soft-shadows: no light has a size: give one, as in --light "
                     "point:PX,PY,PZ,size=RADIUS");
  }
}
}
