// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Presets.h"

#include "Errors.h"
#include "NightSky.h"
#include "Numbers.h"
#include "OptionRows.h"
#include "Options.h"
#include "Settings.h"
#include "ShadowOptions.h"
#include "Values.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <vector>

namespace scene
{
namespace
{
struct Preset
{
  const char* Name;
  std::array<double, 3> Towards; // to the first light: right, up, and to the fitted camera
  Color Light;
  double Angle; // of the light's disc, degrees; negative: no shadow, and no ground
  Color Fill;
  std::vector<Color> Background; // bottom, top
  enum Hours
  {
    Always, // the background is paper
    Indoors,
    Outdoors
  };
  Hours Night; // how the background follows a low sun
};

const std::vector<Preset>& GetPresets()
{
  static const std::vector<Preset> presets = {
    // A large lamp at the left in front of a light wall.
    { "studio", { -0.65, 0.9, 0.6 }, { 0.30, 0.29, 0.275 }, 6.0, { 0.53, 0.54, 0.55 },
      { { 0.80, 0.82, 0.85 }, { 0.95, 0.96, 0.97 } }, Preset::Indoors },
    // An afternoon sun, and the sky, which is bluer.
    { "town", { -0.75, 0.6, 0.45 }, { 0.336, 0.299, 0.236 }, 0.53, { 0.520, 0.557, 0.614 },
      { { 0.86, 0.90, 0.94 }, { 0.45, 0.64, 0.87 } }, Preset::Outdoors },
    // On white paper, without shadows.
    { "print", { -0.4, 0.6, 1.0 }, { 0.29, 0.29, 0.29 }, -1.0, { 0.54, 0.54, 0.54 },
      { { 1.0, 1.0, 1.0 } }, Preset::Always },
  };
  return presets;
}

// Directions of the fill lights, the corners of a regular tetrahedron: as nine coefficients their
// light is the same on all sides, and VTK's own lights are nearly so.
constexpr std::array<double, 3> Fills[] = { { 1.0, 1.0, 1.0 }, { 1.0, -1.0, -1.0 },
  { -1.0, 1.0, -1.0 }, { -1.0, -1.0, 1.0 } };

// Samples of soft shadows and of antialiasing.
constexpr int Samples = 24;

// Maps per sun for soft shadows.
constexpr int SoftMaps = 8;

// Samples for volumes, which have no edges, cast soft-edged shadows, and take long to draw.
constexpr int SamplesOfVolumes = 4;

// Size of points in clouds, visible on a light background.
constexpr double PointSize = 4.0;

// The name of the light of preset nights in reports.
const char* const MoonName = "moon";

// From the upper right: shows three sides of a box.
constexpr std::array<double, 3> ThreeQuarter = { 0.5, 0.4, 1.0 };

LightChoice MakeSun(const std::array<double, 3>& towards, const Color& color, const char* name)
{
  LightChoice light;
  light.Is = LightChoice::Kind::Sun;
  light.Position = towards;
  light.InView = true;
  light.Color = color;
  light.Casts = false;
  light.Name = name;
  return light;
}

// Lights given by --light replace the first one, and the fill is weaker: a white surface in one of
// them is then not brighter than white.
constexpr double ShareOfOthers = 0.78;
constexpr double ShareOfFill = 0.4;

void AddSuns(RenderOptions& options, const Preset& preset, bool others)
{
  for (LightChoice& light : options.Lights)
  {
    light.Intensity *= ShareOfOthers;
  }
  if (!others)
  {
    LightChoice first = MakeSun(preset.Towards, preset.Light, "key light");
    first.Casts = preset.Angle >= 0.0;
    if (first.Casts)
    {
      first.Size = preset.Angle;
    }
    options.Lights.push_back(first);
  }
  options.Fill = options.Fill.value_or(others ? ShareOfFill : 1.0);
  if (*options.Fill == 0.0)
  {
    return;
  }
  for (const std::array<double, 3>& towards : Fills)
  {
    options.Lights.push_back(MakeSun(towards, preset.Fill, "fill"));
    options.Lights.back().Intensity = *options.Fill;
    options.Lights.back().Fills = true;
  }
}

// At night a weak bluish light from the preset's own direction shows shapes, and casts shadows.
void AddMoon(RenderOptions& options, const Preset& preset)
{
  const bool dark = !options.Lights.empty() &&
    std::all_of(options.Lights.begin(), options.Lights.end(),
      [](const LightChoice& light) { return light.IsNight(); });
  if (dark && preset.Night != Preset::Always)
  {
    LightChoice moon = MakeSun(preset.Towards, { 0.26, 0.32, 0.44 }, MoonName);
    moon.Casts = true;
    options.Lights.push_back(moon);
  }
}

// Applies if no option sets shadows; layers and verdicts use point lights.
void AddShadows(RenderOptions& options, int samples)
{
  const auto says = [&options](const char* option) { return options.Has(option); };
  if (says("--shadows"))
  {
    return;
  }
  const bool hard = says("--soft-shadows") || says("--certify") || says("--shadow-tolerance") ||
    says("--time-budget") || says("--layers");
  ShowShadows(options,
    hard ? NamedWords()
         : NamedWords{ { "soft_samples", std::to_string(samples) },
             { "soft_maps", std::to_string(SoftMaps) } });
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
const std::vector<PresetParameter>& GetPresetParameters()
{
  static const std::vector<PresetParameter> all = { { "antialias", "samples", "1" },
    { "shadows", "soft_samples", "" }, { "shadows", "soft_maps", "" } };
  return all;
}

//------------------------------------------------------------------------------
namespace
{
void TakePreset(RenderOptions& options, const std::string& word)
{
  ParseChoice("--preset", word, GetPresetNames());
  options.Preset = word;
}
}

//------------------------------------------------------------------------------
void DropIdleFill(Settings& settings)
{
  if (!settings.Has("--fill"))
  {
    return;
  }
  Settings without = settings;
  without.Remove("--fill");
  try
  {
    if (!without.Parse().Fill)
    {
      settings = without;
    }
  }
  catch (const std::exception&) // reported when the options are set
  {
  }
}

//------------------------------------------------------------------------------
std::string WriteKeyLight(const Settings& settings, int upAxis)
{
  const std::vector<LightChoice> lights = settings.Parse().Lights;
  if (lights.empty() || !lights.front().InView)
  {
    return "";
  }
  const LightChoice& key = lights.front();
  // Written as angles, which suit any up axis: a direction in world axes would light the next file
  // from below if another of its axes points up.
  const SunAngles angles = GetSunAngles(key.GetDirection(upAxis), upAxis);
  const auto number = [](double value) { return WriteNumber(value); };
  LightWords words = { "sun", WriteNumbers({ angles.Azimuth, angles.Elevation }), {} };
  words.Values.emplace_back(
    "color", number(key.Color[0]) + "/" + number(key.Color[1]) + "/" + number(key.Color[2]));
  words.Values.emplace_back(
    key.Casts ? "size" : "casts", key.Casts ? number(key.Size.value_or(0.0)) : "off");
  words.Values.emplace_back("name", key.Name);
  return WriteLight(words);
}

//------------------------------------------------------------------------------
void OwnKeyLight(Settings& settings, int upAxis)
{
  std::vector<std::string> lights = settings.GetAll("--light");
  Settings without = settings;
  without.Remove("--light");
  const std::string key = WriteKeyLight(without, upAxis);
  if (key.empty())
  {
    return;
  }
  LightWords words = SplitLight(key);
  if (lights.empty())
  {
    words.Values.emplace_back("intensity", WriteNumber(1.0 / ShareOfOthers));
    settings.Set("--fill", WriteNumber(without.Parse().Fill.value_or(1.0)));
  }
  lights.push_back(WriteLight(words));
  settings.SetAll("--light", lights);
}

//------------------------------------------------------------------------------
bool HasMoon(const Settings& settings)
{
  const std::vector<LightChoice> lights = settings.Parse().Lights;
  const std::size_t own = std::min(settings.GetAll("--light").size(), lights.size());
  return std::any_of(lights.begin() + static_cast<std::ptrdiff_t>(own), lights.end(),
    [](const LightChoice& light) { return light.Name == MoonName; });
}

//------------------------------------------------------------------------------
void ApplyPreset(RenderOptions& options)
{
  if (!options.Has("--preset"))
  {
    const char* usual = std::getenv("RELIEVO_PRESET");
    options.Preset = usual && *usual ? usual : GetPresets().front().Name;
    ParseChoice("the environment variable RELIEVO_PRESET", options.Preset, GetPresetNames());
    options.YieldsToFile = !options.Has("--light");
  }
  const auto preset = std::find_if(GetPresets().begin(), GetPresets().end(),
    [&options](const Preset& each) { return options.Preset == each.Name; });
  // An environment is the only light, unless a preset was requested as well.
  const bool lights =
    preset != GetPresets().end() && (!options.Has("--environment") || options.Has("--preset"));
  if (options.Has("--fill") && !lights)
  {
    throw UsageError(preset == GetPresets().end()
        ? "--fill: the preset none has no fill lights: give --preset NAME as well"
        : "--fill: the environment is the only light: give --preset NAME as well");
  }
  if (preset == GetPresets().end())
  {
    return;
  }
  if (!options.Has("--background"))
  {
    const std::optional<double> elevation = FindSunElevation(options.Lights);
    options.Look.Background = elevation && preset->Night != Preset::Always
      ? DarkenSky(preset->Background, preset->Night == Preset::Outdoors, *elevation)
      : preset->Background;
  }
  if (!options.Has("--image") && !options.Has("--color-by") && !options.Has("--scalar-bar") &&
    !options.Has("--bar"))
  {
    options.Image.Is = ImageChoice::Kind::Found;
  }
  if (!options.Has("--point-size"))
  {
    options.Look.PointSize = PointSize;
  }
  options.View.From = ThreeQuarter;
  options.FindsUp = !options.Has("--up");
  const int samples = options.Image.Is == ImageChoice::Kind::Volume ? SamplesOfVolumes : Samples;
  const auto smooths = [](const StageChoice& stage) { return stage.Name == "antialias"; };
  if (std::none_of(options.Stages.begin(), options.Stages.end(), smooths))
  {
    AddStage(options.Stages, "antialias", "--preset")
      .Parameters.emplace_back("samples", std::to_string(samples));
  }
  if (lights)
  {
    options.Look.IsReadable = options.ShadingKind != Shading::PBR;
    AddMoon(options, *preset);
    AddSuns(options, *preset, options.Has("--light"));
    if (preset->Angle >= 0.0)
    {
      AddShadows(options, samples);
      options.Ground = options.Ground.value_or(true);
    }
  }
}

//------------------------------------------------------------------------------
void AddPresetOption(OptionRows& rows, RenderOptions& all)
{
  rows
    .Add("--preset", "NAME",
      "studio, town or print: lights, shadows, ground, background and a view from the "
      "upper right, unless other options set them; none: VTK's headlight on black (the "
      "environment variable RELIEVO_PRESET, or else studio)",
      all, TakePreset)
    .NamedIn("Scene", "Preset")
    .Words = GetPresetNames();
}

//------------------------------------------------------------------------------
void AddFillOption(OptionRows& rows, RenderOptions& all)
{
  rows
    .AddNumber("--fill", "F",
      "strength of a preset's fill lights, which light the areas that its first light, or "
      "--light, leaves dark, @bounds@ (1; 0.4 with --light)",
      { 0.0, 1.0 }, all.Fill)
    .NamedIn("Light", "Fill");
}
}
