// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSettings.h"

#include "Numbers.h"
#include "Options.h"
#include "Settings.h"

#include <algorithm>
#include <iterator>

namespace scene
{
namespace
{
void SetMaterial(Settings& settings, const NamedWords& values)
{
  values.empty() ? settings.Remove("--material")
                 : settings.Set("--material", WriteNamedWords(values));
}

void SetEnvironment(
  Settings& settings, const std::string& file, double rotation, const NamedWords& values)
{
  settings.Set("--environment",
    WriteFileAndNumber(file, rotation) + (values.empty() ? "" : "," + WriteNamedWords(values)));
}
}

//------------------------------------------------------------------------------
void SetSurfaceValue(Settings& settings, const std::string& name, const std::string& words)
{
  SurfaceChoice surface = settings.Parse().Surface;
  if (GetMaterialValues().Find(name))
  {
    SetWords(surface.Material, name, words);
    SetMaterial(settings, surface.Material);
    return;
  }
  SetWords(surface.EnvironmentValues, name, words);
  SetEnvironment(
    settings, surface.Environment, surface.EnvironmentRotation, surface.EnvironmentValues);
}

//------------------------------------------------------------------------------
void SetEnvironmentFile(Settings& settings, const std::string& file, double rotation)
{
  if (file.empty())
  {
    settings.Remove("--environment");
    return;
  }
  SurfaceChoice before;
  TakeEnvironment(before, settings.Get("--environment"));
  SetEnvironment(settings, file, rotation, before.EnvironmentValues);
}

//------------------------------------------------------------------------------
void DropIdleSurface(Settings& settings)
{
  SurfaceChoice surface;
  surface.NormalMap = settings.Get("--normal-map");
  surface.HeightMap = settings.Get("--height-map");
  surface.Environment = settings.Get("--environment");
  const auto dropUnless = [&settings](bool needed, const char* option) {
    needed ? void() : settings.Remove(option);
  };
  dropUnless(!surface.HeightMap.empty(), "--relief");
  dropUnless(surface.IsMapped(), "--texture-coordinates");
  dropUnless(!surface.Environment.empty(), "--reflectivity");
  dropUnless(!surface.Environment.empty(), "--skybox");
  if (settings.Has("--relief"))
  {
    surface.ReliefMethod = settings.Get("--relief");
  }
  if (settings.Has("--material"))
  {
    TakeMaterial(surface, settings.Get("--material"));
    NamedWords kept;
    std::copy_if(surface.Material.begin(), surface.Material.end(), std::back_inserter(kept),
      [&surface](const auto& given) {
        return !FindFailing(surface, *GetMaterialValues().Find(given.first));
      });
    SetMaterial(settings, kept);
  }
}
}
