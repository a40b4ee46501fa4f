// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointsValues.h"

namespace viewer
{
//------------------------------------------------------------------------------
std::vector<PointsValue> GetPointsValues(const std::string& stage)
{
  using Value = PointsValue;
  const std::string array = " A number for all points, or the name of a point array.";
  const std::string color =
    " Linear red, green and blue for all points, such as 1/0.5/0, or the name of a point array.";
  if (stage == "lamps")
  {
    return { { "radius", "Radius", Value::Number, "array radius, or 1",
               "How far lamps shine, in world units." + array, {} },
      { "intensity", "Intensity", Value::Number, "array intensity, or 1",
        "How bright lamps are." + array, {} },
      { "color", "Colour", Value::Color, "array color, or white", "What colour lamps have." + color,
        {} },
      { "falloff", "Falloff", Value::Choice, "", "How light fades on its way.",
        { "linear", "inverse-square", "vtk" } },
      { "attenuation", "Attenuation", Value::Three, "1/0/0",
        "A/B/C of VTK's falloff: the light is divided by A + B distance + C distance squared.",
        {} },
      { "casts", "Casts shadows", Value::Number, "never",
        "Whether lamps cast shadows: always, never, or the name of a point array of 1 and 0. At "
        "most eight do.",
        { "always", "never" } } };
  }
  if (stage == "fog")
  {
    return { { "radius", "Radius", Value::Number, "array radius, or 1",
               "How large the spheres are, in world units." + array, {} },
      { "density", "Density", Value::Number, "array density, or 1", "How dense the fog is." + array,
        {} },
      { "color", "Colour", Value::Color, "array color, or white",
        "What colour the fog has." + color, {} } };
  }
  if (stage == "markers")
  {
    return { { "shape", "Shape", Value::Choice, "", "What is drawn on surfaces around points.",
               { "ring", "glow", "disc", "shadow" } },
      { "radius", "Radius", Value::Number, "array radius, or 1",
        "How far markers reach, in world units." + array, {} },
      { "width", "Width", Value::Number, "array width, or 0.2",
        "How wide rings are, as a share of the radius." + array, {} },
      { "reach", "Reach", Value::Number, "array reach, or 4",
        "How far below points shadows lie, in radii." + array, {} },
      { "opacity", "Opacity", Value::Number, "array opacity, or 0.8",
        "0 is invisible, 1 hides what is below." + array, {} },
      { "color", "Colour", Value::Color, "array color, or orange",
        "What colour markers have." + color, {} },
      { "up", "Up", Value::Three, "the up axis", "X/Y/Z, the direction that shadows fall from.",
        {} } };
  }
  return {};
}
}
