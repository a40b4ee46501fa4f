// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Presets.h"

#include "Options.h"
#include "Values.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace scene
{
namespace
{
struct Sun
{
  std::array<double, 3> Towards; // right, up, and to the fitted camera
  Color Light;
  double Angle = -1.0; // of its disc, degrees; below 0: it casts no shadow
};

struct Preset
{
  const char* Name;
  std::vector<Sun> Suns;
  std::vector<Color> Background; // bottom, top
  bool Ground;                   // and shadows on it
};

const std::vector<Preset>& GetPresets()
{
  // Wherever the camera goes, no side is black: the weak suns fill what the first one leaves.
  static const std::vector<Preset> presets = {
    // A large lamp at the left before a light wall, which gives light back.
    { "studio",
      { { { -0.65, 0.9, 0.6 }, { 0.80, 0.79, 0.77 }, 6.0 },
        { { 0.9, 0.35, 0.7 }, { 0.32, 0.33, 0.35 } },
        { { 0.1, 0.5, -1.0 }, { 0.26, 0.27, 0.29 } },
        { { -0.2, -1.0, 0.1 }, { 0.20, 0.19, 0.18 } } },
      { { 0.80, 0.82, 0.85 }, { 0.95, 0.96, 0.97 } }, true },
    // A sun in the afternoon, and the sky's light from above and from the sides, which is bluer.
    { "town",
      { { { -0.75, 0.6, 0.45 }, { 0.85, 0.78, 0.66 }, 0.53 },
        { { 0.1, 1.0, 0.1 }, { 0.25, 0.28, 0.33 } },
        { { 0.8, 0.2, 0.6 }, { 0.28, 0.31, 0.37 } },
        { { 0.0, 0.2, -1.0 }, { 0.22, 0.24, 0.29 } } },
      { { 0.86, 0.90, 0.94 }, { 0.45, 0.64, 0.87 } }, true },
    // On white paper, without shadows.
    { "print",
      { { { -0.4, 0.6, 1.0 }, { 0.75, 0.75, 0.75 } }, { { 0.9, 0.2, 0.4 }, { 0.2, 0.2, 0.2 } },
        { { 0.0, 0.3, -1.0 }, { 0.3, 0.3, 0.3 } } },
      { { 1.0, 1.0, 1.0 } }, false },
  };
  return presets;
}

// Of soft shadows and of smooth edges.
constexpr int Samples = 24;

// From the upper right, so that three sides of a box are seen.
constexpr std::array<double, 3> ThreeQuarter = { 0.5, 0.4, 1.0 };

// All of them; where others were asked for, those that fill, at half their strength.
void AddSuns(RenderOptions& options, const Preset& preset, bool others)
{
  for (const Sun& sun : preset.Suns)
  {
    LightChoice light;
    light.Is = LightChoice::Kind::Sun;
    light.Position = sun.Towards;
    light.InView = true;
    light.Color = sun.Light;
    light.Casts = sun.Angle >= 0.0;
    if (light.Casts)
    {
      light.Size = sun.Angle;
    }
    if (others)
    {
      std::for_each(light.Color.begin(), light.Color.end(), [](double& part) { part *= 0.5; });
    }
    if (!others || !light.Casts)
    {
      options.Lights.push_back(light);
    }
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
    TakePreset(options, usual && *usual ? usual : GetPresets().front().Name);
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
    if (preset->Ground)
    {
      AddShadows(options, given);
      options.Ground = options.Ground.value_or(true);
    }
  }
}
}
