// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FogOptions.h"

#include "Errors.h"
#include "Values.h"

#include <utility>

namespace scene
{
namespace
{
const char* const Form = "FILE[,radius=R][,density=D][,color=R/G/B][,mode=beer|chord]";
}

//------------------------------------------------------------------------------
FogChoice ParseFog(const std::string& word)
{
  FogChoice fog;
  std::vector<std::pair<std::string, std::string>> values;
  fog.File = ParseFileAndValues("--fog", word, Form, values);
  for (const auto& [name, value] : values)
  {
    const std::string option = "--fog " + name;
    switch (
      ParseChoice("--fog " + name + "=" + value, name, { "radius", "density", "color", "mode" }))
    {
      case 0:
        fog.Radius = ParsePointValue(option, value, 0.0);
        break;
      case 1:
        fog.Density = ParsePointValue(option, value, 0.0);
        break;
      case 2:
        fog.Color = ParseColorValue(option, value);
        break;
      default:
        ParseChoice(option, value, { "beer", "chord" });
        fog.Mode = value;
    }
  }
  return fog;
}

//------------------------------------------------------------------------------
void CheckFogs(const std::vector<FogChoice>& fogs)
{
  std::string mode;
  for (const FogChoice& fog : fogs)
  {
    if (!fog.Mode.empty() && !mode.empty() && fog.Mode != mode)
    {
      throw UsageError("--fog: got mode=beer and mode=chord, expected one mode for all fog");
    }
    mode = fog.Mode.empty() ? mode : fog.Mode;
  }
}
}
