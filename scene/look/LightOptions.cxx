// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightOptions.h"

#include "Triples.h"
#include "Values.h"

namespace scene
{
namespace
{
LightChoice ParseSun(const std::string& numbers)
{
  LightChoice light;
  light.Is = LightChoice::Kind::Sun;
  light.Position = Triple(ParseNumbers("--light sun", numbers, 3, "DX,DY,DZ"), 0);
  const double length = Length(light.Position);
  if (length == 0.0)
  {
    RefuseValue("--light sun", numbers, "a direction towards the sun, which 0,0,0 is not");
  }
  for (double& component : light.Position)
  {
    component /= length;
  }
  return light;
}

//------------------------------------------------------------------------------
LightChoice ParsePoint(const std::string& numbers)
{
  LightChoice light;
  light.Is = LightChoice::Kind::Point;
  light.Position = Triple(ParseNumbers("--light point", numbers, 3, "PX,PY,PZ"), 0);
  return light;
}

//------------------------------------------------------------------------------
// What of the numbers comes before ",size=S"; S.
std::string TakeSize(const std::string& numbers, std::optional<double>& size)
{
  const std::string key = ",size=";
  const std::string::size_type at = numbers.find(key);
  if (at == std::string::npos)
  {
    return numbers;
  }
  const std::string word = numbers.substr(at + key.size());
  size = ParseNumbers("--light size", word, 1, "S").front();
  if (*size < 0.0)
  {
    RefuseValue("--light size", word, "0 or more");
  }
  return numbers.substr(0, at);
}

//------------------------------------------------------------------------------
LightChoice ParseSpot(const std::string& numbers)
{
  LightChoice light;
  light.Is = LightChoice::Kind::Spot;
  const std::vector<double> n = ParseNumbers("--light spot", numbers, 7, "PX,PY,PZ,FX,FY,FZ,CONE");
  light.Position = Triple(n, 0);
  light.FocalPoint = Triple(n, 3);
  light.ConeAngle = n[6];
  if (Length(Minus(light.FocalPoint, light.Position)) == 0.0)
  {
    RefuseValue("--light spot", numbers, "a focal point FX,FY,FZ apart from PX,PY,PZ");
  }
  if (light.ConeAngle <= 0.0 || light.ConeAngle > 180.0)
  {
    RefuseValue(
      "--light spot", numbers, "CONE, half the opening in degrees, above 0 and not above 180");
  }
  return light;
}
}

//------------------------------------------------------------------------------
LightChoice ParseLight(const std::string& word)
{
  const std::string::size_type colon = word.find(':');
  if (colon == std::string::npos)
  {
    RefuseValue("--light", word, "sun:DX,DY,DZ or spot:PX,PY,PZ,FX,FY,FZ,CONE or point:PX,PY,PZ");
  }
  const std::string kind = word.substr(0, colon);
  std::optional<double> size;
  const std::string numbers = TakeSize(word.substr(colon + 1), size);
  constexpr LightChoice (*parsers[])(const std::string&) = { ParseSun, ParseSpot, ParsePoint };
  LightChoice light =
    parsers[ParseChoice("--light " + word, kind, { "sun", "spot", "point" })](numbers);
  if (light.Is == LightChoice::Kind::Sun && size && *size > 90.0)
  {
    RefuseValue("--light size", word, "a sun's angle in degrees, 0 to 90");
  }
  light.Size = size;
  return light;
}
}
