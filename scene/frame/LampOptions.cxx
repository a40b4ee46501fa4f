// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LampOptions.h"

#include "Errors.h"
#include "Options.h"
#include "Values.h"

#include <limits>
#include <utility>
#include <vector>

namespace scene
{
namespace
{
const char* const Form = "FILE[,radius=R][,intensity=I][,color=R/G/B][,falloff=linear|"
                         "inverse-square|vtk][,attenuation=A/B/C][,casts=always|never|ARRAY]"
                         "[,casting=N]";

PointValue ParseCasts(const std::string& option, const std::string& word)
{
  PointValue casts;
  if (word.empty())
  {
    RefuseValue(option, word, "always, never, or the name of a point array");
  }
  if (word == "always" || word == "never")
  {
    casts.Number = word == "always" ? 1.0 : 0.0;
  }
  else
  {
    casts.Array = word;
  }
  return casts;
}
}

//------------------------------------------------------------------------------
void TakeLamps(RenderOptions& options, const std::string& word)
{
  LampChoice lamps;
  std::vector<std::pair<std::string, std::string>> values;
  lamps.File = ParseFileAndValues("--lamps", word, Form, values);
  for (const auto& [name, value] : values)
  {
    const std::string option = "--lamps " + name;
    constexpr Falloff kinds[] = { Falloff::Linear, Falloff::InverseSquare, Falloff::VTK };
    switch (ParseChoice("--lamps " + name + "=" + value, name,
      { "radius", "intensity", "color", "falloff", "attenuation", "casts", "casting" }))
    {
      case 0:
        lamps.Radius = ParsePointValue(option, value, 0.0);
        break;
      case 1:
        lamps.Intensity = ParsePointValue(option, value, -std::numeric_limits<double>::infinity());
        break;
      case 2:
        lamps.Color = ParseColorValue(option, value);
        break;
      case 3:
        lamps.Kind = kinds[ParseChoice(option, value, { "linear", "inverse-square", "vtk" })];
        break;
      case 4:
        lamps.Attenuation = ParseThree(option, value);
        break;
      case 5:
        lamps.Casts = ParseCasts(option, value);
        break;
      default:
        AddStage(options.Stages, "lamps", "--lamps casting")
          .Parameters.emplace_back("casting", std::to_string(ParseWhole(option, value, 0, 8)));
    }
  }
  if (lamps.Attenuation && lamps.Kind != Falloff::VTK)
  {
    RefuseValue("--lamps attenuation", word, "falloff=vtk with it");
  }
  options.Lamps.push_back(lamps);
}
}
