// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleOptions.h"

#include "Arguments.h"
#include "Errors.h"
#include "MeshNames.h"
#include "Values.h"

#include "vtkRelievoCalibration.h"

#include <limits>

namespace cli
{
namespace
{
constexpr int MostPixels = 16384; // along an axis

void TakeSize(VisibleOptions& options, const std::string& value)
{
  const std::vector<std::string> parts = scene::Split(value, 'x');
  if (parts.size() != 2)
  {
    scene::RefuseValue("--size", value, "WxH, such as 1024x768");
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    options.Size[i] = scene::ParseWhole("--size " + value, parts[i], 1, MostPixels);
  }
}
}

//------------------------------------------------------------------------------
VisibleOptions ParseVisible(const std::vector<std::string>& words)
{
  VisibleOptions options;
  scene::ParseArguments(
    words, "visible",
    { { "-o", false }, { "--poses", false }, { "--size", false }, { "--view-angle", false },
      { "--lens", false }, { "--cloud", false }, { "--up", false }, { "--seed", false } },
    [&](const std::string& name, const std::string& value) {
      if (name == "-o")
      {
        options.File = value;
      }
      else if (name == "--poses")
      {
        options.Poses = value;
      }
      else if (name == "--size")
      {
        TakeSize(options, value);
      }
      else if (name == "--view-angle")
      {
        options.ViewAngle = scene::ParseNumberBetween(name, value, 0., 180.);
      }
      else if (name == "--lens")
      {
        const std::string wrong = vtkRelievoCalibration::Check(value);
        if (!wrong.empty())
        {
          throw scene::UsageError(name + ": " + wrong);
        }
        options.Lens = value;
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
  if (!options.Cloud.empty())
  {
    CheckMeshName("--cloud", options.Cloud);
  }
  return options;
}
}
