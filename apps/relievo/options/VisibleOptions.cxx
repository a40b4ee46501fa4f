// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleOptions.h"

#include "Arguments.h"
#include "DatasetPoses.h"
#include "Errors.h"
#include "Lens.h"
#include "MeshNames.h"
#include "Values.h"

#include <limits>

namespace cli
{
//------------------------------------------------------------------------------
VisibleOptions ParseVisible(const std::vector<std::string>& words)
{
  VisibleOptions options;
  std::vector<std::string> ofCameras; // in the words of render
  scene::ParseArguments(
    words, "visible",
    { { "-o", false }, { "--allow-folder", false }, { "--poses", false }, { "--size", false },
      { "--view-angle", false }, { "--lens", false }, { "--cloud", false }, { "--up", false },
      { "--seed", false } },
    [&](const std::string& name, const std::string& value) {
      if (name == "-o")
      {
        options.File = value;
      }
      else if (name == "--allow-folder")
      {
        options.AllowedFolders.push_back(value);
      }
      else if (name == "--poses")
      {
        scene::CheckDatasetPoses(name, value);
        options.Poses = value;
      }
      else if (name == "--size" || name == "--view-angle" || name == "--lens")
      {
        ofCameras.push_back(name + "=" + value);
      }
      else if (name == "--cloud")
      {
        options.Cloud = value;
      }
      else if (name == "--up")
      {
        options.Up = static_cast<int>(scene::ParseChoice(name, value, { "x", "y", "z" }));
      }
      else
      {
        options.Seed = scene::ParseWhole(
          name, value, std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
      }
    },
    [&](const std::string& word) { options.Files.push_back(word); });
  CheckMeshFiles("visible", options.Files, options.File);
  if (options.Poses.empty())
  {
    throw scene::UsageError("visible: no cameras; give --poses orbit:N, random:N or FILE.json");
  }
  options.Render = scene::ParseOptions(ofCameras);
  scene::CheckLensScale(options.Render);
  if (!options.Cloud.empty())
  {
    CheckMeshName("--cloud", options.Cloud);
  }
  return options;
}
}
