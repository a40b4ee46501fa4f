// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Presets.h"

#include "Options.h"
#include "Triples.h"
#include "Values.h"

#include <algorithm>
#include <vector>

namespace scene
{
namespace
{
struct Sun
{
  std::array<double, 3> Towards; // right, up, and to the fitted camera
  Color Light;
  bool Casts;
};

struct Preset
{
  const char* Name;
  std::vector<Sun> Suns;
  bool Shadows;
  std::vector<Color> Background; // bottom, top
};

const std::vector<Preset>& GetPresets()
{
  static const std::vector<Preset> presets = {
    // A large lamp at the left, a weak one at the right, before a light wall.
    { "studio",
      { { { -0.6, 0.8, 0.7 }, { 0.85, 0.85, 0.85 }, true },
        { { 0.9, 0.2, 0.5 }, { 0.4, 0.4, 0.4 }, false } },
      true, { { 0.82, 0.84, 0.87 }, { 0.97, 0.97, 0.98 } } },
    // A sun in the afternoon, and the sky's light from above and from the side, which is bluer.
    { "town",
      { { { -0.75, 0.6, 0.45 }, { 1.0, 0.93, 0.80 }, true },
        { { 0.1, 1.0, 0.1 }, { 0.22, 0.26, 0.33 }, false },
        { { 0.8, 0.2, 0.6 }, { 0.15, 0.17, 0.22 }, false } },
      true, { { 0.86, 0.90, 0.94 }, { 0.45, 0.64, 0.87 } } },
    // On white paper, without shadows.
    { "print", { { { -0.4, 0.6, 1.0 }, { 0.9, 0.9, 0.9 }, false } }, false, { { 1.0, 1.0, 1.0 } } },
  };
  return presets;
}

//------------------------------------------------------------------------------
// To world coordinates, as the fitted camera stands.
std::array<double, 3> Turn(const std::array<double, 3>& towards, int upAxis)
{
  const auto& [right, up, near] = towards;
  std::array<double, 3> world = { right, up, near };
  if (upAxis == 0)
  {
    world = { up, -right, near };
  }
  else if (upAxis == 2)
  {
    world = { right, -near, up };
  }
  const double length = Length(world);
  for (double& component : world)
  {
    component /= length;
  }
  return world;
}
}

//------------------------------------------------------------------------------
void TakePreset(RenderOptions& options, const std::string& word)
{
  std::vector<std::string> names;
  for (const Preset& preset : GetPresets())
  {
    names.emplace_back(preset.Name);
  }
  ParseChoice("--preset", word, names);
  options.Preset = word;
}

//------------------------------------------------------------------------------
void ApplyPreset(RenderOptions& options, const std::set<std::string>& given)
{
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
  if (given.count("--light") > 0)
  {
    return; // whose shadows are as asked
  }
  for (const Sun& sun : preset->Suns)
  {
    LightChoice light;
    light.Is = LightChoice::Kind::Sun;
    light.Position = Turn(sun.Towards, options.UpAxis);
    light.Color = sun.Light;
    light.Casts = sun.Casts;
    options.Lights.push_back(light);
  }
  if (preset->Shadows && given.count("--shadows") == 0)
  {
    options.ShadowMethod = Shadows::Map;
  }
}
}
