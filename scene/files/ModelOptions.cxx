// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelOptions.h"

#include "Errors.h"
#include "LookOptions.h"
#include "Options.h"
#include "Readers.h"
#include "Values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <utility>

namespace scene
{
namespace
{
void CheckOneTime(const RenderOptions& options)
{
  if (options.Model.Time)
  {
    throw UsageError("--time and --times: give one of them");
  }
}
}

//------------------------------------------------------------------------------
const std::vector<std::string>& GetModelOptions()
{
  static const std::vector<std::string> names = { "--time", "--times", "--animation", "--blend",
    "--loop", "--skin", "--skeleton", "--bone-weight" };
  return names;
}

//------------------------------------------------------------------------------
void TakeTime(RenderOptions& options, const std::string& word)
{
  CheckOneTime(options);
  options.Model.Time = ParseNumbers("--time", word, 1, "seconds").front();
  options.Model.Given = true;
}

//------------------------------------------------------------------------------
void TakeAnimation(RenderOptions& options, const std::string& word)
{
  options.Model.Animation = word;
  options.Model.Given = true;
}

//------------------------------------------------------------------------------
void TakeTimes(RenderOptions& options, const std::string& word)
{
  CheckOneTime(options);
  constexpr double most = 1e6; // frames
  const std::vector<std::string> parts = Split(word, ':');
  const std::string form = "START:END:STEP in seconds, such as 0:2:0.1";
  if (parts.size() != 3)
  {
    RefuseValue("--times", word, form);
  }
  double numbers[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    numbers[i] = ParseNumbers("--times " + word, parts[i], 1, form).front();
  }
  const auto [start, end, step] = numbers;
  // Includes the end despite rounding of the steps.
  const double frames = step > 0.0 ? std::floor((end - start) / step * (1.0 + 1e-12) + 1e-9) : -1.0;
  if (!(frames >= 0.0) || frames >= most)
  {
    RefuseValue("--times", word,
      "START:END:STEP with START <= END, STEP > 0 and at most " +
        std::to_string(static_cast<int>(most)) + " frames");
  }
  options.Model.Times.clear();
  for (int i = 0; i <= static_cast<int>(frames); ++i)
  {
    options.Model.Times.push_back(start + i * step);
  }
  options.Model.Time = start;
  options.Model.Given = true;
}

//------------------------------------------------------------------------------
void TakeBlend(RenderOptions& options, const std::string& word)
{
  const std::size_t at = word.rfind('=');
  const std::string form = "NAME=WEIGHT with a weight from 0 to 1, such as run=0.3";
  if (at == std::string::npos || at == 0)
  {
    RefuseValue("--blend", word, form);
  }
  options.Model.Blend = word.substr(0, at);
  options.Model.BlendWeight = ParseNumbers("--blend " + word, word.substr(at + 1), 1, form).front();
  if (options.Model.BlendWeight < 0.0 || options.Model.BlendWeight > 1.0)
  {
    RefuseValue("--blend", word, form);
  }
  options.Model.Given = true;
}

//------------------------------------------------------------------------------
void TakeLoop(RenderOptions& options, const std::string&)
{
  options.Model.Loop = options.Model.Given = true;
}

//------------------------------------------------------------------------------
void TakeSkeleton(RenderOptions& options, const std::string&)
{
  options.Model.Skeleton = options.Model.Given = true;
}

//------------------------------------------------------------------------------
void TakeBoneWeight(RenderOptions& options, const std::string& word)
{
  options.Model.BoneWeight = word;
  options.Model.Given = true;
}

//------------------------------------------------------------------------------
std::string GetFrameName(const std::string& name, int frame)
{
  static const std::regex number("%(0[1-9])?d");
  std::smatch found;
  if (!std::regex_search(name, found, number) ||
    std::regex_search(found[0].second, name.cend(), number))
  {
    return "";
  }
  std::string digits = std::to_string(frame);
  const std::size_t width =
    found[1].matched ? static_cast<std::size_t>(found[1].str()[1] - '0') : 0;
  digits.insert(0, digits.size() < width ? width - digits.size() : 0, '0');
  return found.prefix().str() + digits + found.suffix().str();
}

//------------------------------------------------------------------------------
void CheckModelOptions(RenderOptions& options)
{
  ModelChoice& model = options.Model;
  LookChoice& look = options.Look;
  if (!model.BoneWeight.empty())
  {
    if (!look.ColorBy.empty() || look.Solid)
    {
      throw UsageError("--bone-weight, --color-by and --color: give one of them; each sets the "
                       "colours");
    }
    look.ColorBy = look.ColorByAsGiven = "bone_weight";
    look.Range = look.Range.value_or(std::array<double, 2>{ 0.0, 1.0 });
  }
  model.FirstBone = look.ColorBy == "first_bone" ||
    std::find(options.Layers.begin(), options.Layers.end(), "first_bone") != options.Layers.end();
  if (model.Given && !options.Files.empty() &&
    std::none_of(options.Files.begin(), options.Files.end(), IsModel))
  {
    throw UsageError(Join(GetModelOptions(), ", ") + ": no FILE can have bones; expected one of ." +
      Join(GetModelExtensions(), " ."));
  }
  if (model.Times.empty())
  {
    return;
  }
  if (options.Certify)
  {
    throw UsageError("--times and --certify: one picture is certified: give --time T");
  }
  for (const auto& [option, path] : { std::pair<const char*, std::string>("--png", options.PNG),
         { "--exr", options.EXR }, { "--report", options.Report } })
  {
    if (!path.empty() && GetFrameName(path, 0).empty())
    {
      RefuseValue(
        option, path, "a name with %d or %04d once, the number of the frame, as --times is given");
    }
  }
}
}
