// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LampOptions.h"

#include "Failure.h"
#include "Values.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <vector>

namespace cli
{
namespace
{
const char* const Form = "FILE[,radius=R][,intensity=I][,color=R/G/B][,falloff=linear|"
                         "inverse-square|vtk][,attenuation=A/B/C]";

// Whether the word is meant as a number: arrays may be called anything else.
bool IsNumber(const std::string& word)
{
  try
  {
    ParseNumbers("", word, 1, "");
    return true;
  }
  catch (const WordsError&)
  {
    return word.empty();
  }
}

PointValue ParseValue(const std::string& option, const std::string& word, double least)
{
  PointValue value;
  if (!IsNumber(word))
  {
    value.Array = word;
    return value;
  }
  value.Number = ParseNumbers(option, word, 1, "a number, or the name of a point array").front();
  if (*value.Number < least)
  {
    RefuseValue(option, word, "0 or more");
  }
  return value;
}

std::array<double, 3> ParseThree(const std::string& option, const std::string& word)
{
  const std::vector<std::string> parts = Split(word, '/');
  if (parts.size() != 3)
  {
    RefuseValue(option, word, "three numbers, such as 1/0.8/0.5");
  }
  std::array<double, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    numbers[i] = ParseNumbers(option, parts[i], 1, "three numbers, such as 1/0.8/0.5").front();
  }
  return numbers;
}
}

//------------------------------------------------------------------------------
LampChoice ParseLamps(const std::string& word)
{
  const std::vector<std::string> parts = Split(word, ',');
  LampChoice lamps;
  lamps.File = parts.front();
  if (lamps.File.empty())
  {
    RefuseValue("--lamps", word, Form);
  }
  std::set<std::string> given;
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    const std::size_t equals = parts[i].find('=');
    const std::string name = parts[i].substr(0, equals);
    if (equals == std::string::npos || !given.insert(name).second)
    {
      RefuseValue("--lamps", parts[i], std::string(Form) + ", each once");
    }
    const std::string value = parts[i].substr(equals + 1);
    const std::string option = "--lamps " + name;
    constexpr Falloff kinds[] = { Falloff::Linear, Falloff::InverseSquare, Falloff::VTK };
    switch (ParseChoice(
      "--lamps " + parts[i], name, { "radius", "intensity", "color", "falloff", "attenuation" }))
    {
      case 0:
        lamps.Radius = ParseValue(option, value, 0.0);
        break;
      case 1:
        lamps.Intensity = ParseValue(option, value, -std::numeric_limits<double>::infinity());
        break;
      case 2:
        if (value.find('/') == std::string::npos)
        {
          lamps.ColorArray = value;
        }
        else
        {
          lamps.Color = ParseThree(option, value);
        }
        break;
      case 3:
        lamps.Kind = kinds[ParseChoice(option, value, { "linear", "inverse-square", "vtk" })];
        break;
      default:
        lamps.Attenuation = ParseThree(option, value);
    }
  }
  if (lamps.Attenuation && lamps.Kind != Falloff::VTK)
  {
    RefuseValue("--lamps attenuation", word, "falloff=vtk with it");
  }
  return lamps;
}
}
