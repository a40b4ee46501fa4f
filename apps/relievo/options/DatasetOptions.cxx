// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DatasetOptions.h"

#include "Arguments.h"
#include "DatasetPoses.h"
#include "Errors.h"
#include "Lens.h"
#include "Options.h"
#include "Values.h"

#include <algorithm>
#include <limits>
#include <set>

namespace cli
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Options of render that poses, or the data set's own files, are in the place of.
constexpr const char* OfRender[] = { "--camera", "--parallel-scale", "--clip", "--times", "--png",
  "--exr", "--report", "--hdr", "--transparent", "--certify" };

const std::vector<scene::KnownOption> Own = { { "--poses", false }, { "--out", false },
  { "--format", false }, { "--layers", false }, { "--objects", false }, { "--depth-step", false },
  { "--mm-per-unit", false }, { "--seed", false }, { "--random-sun", true }, { "--views", false } };

bool IsOfRender(const std::string& name)
{
  return std::find(std::begin(OfRender), std::end(OfRender), name) != std::end(OfRender);
}

void TakeRange(DatasetOptions& options, const std::string& name, const std::string& value)
{
  const std::vector<std::string> parts = scene::Split(value, ':');
  if (parts.size() != 2)
  {
    scene::RefuseValue(name, value, "A:B, from view A to before view B");
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    options.Range[i] =
      scene::ParseWhole(name + " " + value, parts[i], 0, std::numeric_limits<int>::max());
  }
  if (options.Range[0] >= options.Range[1])
  {
    scene::RefuseValue(name, value, "the first view to be before the end");
  }
}

//------------------------------------------------------------------------------
void Take(DatasetOptions& options, const std::string& name, const std::string& value)
{
  if (name == "--poses")
  {
    scene::CheckDatasetPoses(name, value);
    options.Poses = value;
  }
  else if (name == "--out")
  {
    options.Folder = value;
  }
  else if (name == "--format")
  {
    options.Format =
      static_cast<int>(scene::ParseChoice(name, value, { "bop", "coco", "nerf", "npz" }));
  }
  else if (name == "--layers")
  {
    const std::vector<std::string> layers = scene::SplitEscaped(value, ',');
    if (std::find(layers.begin(), layers.end(), "") != layers.end())
    {
      scene::RefuseValue(name, value, "names between commas, such as depth,normal");
    }
    options.Layers.insert(options.Layers.end(), layers.begin(), layers.end());
  }
  else if (name == "--objects")
  {
    options.Objects =
      static_cast<DatasetParts>(scene::ParseChoice(name, value, { "file", "actor", "block" }));
  }
  else if (name == "--depth-step")
  {
    options.DepthStep = scene::ParseNumberBetween(name, value, 0., Infinity);
  }
  else if (name == "--mm-per-unit")
  {
    options.MillimetersPerUnit = scene::ParseNumberBetween(name, value, 0., Infinity);
  }
  else if (name == "--seed")
  {
    options.Seed = scene::ParseWhole(
      name, value, std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  }
  else if (name == "--random-sun")
  {
    options.RandomSun = true;
  }
  else
  {
    TakeRange(options, name, value);
  }
}
}

//------------------------------------------------------------------------------
DatasetOptions ParseDataset(const std::vector<std::string>& words)
{
  const auto isOwn = [](const std::string& name) {
    return std::any_of(Own.begin(), Own.end(),
      [&name](const scene::KnownOption& option) { return option.Name == name; });
  };
  std::vector<scene::KnownOption> known = Own;
  for (const scene::KnownOption& option : scene::GetRenderOptions())
  {
    if (!isOwn(option.Name) && !IsOfRender(option.Name))
    {
      known.push_back(option);
    }
  }
  for (const std::string& word : words)
  {
    const std::string name = word.substr(0, word.find('='));
    if (IsOfRender(name))
    {
      throw scene::UsageError(name +
        ": is an option of relievo render; of a data set --poses says where the cameras are, "
        "--format and --out what is written");
    }
    if (word == "--")
    {
      break;
    }
  }
  DatasetOptions options;
  std::vector<std::string> files;
  std::set<std::string> given;
  scene::ParseArguments(
    words, "dataset", known,
    [&](const std::string& name, const std::string& value) {
      const bool isFlag = std::any_of(known.begin(), known.end(),
        [&name](const scene::KnownOption& each) { return each.Name == name && each.IsFlag; });
      const std::string word = isFlag ? name : name + "=" + value;
      if (!isOwn(name))
      {
        options.Scene.push_back(word);
      }
      else if (name == "--layers" || given.insert(name).second)
      {
        Take(options, name, value);
      }
      else
      {
        throw scene::UsageError(name + ": given twice, expected once");
      }
      if (name != "--out" && name != "--views")
      {
        options.Words.push_back(word);
      }
    },
    [&](const std::string& word) { files.push_back(word); });
  if (files.empty())
  {
    throw scene::UsageError("dataset: no FILE given");
  }
  if (options.Poses.empty())
  {
    throw scene::UsageError("dataset: no cameras; give --poses orbit:N, random:N or FILE.json");
  }
  if (options.Folder.empty())
  {
    throw scene::UsageError("dataset: no folder to write to; give --out DIR");
  }
  options.Scene.emplace_back("--");
  for (std::vector<std::string>* to : { &options.Scene, &options.Words })
  {
    to->insert(to->end(), files.begin(), files.end());
  }
  options.Render = scene::ParseOptions(options.Scene);
  scene::CheckLensScale(options.Render);
  return options;
}
}
