// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SequenceOptions.h"

#include "Errors.h"
#include "Options.h"
#include "Readers.h"
#include "Values.h"

#include <algorithm>
#include <array>
#include <regex>
#include <utility>

namespace scene
{
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
