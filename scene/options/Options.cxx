// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Arguments.h"
#include "Environment.h"
#include "Errors.h"
#include "Ground.h"
#include "Lights.h"
#include "Look.h"
#include "Models.h"
#include "OptionRows.h"
#include "OutputOptions.h"
#include "Presets.h"
#include "Readers.h"
#include "SequenceOptions.h"
#include "ShadowOptions.h"
#include "Surface.h"
#include "ToneOptions.h"
#include "UpAxis.h"
#include "Values.h"

#include "vtkRelievoCalibration.h"

#include <algorithm>
#include <cmath>

namespace scene
{
namespace
{
constexpr double LargestFigure = 5000.0; // millimetres
constexpr double SmallestDPI = 36.0;
constexpr double LargestDPI = 4800.0;

void TakeFigure(RenderOptions& options, const std::string& word)
{
  const char* const form = "WIDTHmm,DPI, such as 85mm,300";
  const std::vector<std::string> parts = Split(word, ',');
  const std::string unit = "mm";
  const std::string width = parts[0].substr(0, parts[0].rfind(unit));
  if (parts.size() != 2 || width + unit != parts[0])
  {
    RefuseValue("--figure", word, form);
  }
  options.Look.Print.Width = ParseNumberBetween("--figure width", width, 1.0, LargestFigure);
  options.Look.Print.DPI = ParseNumberBetween("--figure DPI", parts[1], SmallestDPI, LargestDPI);
}

//------------------------------------------------------------------------------
// The picture's size in pixels for a figure's width, with the proportions of --size.
void SizeFigure(RenderOptions& options)
{
  constexpr double inch = 25.4; // millimetres
  const PrintChoice& print = options.Look.Print;
  if (print.Width <= 0.0)
  {
    return;
  }
  const double width = print.Width / inch * print.DPI;
  const double height = width * options.Size[1] / options.Size[0];
  if (std::max(width, height) > LargestSize)
  {
    throw UsageError("--figure: the picture is " + std::to_string(std::lround(width)) + " x " +
      std::to_string(std::lround(height)) + " pixels, and at most " + std::to_string(LargestSize) +
      " are possible: give a smaller width or fewer DPI");
  }
  options.Size = { std::max(1, static_cast<int>(std::lround(width))),
    std::max(1, static_cast<int>(std::lround(height))) };
  options.IsSized = true;
}

//------------------------------------------------------------------------------
void TakeSize(RenderOptions& options, const std::string& word)
{
  const std::vector<std::string> parts = Split(word, 'x');
  if (parts.size() != 2)
  {
    RefuseValue("--size", word, "WxH, such as 1024x768");
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    options.Size[i] = ParseWhole("--size " + word, parts[i], 1, LargestSize);
  }
  options.IsSized = true;
}

//------------------------------------------------------------------------------
void TakeLens(RenderOptions& options, const std::string& word)
{
  const std::string error = vtkRelievoCalibration::Check(word);
  if (!error.empty())
  {
    throw UsageError("--lens: " + error);
  }
  options.Lens = word;
}

//------------------------------------------------------------------------------
void AddSizeOptions(OptionRows& rows, RenderOptions& all)
{
  vtkRelievoOption& allowFolder =
    rows
      .Add("--allow-folder", "DIR",
        "allows files to name others, such as textures, buffers and pieces, in this folder "
        "and below (each file's own folder)",
        [&all](const std::string& word) { all.AllowedFolders.push_back(word); })
      .Is(OptionRows::Option::READS_FILES | OptionRows::Option::OF_FILES);
  allowFolder.Repeats = true;
  allowFolder.Files = "/";
  rows.Add("--size", "WxH", "size of the picture in pixels, 1 to 16384 (1024x768)", all, TakeSize)
    .Is(OptionRows::Option::KEEPS_STYLE);
  rows
    .Add("--figure", "WIDTHmm,DPI",
      "a picture for print, such as 85mm,300: of this width at this resolution, which the PNG "
      "records, with the proportions of --size; texts of bars and grid in 8 points, lines in half "
      "a point",
      all, TakeFigure)
    .Is(OptionRows::Option::OF_ONE_VIEW)
    .RefuseLens("a lens has a size of its own");
}

//------------------------------------------------------------------------------
void AddLensOption(OptionRows& rows, RenderOptions& all)
{
  vtkRelievoOption& lens =
    rows
      .Add("--lens", "LENS",
        "replaces the pinhole in --png and --exr; the layers are then computed by rays: " +
          vtkRelievoCalibration::GetForms(true) +
          ", with ,K=FX/FY/CX/CY in pixels or ,angle=DEG, the full vertical angle (the view "
          "angle); " +
          vtkRelievoCalibration::GetForms(false) +
          "; or a calibration file, which also gives the size: .yml, .yaml, .json or .xml by "
          "OpenCV, ROS, Kalibr or EuRoC, also with .gz, or COLMAP's cameras.txt",
        all, TakeLens)
      .Is(OptionRows::Option::OF_ALL_VIEWS);
  lens.OfOutputs = true;
  lens.Files = "json|yml|yaml|xml|txt|gz";
  lens.Words = vtkRelievoCalibration::GetNames();
}
}

//------------------------------------------------------------------------------
vtkRelievoCommand DescribeRender(RenderOptions& all)
{
  OptionRows rows;
  rows.Command.Name = "render";
  rows.Command.Use = "FILE... --png F | --exr F | --baseline F | --gltf F | --report F";
  rows.Command.About = "render draws the FILEs off screen and writes the outputs that you request.";
  // Words are parsed often: long texts are made once.
  static const std::string extensions = Join(GetExtensions(), "|");
  static const std::string aboutFile = "." + Join(GetDataExtensions(), " .") +
    " and models, which may have bones: ." + Join(GetModelExtensions(), " .") +
    "\nGrids and images are drawn by their outer surface. Active scalars give the colour. OBJ and "
    "glTF bring their materials and textures.";
  rows.Command.AboutFile = aboutFile;
  rows.Command.Files = extensions;
  AddSizeOptions(rows, all);
  AddCameraOptions(rows, all.View);
  AddLensOption(rows, all);
  AddClipOption(rows, all.View);
  AddImageOption(rows, all.Image);
  AddShadingOption(rows, all.ShadingKind);
  AddPresetOption(rows, all);
  AddGroundOption(rows, all.Ground);
  AddLookOptions(rows, all.Look);
  AddLightOption(rows, all.Lights);
  AddFillOption(rows, all);
  AddModelOptions(rows, all.Model);
  AddShadowOptions(rows, all);
  AddAmbientOption(rows, all.Stages);
  AddMapOptions(rows, all.Surface);
  AddEnvironmentOptions(rows, all.Surface);
  AddUpOption(rows, all.UpAxis);
  AddPointOptions(rows, all);
  AddStageOptions(rows, all.Stages);
  AddToneOptions(rows, all);
  AddPictureOptions(rows, all);
  AddMotionOptions(rows, all.Motion);
  AddOutputOptions(rows, all);
  return rows.Command;
}

//------------------------------------------------------------------------------
const vtkRelievoCommand& GetRenderCommand()
{
  static RenderOptions none;
  static const vtkRelievoCommand command = DescribeRender(none);
  return command;
}

//------------------------------------------------------------------------------
bool IsOfSwitch(const StageChoice& choice)
{
  const vtkRelievoOption* option = GetRenderCommand().Find(choice.Option);
  return option && option->IsSwitch;
}

namespace
{
//------------------------------------------------------------------------------
// Rejects an option and a --stage parameter that set the same value. Options of points override
// their stage's parameters instead.
void CheckSaidOnce(const RenderOptions& options)
{
  const std::string byStage = StageChoice().Option;
  for (const StageChoice& own : options.Stages)
  {
    const bool isOwn = own.Option != byStage && own.Option != "--preset" && options.Has(own.Option);
    for (const auto& [name, value] : isOwn ? own.Parameters : NamedWords())
    {
      if (FindStageChoice(options.Stages, own.Name, name, byStage))
      {
        throw UsageError(own.Option + " and " + byStage + " " + own.Name + ":" + name +
          ": both set the same; give one of them");
      }
    }
  }
}

//------------------------------------------------------------------------------
void CheckLens(const RenderOptions& options)
{
  if (options.Lens.empty())
  {
    return;
  }
  if (options.View.ParallelScale && options.Lens.rfind("orthographic", 0) != 0)
  {
    throw UsageError(
      "--lens and --parallel-scale: give one of them; only the lens orthographic is a "
      "parallel projection, with its own scale");
  }
  for (const vtkRelievoOption& option : GetRenderCommand().Options)
  {
    if (!option.NotWithLens.empty() && options.Has(option.Name))
    {
      throw UsageError(
        "--lens and " + option.Name + ": " + option.NotWithLens + "; give one of them");
    }
  }
  for (const StageChoice& stage : options.Stages)
  {
    if (stage.Name == "display")
    {
      throw UsageError("--lens and " + stage.Option +
        " display: a lens has colour; give --exr F --layers for its layers");
    }
  }
}

//------------------------------------------------------------------------------
void CheckTogether(RenderOptions& options)
{
  if (options.View.Angle && options.View.ParallelScale)
  {
    throw UsageError("--view-angle and --parallel-scale: give one of them; a parallel projection "
                     "has no view angle");
  }
  if (!options.Layers.empty() && options.EXR.empty() && options.Report.empty())
  {
    throw UsageError("--layers: layers are written to OpenEXR: give --exr F as well");
  }
  if (!options.Baseline.empty() && !options.Lens.empty())
  {
    throw UsageError(
      "--baseline and --lens: a baseline needs a pinhole camera; give --exr F, which "
      "`relievo compare` accepts as well");
  }
  if (!options.Gltf.empty() && !options.Lens.empty())
  {
    throw UsageError("--gltf and --lens: give one of them; glTF has pinhole cameras alone");
  }
  if (options.Has("--portable") && options.Baseline.empty())
  {
    throw UsageError("--portable: describes a baseline: give --baseline F as well");
  }
  if (options.Has("--portable") && options.View.Clip)
  {
    throw UsageError("--portable and --clip: give one of them; the rays of a portable baseline do "
                     "not end at clipping distances");
  }
  if (options.Has("--hdr") && options.EXR.empty())
  {
    throw UsageError("--hdr: unclamped colour is written to OpenEXR: give --exr F as well");
  }
  if (options.Has("--transparent") && options.PNG.empty())
  {
    throw UsageError("--transparent: it is the picture that has no background: give --png F as "
                     "well; the colour of the EXR has its alpha");
  }
  CheckLens(options);
  CheckModelOptions(options);
  CheckSequence(options);
  CheckLookOptions(options.Look, options.Given);
  CheckStages(options.Stages);
  if (!options.Lights.empty())
  {
    const int lights = static_cast<int>(options.Lights.size());
    CheckShadowLayers(options, lights, lights == 1 ? "--light option" : "--light options");
  }
  CheckSurfaceOptions(options.Surface, options.Given);
  CheckSaidOnce(options);
  CheckShadowsAsked(options);
}
}

//------------------------------------------------------------------------------
RenderOptions ParseOptions(const std::vector<std::string>& words)
{
  RenderOptions options;
  options.Given = TakeArguments(words, DescribeRender(options),
    [&](const std::string& word) { options.Files.push_back(word); });
  // Options of points override --stage.
  std::stable_partition(options.Stages.begin(), options.Stages.end(),
    [](const StageChoice& choice) { return choice.Option.find(' ') == std::string::npos; });
  ApplyPreset(options);
  const auto darkens = [](const StageChoice& choice) { return choice.Name == "ambient"; };
  if (options.Ground.value_or(false) && !options.Surface.Environment.empty() &&
    std::none_of(options.Stages.begin(), options.Stages.end(), darkens))
  {
    // An environment's light casts no shadows: on the ground it falls like light from a uniform
    // sky.
    AddStage(options.Stages, "ambient", "--ground").Parameters = { { "enabled", "on" },
      { "only_catchers", "on" } };
  }
  SizeFigure(options);
  CheckShadowWishes(options);
  options.Surface.Shadowed = ShowsShadows(options);
  // Pictures without a preset, and those with an exposure, keep the environment's light.
  options.Surface.FindsIntensity = options.Preset != "none" &&
    FindWords(options.Surface.EnvironmentValues, "intensity").empty() &&
    std::none_of(options.Stages.begin(), options.Stages.end(),
      [](const StageChoice& stage) { return stage.Name == "tone"; });
  CheckTogether(options);
  return options;
}
}
