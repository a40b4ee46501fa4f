// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "NextFile.h"

#include "Colormaps.h"
#include "LightOptions.h"
#include "Options.h"
#include "PointOptions.h"
#include "Presets.h"
#include "SurfaceSettings.h"

#include <QStringList>

#include <algorithm>

namespace viewer
{
namespace
{
// Suns suit any scene.
int DropPlacedLights(scene::Settings& settings)
{
  std::vector<std::string> lights = settings.GetAll("--light");
  const auto kept = std::remove_if(lights.begin(), lights.end(), [](const std::string& word) {
    return look::ParseLight(word).Is != look::LightChoice::Kind::Sun;
  });
  const auto count = static_cast<int>(lights.end() - kept);
  lights.erase(kept, lights.end());
  settings.SetAll("--light", lights);
  return count;
}

QString Join(const QStringList& words)
{
  return words.size() < 2 ? words.join("")
                          : words.mid(0, words.size() - 1).join(", ") + " and " + words.back();
}
}

//------------------------------------------------------------------------------
QString DropFiles(scene::Settings& settings)
{
  QStringList dropped;
  settings.Files.clear();
  if (const int lights = DropPlacedLights(settings))
  {
    dropped += lights == 1 ? QString("a light") : QString("%1 lights").arg(lights);
  }
  for (const scene::PointStage& stage : scene::GetPointStages())
  {
    if (settings.Has("--" + stage.Name))
    {
      dropped += QString::fromStdString(stage.Name);
      settings.Remove("--" + stage.Name);
      settings.AskStage(stage.Name, false);
    }
  }
  for (const vtkRelievoOption& option : scene::GetRenderCommand().Options)
  {
    if (option.Has(vtkRelievoOption::OF_FILES))
    {
      if (settings.Has(option.Name) && !option.Dropped.empty())
      {
        dropped += QString::fromStdString(option.Dropped);
      }
      settings.Remove(option.Name);
    }
  }
  if (settings.Has("--colormap") && look::Colormap::Parse(settings.Get("--colormap")).Log)
  {
    settings.Remove("--colormap");
  }
  if (!settings.GetParameter("display", "layer").empty())
  {
    dropped += "the layer that was shown";
  }
  settings.AskStage("display", false);
  scene::DropIdleSurface(settings);
  scene::DropIdleFill(settings);
  return Join(dropped);
}
}
