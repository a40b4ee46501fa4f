// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Presets.h"

#include "Options.h"
#include "Values.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <vector>

namespace scene
{
namespace
{
struct Preset
{
  const char* Name;
  std::array<double, 3> Towards; // the first light: right, up, and to the fitted camera
  Color Light;
  double Angle; // of its disc, degrees; below 0: it casts no shadow, and there is no ground
  Color Fill;
  std::vector<Color> Background; // bottom, top
};

const std::vector<Preset>& GetPresets()
{
  static const std::vector<Preset> presets = {
    // A large lamp at the left before a light wall.
    { "studio", { -0.65, 0.9, 0.6 }, { 0.66, 0.65, 0.63 }, 6.0, { 0.30, 0.31, 0.33 },
      { { 0.80, 0.82, 0.85 }, { 0.95, 0.96, 0.97 } } },
    // A sun in the afternoon, and the sky, which is bluer.
    { "town", { -0.75, 0.6, 0.45 }, { 0.76, 0.68, 0.54 }, 0.53, { 0.27, 0.30, 0.36 },
      { { 0.86, 0.90, 0.94 }, { 0.45, 0.64, 0.87 } } },
    // On white paper, without shadows.
    { "print", { -0.4, 0.6, 1.0 }, { 0.65, 0.65, 0.65 }, -1.0, { 0.32, 0.32, 0.32 },
      { { 1.0, 1.0, 1.0 } } },
  };
  return presets;
}

// From where weak suns fill what the first light leaves, so that wherever the camera goes no side
// is black, in shadows neither: a fifth of the light at least is there. The last one is weaker.
constexpr std::array<double, 3> Fills[] = { { 1.0, 0.2, 0.3 }, { -0.5, 0.2, -1.0 },
  { 0.0, -1.0, 0.1 }, { -0.6, 0.6, 0.8 } };
constexpr double LastFill = 0.8;

// Of soft shadows and of smooth edges.
constexpr int Samples = 24;

// Of clouds, so that they are seen on a light background.
constexpr double PointSize = 4.0;

// From the upper right, so that three sides of a box are seen.
constexpr std::array<double, 3> ThreeQuarter = { 0.5, 0.4, 1.0 };

LightChoice MakeSun(const std::array<double, 3>& towards, const Color& color, double strength)
{
  LightChoice light;
  light.Is = LightChoice::Kind::Sun;
  light.Position = towards;
  light.InView = true;
  light.Color = { strength * color[0], strength * color[1], strength * color[2] };
  light.Casts = false;
  return light;
}

// Where lights were asked for, they are in the place of the first one, and the fill is weaker: with
// it, a white surface in one of them is not brighter than white.
constexpr double ShareOfOthers = 0.8;
constexpr double ShareOfFill = 0.4;

void AddSuns(RenderOptions& options, const Preset& preset, bool others)
{
  for (LightChoice& light : options.Lights)
  {
    std::for_each(
      light.Color.begin(), light.Color.end(), [](double& part) { part *= ShareOfOthers; });
  }
  if (!others)
  {
    LightChoice first = MakeSun(preset.Towards, preset.Light, 1.0);
    first.Casts = preset.Angle >= 0.0;
    if (first.Casts)
    {
      first.Size = preset.Angle;
    }
    options.Lights.push_back(first);
  }
  for (const std::array<double, 3>& towards : Fills)
  {
    const double strength = &towards == std::end(Fills) - 1 ? LastFill : 1.0;
    options.Lights.push_back(
      MakeSun(towards, preset.Fill, others ? ShareOfFill * strength : strength));
  }
}

// Where nothing is said of shadows; layers and verdicts are those of lights that are points.
void AddShadows(RenderOptions& options, const std::set<std::string>& given)
{
  if (given.count("--shadows") == 0)
  {
    options.ShadowMethod = Shadows::Map;
    const auto says = [&given](const char* option) { return given.count(option) > 0; };
    if (!says("--soft-shadows") && !says("--certify") && !says("--shadow-tolerance") &&
      !says("--time-budget") && !says("--layers"))
    {
      options.SoftShadows = Samples;
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetPresetNames()
{
  std::vector<std::string> names = { "none" };
  for (const Preset& preset : GetPresets())
  {
    names.emplace_back(preset.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
void TakePreset(RenderOptions& options, const std::string& word)
{
  ParseChoice("--preset", word, GetPresetNames());
  options.Preset = word;
}

//------------------------------------------------------------------------------
void ApplyPreset(RenderOptions& options, const std::set<std::string>& given)
{
  if (given.count("--preset") == 0)
  {
    const char* usual = std::getenv("RELIEVO_PRESET");
    options.Preset = usual && *usual ? usual : GetPresets().front().Name;
    ParseChoice("the environment variable RELIEVO_PRESET", options.Preset, GetPresetNames());
    options.YieldsToFile = given.count("--light") == 0;
  }
  const auto preset = std::find_if(GetPresets().begin(), GetPresets().end(),
    [&options](const Preset& each) { return options.Preset == each.Name; });
  if (preset == GetPresets().end())
  {
    return;
  }
  if (given.count("--background") == 0)
  {
    options.Look.Background = preset->Background;
  }
  if (given.count("--image") + given.count("--color-by") + given.count("--scalar-bar") == 0)
  {
    options.Image.Is = ImageChoice::Kind::Found;
  }
  if (given.count("--point-size") == 0)
  {
    options.Look.PointSize = PointSize;
  }
  options.ViewFrom = ThreeQuarter;
  options.FindsUp = given.count("--up") == 0;
  const auto smooths = [](const StageChoice& stage) { return stage.Name == "antialias"; };
  if (std::none_of(options.Stages.begin(), options.Stages.end(), smooths))
  {
    AddStage(options.Stages, "antialias", "--preset")
      .Parameters.emplace_back("samples", std::to_string(Samples));
  }
  // An environment lights alone, unless the preset was asked for as well.
  if (given.count("--environment") == 0 || given.count("--preset") > 0)
  {
    AddSuns(options, *preset, given.count("--light") > 0);
    if (preset->Angle >= 0.0)
    {
      AddShadows(options, given);
      options.Ground = options.Ground.value_or(true);
    }
  }
}
}
