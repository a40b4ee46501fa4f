// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceOptions.h"

#include "Errors.h"
#include "Options.h"
#include "Values.h"

#include <algorithm>
#include <limits>

namespace scene
{
namespace
{
// "F" or "F,NUMBER". A file's name may hold commas: only a number behind the last one is one.
std::string TakeNumberBehind(std::string& path)
{
  const std::string::size_type comma = path.rfind(',');
  if (comma == std::string::npos ||
    path.find_first_not_of("0123456789.eE+-", comma + 1) != std::string::npos)
  {
    return "";
  }
  std::string number = path.substr(comma + 1);
  path.erase(comma);
  return number;
}
}

//------------------------------------------------------------------------------
void TakeHeightMap(RenderOptions& options, const std::string& word)
{
  options.HeightMap = word;
  const std::string scale = TakeNumberBehind(options.HeightMap);
  if (options.HeightMap != word)
  {
    options.HeightScale = ParseNumberBetween(
      "--height-map " + word, scale, 0.0, std::numeric_limits<double>::infinity());
  }
}

//------------------------------------------------------------------------------
void TakeRelief(RenderOptions& options, const std::string& word)
{
  constexpr Relief methods[] = { Relief::Off, Relief::Parallax, Relief::Steep, Relief::Occlusion,
    Relief::Relief };
  options.ReliefMethod =
    methods[ParseChoice("--relief", word, { "off", "parallax", "steep", "occlusion", "relief" })];
}

//------------------------------------------------------------------------------
void TakeTextureCoordinates(RenderOptions& options, const std::string& word)
{
  constexpr Mapping methods[] = { Mapping::Box, Mapping::Plane, Mapping::Sphere };
  options.TextureMapping =
    methods[ParseChoice("--texture-coordinates", word, { "box", "plane", "sphere" })];
}

//------------------------------------------------------------------------------
void TakeEnvironment(RenderOptions& options, const std::string& word)
{
  options.Environment = word;
  const std::string degrees = TakeNumberBehind(options.Environment);
  if (options.Environment != word)
  {
    options.EnvironmentRotation =
      ParseNumbers("--environment " + word, degrees, 1, "degrees of rotation")[0];
  }
}

//------------------------------------------------------------------------------
void TakeReflectivity(RenderOptions& options, const std::string& word)
{
  const bool both = word.find(',') != std::string::npos;
  const std::vector<double> n =
    ParseNumbers("--reflectivity", word, both ? 2 : 1, both ? "R,ROUGHNESS" : "R");
  if (std::any_of(n.begin(), n.end(), [](double share) { return share < 0.0 || share > 1.0; }))
  {
    RefuseValue("--reflectivity", word, "R[,ROUGHNESS], both from 0 to 1");
  }
  options.Reflectivity = n[0];
  options.Roughness = both ? n[1] : options.Roughness;
}

//------------------------------------------------------------------------------
void TakeUp(RenderOptions& options, const std::string& word)
{
  options.UpAxis = static_cast<int>(ParseChoice("--up", word, { "x", "y", "z" }));
}

//------------------------------------------------------------------------------
void CheckSurfaceOptions(const RenderOptions& options, const std::set<std::string>& given)
{
  if (given.count("--relief") && options.HeightMap.empty())
  {
    throw UsageError("--relief: there are no heights: give --height-map F as well");
  }
  if (given.count("--texture-coordinates") && options.NormalMap.empty() &&
    options.HeightMap.empty())
  {
    throw UsageError(
      "--texture-coordinates: there is nothing to place by them: give --normal-map F "
      "or --height-map F as well");
  }
  for (const char* option : { "--skybox", "--reflectivity" })
  {
    if (given.count(option) && options.Environment.empty())
    {
      throw UsageError(std::string(option) +
        (options.Skybox ? ": there is no environment to show" : ": there is nothing to mirror") +
        ": give --environment F as well");
    }
  }
}
}
