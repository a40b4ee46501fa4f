// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TypedZones.h"

#include <algorithm>
#include <vector>

namespace viewer
{
//------------------------------------------------------------------------------
bool HasTypedZone(const scene::Settings& settings, const std::string& light)
{
  const std::vector<std::string> typed = settings.GetAll(TypedZones);
  return std::find(typed.begin(), typed.end(), light) != typed.end();
}

//------------------------------------------------------------------------------
void DropIdleZones(scene::Settings& settings)
{
  const std::vector<std::string> lights = settings.GetAll("--light");
  std::vector<std::string> kept = settings.GetAll(TypedZones);
  kept.erase(std::remove_if(kept.begin(), kept.end(),
               [&lights](const std::string& each) {
                 return std::find(lights.begin(), lights.end(), each) == lights.end();
               }),
    kept.end());
  settings.SetAll(TypedZones, kept);
}
}
