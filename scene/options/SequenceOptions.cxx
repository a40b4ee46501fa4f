// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SequenceOptions.h"

#include "Errors.h"
#include "Options.h"
#include "Readers.h"
#include "Values.h"

#include "vtkRelievoRayLayers.h"

#include <algorithm>
#include <array>
#include <iterator>
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
}

//------------------------------------------------------------------------------
bool IsSequence(const RenderOptions& options)
{
  return !options.Model.Times.empty() || options.Motion.MovesCamera();
}

//------------------------------------------------------------------------------
void CheckFramesAlone(const RenderOptions& options, const std::string& option)
{
  if (!options.Gltf.empty() && GetFrameName(options.Gltf, 0).empty())
  {
    throw UsageError(option +
      " and --gltf: one file holds all frames: give --gltf a name with %d, or leave out " + option);
  }
  if (std::any_of(options.Layers.begin(), options.Layers.end(),
        [](const std::string& layer) { return vtkRelievoRayLayers::IsFlow(layer.c_str()); }))
  {
    throw UsageError(option + ": flow needs the frame before: leave out one of them");
  }
}

//------------------------------------------------------------------------------
void CheckSequence(const RenderOptions& options)
{
  const MotionChoice& motion = options.Motion;
  const char* const sequences = "--turntable N, --camera-path F or --times START:END:STEP";
  if (!IsSequence(options))
  {
    for (const char* option : { "--video", "--resume", "--fps" })
    {
      if (options.Has(option))
      {
        throw UsageError(
          std::string(option) + ": there is one frame: give " + sequences + " as well");
      }
    }
    return;
  }
  if (motion.Turntable > 0 && !motion.Path.empty())
  {
    throw UsageError("--turntable and --camera-path: give one of them; each moves the camera");
  }
  if (options.Has("--camera") && !motion.Path.empty())
  {
    throw UsageError("--camera and --camera-path: give one of them; the path has all views");
  }
  if (motion.Turntable > 0 && !options.Model.Times.empty() &&
    static_cast<std::size_t>(motion.Turntable) != options.Model.Times.size())
  {
    throw UsageError("--turntable and --times: got " + std::to_string(motion.Turntable) + " and " +
      std::to_string(options.Model.Times.size()) + " frames, expected the same number");
  }
  if (options.Has("--certify"))
  {
    throw UsageError(std::string(options.Model.Times.empty()
                         ? motion.Path.empty() ? "--turntable" : "--camera-path"
                         : "--times") +
      " and --certify: one picture is certified: give --camera or --time");
  }
  if (!motion.Video.empty() && options.Has("--transparent"))
  {
    throw UsageError("--video and --transparent: give one of them; films are opaque");
  }
  if (options.Has("--fps") && motion.Video.empty() && motion.Path.empty())
  {
    throw UsageError(
      "--fps: there is neither a film nor a camera's path: give --video F or --camera-path F");
  }
  const std::pair<const char*, std::string> places[] = { { "--png", options.PNG },
    { "--exr", options.EXR }, { "--baseline", options.Baseline }, { "--gltf", options.Gltf },
    { "--report", options.Report } };
  if (motion.Resume)
  {
    if (std::all_of(std::begin(places), std::end(places),
          [](const auto& place) { return place.second.empty(); }))
    {
      throw UsageError("--resume: frames are kept in files: give --png F as well");
    }
    if (!motion.Video.empty() && options.PNG.empty())
    {
      throw UsageError(
        "--resume and --video: a film is made of kept frames from their PNG files: give --png F "
        "as well");
    }
    CheckFramesAlone(options, "--resume");
  }
  for (const auto& [option, path] : places)
  {
    // One glTF file may hold all frames.
    if (!path.empty() && path != options.Gltf && GetFrameName(path, 0).empty())
    {
      RefuseValue(option, path,
        std::string("a name with %d or %04d once, the number of the frame, as ") +
          (options.Model.Times.empty() ? motion.Path.empty() ? "--turntable" : "--camera-path"
                                       : "--times") +
          " is given");
    }
  }
}
}
