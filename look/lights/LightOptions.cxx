// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightOptions.h"

#include "FittedView.h"
#include "LookOptions.h"
#include "Triples.h"

#include <algorithm>
#include <cmath>

namespace look
{
namespace
{
void TakeSun(LightChoice& light, const std::string& numbers)
{
  if (IsSunTime(numbers))
  {
    light.Time = ParseSunTime("--light sun", numbers);
    return;
  }
  if (std::count(numbers.begin(), numbers.end(), ',') == 1)
  {
    const std::vector<double> angles = ParseNumbers("--light sun", numbers, 2, "AZIMUTH,ELEVATION");
    light.Angles = { angles[0], angles[1] };
    if (std::abs(light.Angles->Elevation) > 90.0)
    {
      RefuseValue("--light sun", numbers, "an elevation from -90 to 90 degrees");
    }
    return;
  }
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
}

//------------------------------------------------------------------------------
void TakePoint(LightChoice& light, const std::string& numbers)
{
  light.Position = Triple(ParseNumbers("--light point", numbers, 3, "PX,PY,PZ"), 0);
}

//------------------------------------------------------------------------------
void TakeSpot(LightChoice& light, const std::string& numbers)
{
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
}

//------------------------------------------------------------------------------
double ParseNotNegative(const std::string& option, const std::string& word, const std::string& form)
{
  const double number = ParseNumbers(option, word, 1, form).front();
  if (number < 0.0)
  {
    RefuseValue(option, word, "0 or more");
  }
  return number;
}

//------------------------------------------------------------------------------
void TakeSize(LightChoice& light, const std::string& word)
{
  light.Size = ParseNotNegative("--light size", word, "S");
  if (light.Is == LightChoice::Kind::Sun && *light.Size > 90.0)
  {
    RefuseValue("--light size", word, "a sun's angle in degrees, 0 to 90");
  }
}

//------------------------------------------------------------------------------
// Parameters after the numbers.
struct LightValue
{
  const char* Form;
  const char* Help;
  void (*Take)(LightChoice& light, const std::string& word);

  std::string GetName() const { return Split(this->Form, '=').front(); }
};

const std::vector<LightValue>& GetValues()
{
  static const std::vector<LightValue> values = {
    { "size=S",
      "for --soft-shadows: a sun's angular diameter in degrees (0.53), or the radius of "
      "another light in world units (0)",
      TakeSize },
    { "color=COLOR", "R/G/B from 0 to 1, #rrggbb, or a name such as orange (white)",
      [](LightChoice& light, const std::string& word) {
        light.Color = ParseColor("--light color", word);
      } },
    { "intensity=I", "factor of the colour, 0 or more (1, which means 0.8 with a preset)",
      [](LightChoice& light, const std::string& word) {
        light.Intensity = ParseNotNegative("--light intensity", word, "I");
      } },
    { "casts=on|off", "whether it casts shadows, if shadows are on (on)",
      [](LightChoice& light, const std::string& word) {
        light.Casts = ParseChoice("--light casts", word, { "off", "on" }) == 1;
      } },
    { "name=TEXT", "its name in reports and files (its number)",
      [](LightChoice& light, const std::string& word) {
        if (word.empty())
        {
          RefuseValue("--light name", word, "a text");
        }
        light.Name = word;
      } },
  };
  return values;
}
}

//------------------------------------------------------------------------------
LightWords SplitLight(const std::string& word)
{
  const std::string::size_type colon = word.find(':');
  if (colon == std::string::npos)
  {
    RefuseValue("--light", word,
      "sun:DX,DY,DZ or sun:AZIMUTH,ELEVATION or spot:PX,PY,PZ,FX,FY,FZ,CONE or point:PX,PY,PZ");
  }
  const std::vector<std::string> parts = SplitEscaped(word.substr(colon + 1), ',');
  const auto named = std::find_if(parts.begin(), parts.end(),
    [](const std::string& part) { return part.find('=') != std::string::npos; });
  return { word.substr(0, colon), Join({ parts.begin(), named }, ","),
    ParseNamedWords("--light " + word, { named, parts.end() }, "NAME=VALUE after the numbers") };
}

//------------------------------------------------------------------------------
std::string WriteLight(const LightWords& words)
{
  return words.Kind + ":" + words.Numbers +
    (words.Values.empty() ? "" : "," + WriteNamedWords(words.Values));
}

//------------------------------------------------------------------------------
LightChoice ParseLight(const std::string& word)
{
  const LightWords words = SplitLight(word);
  constexpr void (*takers[])(LightChoice&, const std::string&) = { TakeSun, TakeSpot, TakePoint };
  LightChoice light;
  light.Is = static_cast<LightChoice::Kind>(
    ParseChoice("--light " + word, words.Kind, { "sun", "spot", "point" }));
  takers[static_cast<int>(light.Is)](light, words.Numbers);
  for (const auto& [name, value] : words.Values)
  {
    const auto known = std::find_if(GetValues().begin(), GetValues().end(),
      [name = name](const LightValue& each) { return each.GetName() == name; });
    if (known == GetValues().end())
    {
      std::vector<std::string> names;
      for (const LightValue& each : GetValues())
      {
        names.push_back(each.GetName());
      }
      RefuseValue("--light " + word, name, "one of " + Join(names, ", "));
    }
    known->Take(light, value);
  }
  return light;
}

//------------------------------------------------------------------------------
std::array<double, 3> LightChoice::GetDirection(int upAxis) const
{
  return this->Time ? GetSunDirection(GetSunAngles(*this->Time), upAxis)
    : this->Angles  ? GetSunDirection(*this->Angles, upAxis)
    : this->InView  ? FittedView(upAxis).ToWorld(this->Position)
                    : this->Position;
}

//------------------------------------------------------------------------------
std::string DescribeLights()
{
  std::string text =
    "may be repeated (with --preset NAME, the preset's lights; else the file's, else the "
    "environment alone, else the default preset's; with --preset none, a headlight instead of "
    "a preset's lights); LIGHT is\n"
    "  sun:DX,DY,DZ                    direction towards the sun\n"
    "  sun:AZIMUTH,ELEVATION           degrees: clockwise from north, height\n"
    "  sun:TIME,LATITUDE,LONGITUDE     TIME such as 2026-06-21T15:30+02:00\n"
    "  spot:PX,PY,PZ,FX,FY,FZ,CONE     CONE: half the opening, degrees\n"
    "  point:PX,PY,PZ\n"
    "and may end with ,NAME=VALUE... A sun by TIME gives no light below the horizon. Values are";
  for (const LightValue& value : GetValues())
  {
    text += std::string("\n  ") + value.Form + "  " + value.Help;
  }
  return text;
}
}
