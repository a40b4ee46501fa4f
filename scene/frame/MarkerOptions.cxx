// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MarkerOptions.h"

#include "Errors.h"
#include "Values.h"

#include <algorithm>
#include <utility>

namespace scene
{
namespace
{
const char* const Form = "FILE[,shape=ring|glow|disc|shadow][,radius=R][,width=W][,reach=H]"
                         "[,opacity=A][,color=R/G/B][,up=X/Y/Z]";
}

//------------------------------------------------------------------------------
MarkerChoice ParseMarkers(const std::string& word)
{
  MarkerChoice markers;
  std::vector<std::pair<std::string, std::string>> values;
  markers.File = ParseFileAndValues("--markers", word, Form, values);
  PointValue* const numbers[] = { &markers.Radius, &markers.Width, &markers.Reach,
    &markers.Opacity };
  for (const auto& [name, value] : values)
  {
    const std::string option = "--markers " + name;
    const auto which = ParseChoice("--markers " + name + "=" + value, name,
      { "radius", "width", "reach", "opacity", "color", "shape", "up" });
    switch (which)
    {
      case 4:
        markers.Color = ParseColorValue(option, value);
        break;
      case 5:
        markers.Shape =
          static_cast<int>(ParseChoice(option, value, { "ring", "glow", "disc", "shadow" }));
        break;
      case 6:
        markers.Up = ParseThree(option, value);
        if (std::all_of(markers.Up->begin(), markers.Up->end(), [](double v) { return v == 0.0; }))
        {
          RefuseValue(option, value, "a direction, such as 0/0/1");
        }
        break;
      default:
        *numbers[which] = ParsePointValue(option, value, 0.0);
    }
  }
  return markers;
}
}
