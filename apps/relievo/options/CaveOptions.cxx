// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CaveOptions.h"

#include "Arguments.h"
#include "Errors.h"
#include "Values.h"

#include <algorithm>
#include <limits>

namespace cli
{
namespace
{
constexpr int MostSamples = 1 << 20; // along an axis

double ParseLength(const std::string& name, const std::string& value)
{
  return scene::ParseNumberBetween(name, value, 0., std::numeric_limits<double>::infinity());
}

std::array<double, 3> ParseTriple(const std::string& name, const std::string& value)
{
  const std::vector<double> numbers = scene::ParseNumbers(name, value, 3, "X,Y,Z");
  return { numbers[0], numbers[1], numbers[2] };
}

void ParseSize(const std::string& name, const std::string& value, std::array<int, 3>& size)
{
  const std::vector<std::string> parts = scene::Split(value, 'x');
  if (parts.size() != 3)
  {
    scene::RefuseValue(name, value, "WxHxD, such as 256x128x256");
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = scene::ParseWhole(name, parts[axis], 1, MostSamples);
  }
}
}

//------------------------------------------------------------------------------
CaveOptions ParseCave(const std::vector<std::string>& words)
{
  CaveOptions options;
  scene::ParseArguments(
    words, "cave",
    { { "-o", false }, { "--size", false }, { "--seed", false }, { "--width", false },
      { "--scale", false }, { "--vertical-scale", false }, { "--up", false }, { "--origin", false },
      { "--spacing", false }, { "--content", false } },
    [&](const std::string& name, const std::string& value) {
      if (name == "-o")
      {
        options.File = value;
      }
      else if (name == "--size")
      {
        ParseSize(name, value, options.Size);
      }
      else if (name == "--seed")
      {
        options.Seed = scene::ParseWhole(
          name, value, std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
      }
      else if (name == "--width")
      {
        options.Width = ParseLength(name, value);
      }
      else if (name == "--scale")
      {
        options.Scale = ParseLength(name, value);
      }
      else if (name == "--vertical-scale")
      {
        options.VerticalScale = ParseLength(name, value);
      }
      else if (name == "--up")
      {
        options.Up = static_cast<int>(scene::ParseChoice(name, value, { "x", "y", "z" }));
      }
      else if (name == "--content")
      {
        options.Content =
          static_cast<int>(scene::ParseChoice(name, value, { "mask", "density", "labels" }));
      }
      else
      {
        (name == "--origin" ? options.Origin : options.Spacing) = ParseTriple(name, value);
      }
    },
    [&](const std::string& word) {
      throw scene::UsageError(
        "cave: got '" + word + "', expected options; the file is given as -o FILE.vti");
    });
  const std::string::size_type dot = options.File.rfind('.');
  if (options.File.empty())
  {
    throw scene::UsageError("cave: no file to write; give -o FILE.vti");
  }
  if (dot == std::string::npos || options.File.substr(dot) != ".vti")
  {
    scene::RefuseValue("-o", options.File, "a name that ends in .vti");
  }
  return options;
}
}
