// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunOptions.h"

#include "Arguments.h"
#include "Errors.h"
#include "MeshNames.h"
#include "Values.h"

#include "vtkRelievoSunExposure.h"

#include <cmath>
#include <regex>

namespace cli
{
namespace
{
void TakePlace(SunOptions& options, const std::string& value)
{
  const std::vector<double> place = scene::ParseNumbers("--place", value, 2, "LATITUDE,LONGITUDE");
  if (std::abs(place[0]) > 90. || std::abs(place[1]) > 180.)
  {
    scene::RefuseValue("--place", value, "a latitude from -90 to 90, a longitude from -180 to 180");
  }
  options.Latitude = place[0];
  options.Longitude = place[1];
}

void TakeDates(SunOptions& options, const std::string& value)
{
  static const std::regex form("([0-9]{4})-([0-9]{2})-([0-9]{2})");
  const std::vector<std::string> parts = scene::Split(value, ':');
  for (std::size_t i = 0; i < 2; ++i)
  {
    const std::string& day = parts[i < parts.size() ? i : 0];
    std::smatch numbers;
    if (parts.size() > 3 || !std::regex_match(day, numbers, form))
    {
      scene::RefuseValue(
        "--dates", value, "FIRST[:LAST[:EVERY]], such as 2026-06-21 or 2026-01-01:2026-12-31:7");
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      options.Days[i][k] = std::stoi(numbers[k + 1].str());
    }
  }
  const std::string wrong =
    vtkRelievoSunExposure::CheckDays(options.Days[0].data(), options.Days[1].data());
  if (!wrong.empty())
  {
    throw scene::UsageError("--dates " + value + ": " + wrong);
  }
  if (parts.size() == 3)
  {
    options.DayStep = scene::ParseWhole("--dates " + value, parts[2], 1, 366);
  }
}
}

//------------------------------------------------------------------------------
SunOptions ParseSun(const std::vector<std::string>& words)
{
  SunOptions options;
  bool place = false;
  bool dates = false;
  scene::ParseArguments(
    words, "sun",
    { { "-o", false }, { "--allow-folder", false }, { "--place", false }, { "--dates", false },
      { "--step", false }, { "--up", false }, { "--points", true }, { "--sky", false } },
    [&](const std::string& name, const std::string& value) {
      if (name == "-o")
      {
        options.File = value;
      }
      else if (name == "--allow-folder")
      {
        options.AllowedFolders.push_back(value);
      }
      else if (name == "--place")
      {
        TakePlace(options, value);
        place = true;
      }
      else if (name == "--dates")
      {
        TakeDates(options, value);
        dates = true;
      }
      else if (name == "--step")
      {
        options.Step = scene::ParseNumberFrom(name, value, 0.1, 240.);
      }
      else if (name == "--up")
      {
        options.Up = static_cast<int>(scene::ParseChoice(name, value, { "x", "y", "z" }));
      }
      else if (name == "--points")
      {
        options.Points = true;
      }
      else
      {
        options.Sky = scene::ParseWhole(name, value, 0, 65536);
      }
    },
    [&](const std::string& word) { options.Files.push_back(word); });
  CheckMeshFiles("sun", options.Files, options.File);
  if (!place)
  {
    throw scene::UsageError("sun: no place; give --place LATITUDE,LONGITUDE");
  }
  if (!dates)
  {
    throw scene::UsageError("sun: no dates; give --dates FIRST[:LAST[:EVERY]]");
  }
  return options;
}
}
