// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowOptions.h"

#include "Errors.h"
#include "Options.h"

#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoParameter.h"

#include <algorithm>

namespace scene
{
namespace
{
// Whether shadows are shown, or any of their parameters is set.
bool SetsShadows(const RenderOptions& options)
{
  return ShowsShadows(options) ||
    std::any_of(options.Stages.begin(), options.Stages.end(),
      [](const StageChoice& stage) { return stage.Name == "shadows" && !IsOfSwitch(stage); });
}
}

//------------------------------------------------------------------------------
void TakeCertify(RenderOptions& options, const std::string& word)
{
  options.Certify = ParseWhole("--certify", word, 1, MostRays);
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
void CheckShadowWishes(RenderOptions& options, const std::set<std::string>& given)
{
  for (const vtkRelievoOption& wish : GetRenderCommand().Options)
  {
    if (wish.Implies.empty() || given.count(wish.Name) == 0)
    {
      continue;
    }
    for (const std::string& choice : { wish.Implies.front(), std::string("--shadow-size") })
    {
      if (given.count(choice))
      {
        throw UsageError(wish.Name + " and " + choice +
          ": the first chooses the method and the size of maps; give one of them");
      }
    }
    ShowShadows(options);
  }
  if (options.Certify && !SetsShadows(options) &&
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
}
