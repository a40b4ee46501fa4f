// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowOptions.h"

#include "Errors.h"
#include "Options.h"
#include "Values.h"

#include "vtkRelievoLayerCatalogue.h"

#include <algorithm>

namespace scene
{
namespace
{
bool SetsShadows(const RenderOptions& options)
{
  return std::any_of(options.Stages.begin(), options.Stages.end(),
    [](const StageChoice& stage) { return stage.Name == "shadows"; });
}
}

//------------------------------------------------------------------------------
void TakeCertify(RenderOptions& options, const std::string& word)
{
  options.Certify = ParseWhole("--certify", word, 1, MostRays);
}

//------------------------------------------------------------------------------
void CheckShadowWishes(RenderOptions& options, const std::set<std::string>& given)
{
  for (const char* wish : { "--shadow-tolerance", "--time-budget" })
  {
    for (const char* choice : { "--shadows", "--shadow-size" })
    {
      if (given.count(wish) && given.count(choice))
      {
        throw UsageError(std::string(wish) + " and " + choice +
          ": the first chooses the method and the size of maps; give one of them");
      }
    }
    if (given.count(wish))
    {
      options.ShadowMethod = Shadows::Map; // visible; the method is chosen later
    }
  }
  if (options.Certify && options.ShadowMethod == Shadows::Off && !SetsShadows(options) &&
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
  return enabled ? *enabled == "on" : options.ShadowMethod != Shadows::Off;
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
