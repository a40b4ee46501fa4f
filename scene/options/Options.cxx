// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Arguments.h"
#include "Colormaps.h"
#include "Errors.h"
#include "Numbers.h"
#include "Presets.h"
#include "Readers.h"
#include "SequenceOptions.h"
#include "ShadowOptions.h"
#include "SurfaceOptions.h"
#include "ToneOptions.h"
#include "Triples.h"
#include "Values.h"

#include "vtkRelievoCalibration.h"
#include "vtkRelievoImageFile.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoStageDescription.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <set>

namespace scene
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
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
void TakeCamera(RenderOptions& options, const std::string& word)
{
  const std::vector<double> n = ParseNumbers("--camera", word, 9, "PX,PY,PZ,FX,FY,FZ,UX,UY,UZ");
  const CameraPlace camera = { Triple(n, 0), Triple(n, 3), Triple(n, 6) };
  const std::string error = CheckPlace(camera);
  if (!error.empty())
  {
    RefuseValue("--camera", word, error);
  }
  options.View.Place = camera;
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
void TakeClip(RenderOptions& options, const std::string& word)
{
  const std::vector<double> n = ParseNumbers("--clip", word, 2, "NEAR,FAR");
  if (n[0] <= 0.0 || n[1] <= n[0])
  {
    RefuseValue("--clip", word, "NEAR,FAR with 0 < NEAR < FAR");
  }
  options.View.Clip = { n[0], n[1] };
}

//------------------------------------------------------------------------------
void TakeAmbient(RenderOptions& options, const std::string& word)
{
  const std::vector<std::string> pieces = Split(word, ',');
  StageChoice& choice = AddStage(options.Stages, "ambient", "--ambient");
  choice.Parameters = { { "enabled", "on" }, { "strength", pieces[0] } };
  for (auto piece = std::next(pieces.begin()); piece != pieces.end(); ++piece)
  {
    const std::size_t equals = piece->find('=');
    if (equals == 0 || equals == std::string::npos)
    {
      RefuseValue("--ambient", word,
        "a strength from 0 to 1, then ,radius=R ,weighting=W or ,samples=N, such as 1,radius=0.5");
    }
    choice.Parameters.emplace_back(piece->substr(0, equals), piece->substr(equals + 1));
  }
}

//------------------------------------------------------------------------------
void TakeLayers(RenderOptions& options, const std::string& word)
{
  for (const std::string& name : SplitEscaped(word, ','))
  {
    if (name.empty())
    {
      RefuseValue("--layers", word, "names between commas, such as depth,normal");
    }
    if (std::find(options.Layers.begin(), options.Layers.end(), name) == options.Layers.end())
    {
      options.Layers.push_back(name);
    }
  }
}

//------------------------------------------------------------------------------
// An option of one of their parts.
template <auto Part, auto Take>
void TakePart(RenderOptions& options, const std::string& word)
{
  Take(options.*Part, word);
}

//------------------------------------------------------------------------------
template <auto All, auto Parse>
void TakeNext(RenderOptions& options, const std::string& word)
{
  (options.*All).push_back(Parse(word));
}

//------------------------------------------------------------------------------
// The format of a picture must match its name.
std::string NamedAs(
  const std::string& extension, const std::string& option, const std::string& word)
{
  if (ExtensionOf(word) != extension)
  {
    RefuseValue(option, word, "a name that ends in " + extension);
  }
  return word;
}

//------------------------------------------------------------------------------
std::string Insert(std::string help, const std::string& mark, const std::string& text)
{
  const std::size_t at = help.find(mark);
  return at == std::string::npos ? help : help.replace(at, mark.size(), text);
}

using Option = vtkRelievoOption;

//------------------------------------------------------------------------------
// The rows of a command that fills these options.
struct Rows
{
  RenderOptions& Options;
  vtkRelievoCommand Command;

  using Taker = std::function<void(RenderOptions& options, const std::string& word)>;

  vtkRelievoOption& Add(
    const std::string& name, const std::string& form, const std::string& help, const Taker& take)
  {
    vtkRelievoOption option;
    option.Name = name;
    option.Form = form;
    option.Help = help;
    option.Take = [options = &this->Options, take](const std::string& word) {
      take(*options, word);
      return std::string();
    };
    this->Command.Options.push_back(option);
    return this->Command.Options.back();
  }

  vtkRelievoOption& AddFlag(const std::string& name, const std::string& help, bool& flag)
  {
    return this->Add(name, "", help, [&flag](RenderOptions&, const std::string&) { flag = true; });
  }

  // An option that sets a parameter of a stage. `help` precedes the range and the default; `read`
  // converts the option's value to the parameter's.
  vtkRelievoOption& AddOfStage(const std::string& use, const std::string& stage,
    const std::string& parameter, const std::string& help,
    const std::function<std::string(const std::string& word)>& read = nullptr)
  {
    vtkRelievoParameter set = *GetNewFrame()->GetStage(stage)->GetDescription().Find(parameter);
    set.Help = help;
    vtkRelievoOption option = vtkRelievoOption::Of(set, use);
    option.Sets = stage + ":" + parameter;
    option.Take = [=, options = &this->Options, check = option.Take, name = option.Name](
                    const std::string& word) {
      const std::string words = read ? read(word) : word;
      const std::string error = check(words);
      set.Parse(set.Default); // resets the new frame, which serves only for its description
      if (error.empty())
      {
        AddStage(options->Stages, stage, name)
          .Parameters.emplace_back(parameter, words.empty() ? "on" : words);
      }
      return error;
    };
    this->Command.Options.push_back(option);
    return this->Command.Options.back();
  }

  // An option that switches a stage, with a choice of one of its parameters, or `off`.
  // The words replace @choices@ in the help.
  vtkRelievoOption& AddSwitch(const std::string& name, const std::string& form,
    const std::string& stage, const std::string& parameter, const std::string& help)
  {
    const vtkRelievoParameter& set =
      *GetNewFrame()->GetStage(stage)->GetDescription().Find(parameter);
    std::vector<std::string> words = set.Choices;
    words.insert(words.begin(), "off");
    vtkRelievoOption& option = this->AddChoice(name, form, words, help,
      [=, options = &this->Options, usual = set.Default](std::size_t place) {
        AddStage(options->Stages, stage, name).Parameters = {
          { "enabled", place == 0 ? "off" : "on" }, { parameter, place == 0 ? usual : words[place] }
        };
      });
    option.Sets = stage + ":" + parameter;
    option.IsSwitch = true;
    return option;
  }

  // The bounds replace @bounds@ in the help.
  vtkRelievoOption& AddNumber(const std::string& name, const std::string& form,
    const std::string& help, const vtkRelievoOption::Bounds& range,
    const std::function<void(RenderOptions& options, double number)>& take)
  {
    const std::string least = WriteNumber(range.Least), most = WriteNumber(range.Most);
    vtkRelievoOption& option = this->Add(name, form,
      Insert(help, "@bounds@",
        range.Open ? "above " + least + " and below " + most : least + " to " + most),
      [=](RenderOptions& options, const std::string& word) {
        const auto parse = range.Open ? ParseNumberBetween : ParseNumberFrom;
        take(options, parse(name, word, range.Least, range.Most));
      });
    option.Range = range;
    return option;
  }

  // The choices replace @choices@ in the help.
  vtkRelievoOption& AddChoice(const std::string& name, const std::string& form,
    const std::vector<std::string>& choices, const std::string& help,
    const std::function<void(std::size_t place)>& take)
  {
    vtkRelievoOption& option =
      this->Add(name, form, Insert(help, "@choices@", vtkRelievoEither(choices)),
        [name, choices, take](
          RenderOptions&, const std::string& word) { take(ParseChoice(name, word, choices)); });
    option.Words = choices;
    return option;
  }
};
}

//------------------------------------------------------------------------------
vtkRelievoCommand DescribeRender(RenderOptions& all)
{
  Rows rows = { all, {} };
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
  static const std::string images = vtkRelievoImageFile::ListExtensions("", "|");
  static const std::string listed = vtkRelievoImageFile::ListExtensions(".");
  static const std::string lights = DescribeLights();
  static const std::string ofMaterial = DescribeValues(GetMaterialValues());
  static const std::string ofEnvironment = DescribeValues(GetEnvironmentValues());
  vtkRelievoOption& allowFolder =
    rows
      .Add("--allow-folder", "DIR",
        "allows files to name others, such as textures, buffers and pieces, in this folder "
        "and below (each file's own folder)",
        [](RenderOptions& options, const std::string& word) {
          options.AllowedFolders.push_back(word);
        })
      .Is(Option::READS_FILES | Option::OF_FILES);
  allowFolder.Repeats = true;
  allowFolder.Files = "/";
  rows.Add("--size", "WxH", "size of the picture in pixels, 1 to 16384 (1024x768)", TakeSize)
    .Is(Option::KEEPS_STYLE);
  rows
    .Add("--figure", "WIDTHmm,DPI",
      "a picture for print, such as 85mm,300: of this width at this resolution, which the PNG "
      "records, with the proportions of --size; texts of bars and grid in 8 points, lines in half "
      "a point",
      TakeFigure)
    .Is(Option::OF_ONE_VIEW)
    .RefuseLens("a lens has a size of its own");
  rows
    .Add("--camera", "PX,PY,PZ,FX,FY,FZ,UX,UY,UZ",
      "position, focal point, up (fitted to the scene: from the upper right, or with "
      "--preset none along -z with y or the axis of --up up; from the flat side of a flat "
      "scene)",
      TakeCamera)
    .Is(Option::KEEPS_STYLE | Option::OF_ONE_VIEW);
  rows
    .AddNumber("--view-angle", "DEG",
      "full vertical angle of the perspective, degrees, @bounds@ (30)", { 0.0, 180.0, true },
      [](RenderOptions& options, double angle) { options.View.Angle = angle; })
    .NamedIn("Scene", "View angle");
  rows
    .Add("--parallel-scale", "S",
      "parallel projection; S is half the picture's height in world units",
      [](RenderOptions& options, const std::string& word) {
        options.View.ParallelScale = ParseNumberBetween("--parallel-scale", word, 0.0, Infinity);
      })
    .Is(Option::OF_ONE_VIEW);
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
        TakeLens)
      .Is(Option::OF_ALL_VIEWS);
  lens.OfOutputs = true;
  lens.Files = "json|yml|yaml|xml|txt|gz";
  lens.Words = vtkRelievoCalibration::GetNames();
  rows
    .Add("--clip", "NEAR,FAR",
      "clipping distances from the camera, 0 < NEAR < FAR (around the scene)", TakeClip)
    .Is(Option::KEEPS_STYLE | Option::OF_ONE_VIEW)
    .DropAs("the clipping distances");
  rows
    .Add("--image", "KIND",
      "how images with depth (.vti, .pvti, .vtk) are shown: labels, the smooth surface of "
      "each value other than 0, for at most 2000 values; surface[=VALUE], the surface at "
      "VALUE (the threshold that separates the values best); volume; box, the outer faces; "
      "auto, labels if the image consists of labels, at most 2000, else surface (auto with "
      "a preset and without --color-by and --scalar-bar, else box)",
      [](RenderOptions& options, const std::string& word) { options.Image = ParseImage(word); })
    .Is(Option::READS_FILES)
    .NamedIn("Scene", "Images")
    .DropAs("how the image is shown")
    .Words = { "auto", "labels", "surface", "volume", "box" };
  rows
    .AddChoice("--shading", "KIND", { "flat", "gouraud", "phong", "pbr" },
      "@choices@ (phong; glTF keeps its own materials)",
      [&all](std::size_t place) {
        constexpr Shading kinds[] = { Shading::Flat, Shading::Gouraud, Shading::Phong,
          Shading::PBR };
        all.ShadingKind = kinds[place];
      })
    .NamedIn("Look", "Shading");
  rows
    .Add("--preset", "NAME",
      "studio, town or print: lights, shadows, ground, background and a view from the "
      "upper right, unless other options set them; none: VTK's headlight on black (the "
      "environment variable RELIEVO_PRESET, or else studio)",
      TakePreset)
    .NamedIn("Scene", "Preset")
    .Words = GetPresetNames();
  rows
    .AddChoice("--ground", "ON", { "off", "on" },
      "on or off: a ground below the scene that catches its shadows, only in the picture "
      "(on with the lights of studio and town)",
      [&all](std::size_t place) { all.Ground = place == 1; })
    .NamedIn("Scene", "Ground");
  rows
    .AddFlag("--grid",
      "shows a grid around the scene with numbers on its axes x, y and z, only in the "
      "picture",
      all.Look.Grid)
    .NamedIn("Scene", "Grid")
    .RefuseLens("it is drawn only over a pinhole's picture");
  rows
    .Add("--scale-bar", "UNIT[,length=LENGTH]",
      "shows a scale bar of a round length, or of LENGTH, at the lower right, only in the "
      "picture. UNIT is the unit of the scene's coordinates, such as mm; none: the number "
      "alone. In perspective the bar is correct at the depth of the focal point",
      TakePart<&RenderOptions::Look, TakeScaleBar>)
    .NamedIn("Scene", "Scale bar")
    .RefuseLens("it is drawn only over a pinhole's picture")
    .Words = { "none" };
  rows
    .Add("--color-by", "NAME[,COMPONENT]",
      "colours by a point or cell array, point:NAME or cell:NAME if two share a name; "
      "COMPONENT is a number from 0, or magnitude (the active scalars; the magnitude; "
      "bytes of 3 or 4 components are colours)",
      TakePart<&RenderOptions::Look, TakeColorBy>)
    .Is(Option::OF_FILES)
    .NamedIn("Look", "Colour by");
  rows
    .Add("--range", "MIN,MAX",
      "values of the first and the last colour (the array's finite range in all files); "
      "symmetric: that range, extended to be symmetric around zero",
      TakePart<&RenderOptions::Look, TakeRange>)
    .Is(Option::OF_FILES)
    .NamedIn("Look", "Range")
    .Words = { "symmetric" };
  rows
    .Add("--colormap", "NAME",
      "viridis, cool-warm, grey, hot, rainbow, ember, ocean, blue-orange, green-purple, phase or "
      "categories, or colours between commas, evenly spaced "
      "or at shares of the range, such as black,0.3=#ff8000,white; then optionally "
      ":reversed, :log (by the logarithm of the values), :steps=N (N colours) and "
      ":nan=COLOR (the colour of NaN) (viridis)",
      TakePart<&RenderOptions::Look, TakeColormap>)
    .NamedIn("Look", "Colour map")
    .Words = GetColormapNames();
  rows
    .AddFlag("--scalar-bar", "shows the colours and their values at the right", all.Look.ScalarBar)
    .Is(Option::OF_FILES)
    .NamedIn("Look", "Show a colour bar")
    .RefuseLens("it is drawn only over a pinhole's picture");
  rows
    .Add("--bar", "PLACE[,title=TEXT][,unit=UNIT]",
      "the scalar bar at the right, left, bottom or top (where it is horizontal), with another "
      "title than the array's name, and with the unit of the values",
      TakePart<&RenderOptions::Look, TakeBar>)
    .Is(Option::OF_FILES)
    .NamedIn("Look", "Side of the bar")
    .RefuseLens("it is drawn only over a pinhole's picture")
    .Words = { "right", "left", "bottom", "top" };
  rows
    .Add("--color", "COLOR",
      "one colour for all meshes; COLOR is R/G/B from 0 to 1 as displays show it, "
      "#rrggbb, or a name such as slategray",
      TakePart<&RenderOptions::Look, TakeColor>)
    .NamedIn("Look", "One colour");
  rows
    .AddNumber("--opacity", "A", "opacity of all meshes and volumes, @bounds@ (1)", { 0.0, 1.0 },
      [](RenderOptions& options, double opacity) { options.Look.Opacity = opacity; })
    .Is(Option::SHAPES_SURFACE)
    .NamedIn("Look", "Opacity");
  rows
    .Add("--opacity-curve", "VALUE/A,...",
      "volumes (--image volume): the opacity at two or more values, 0 to 1 over a hundredth of the "
      "image's diagonal, linear in between (0 below the threshold that separates the values best)",
      TakePart<&RenderOptions::Look, TakeOpacityCurve>)
    .Is(Option::SHAPES_SURFACE)
    .NamedIn("Look", "Opacity curve")
    .DropAs("the opacity curve");
  rows
    .AddNumber("--volume-step", "SHARE",
      "step of rays through volumes, as a share of the smallest distance between the image's "
      "points, @bounds@; smaller steps are slower and show fewer rings (0.5, and finer in images "
      "of few points)",
      { 0.05, 4.0 }, [](RenderOptions& options, double step) { options.Look.VolumeStep = step; })
    .Is(Option::SHAPES_SURFACE)
    .NamedIn("Look", "Step");
  rows
    .AddNumber("--point-size", "PIXELS",
      "width of points, @bounds@ pixels; wider than 1, they are drawn as spheres (4 with a "
      "preset, else 1)",
      { 1.0, 100.0 }, [](RenderOptions& options, double size) { options.Look.PointSize = size; })
    .NamedIn("Look", "Point size");
  rows.AddFlag("--edges", "draws the edges of cells", all.Look.Edges).NamedIn("Look", "Show edges");
  rows
    .Add("--background", "COLOR[,COLOR]",
      "one colour, or a gradient: the bottom's and the top's (the preset's; black with "
      "--preset none)",
      TakePart<&RenderOptions::Look, TakeBackground>)
    .NamedIn("Look", "Background");
  vtkRelievoOption& light =
    rows.Add("--light", "LIGHT", lights, TakeNext<&RenderOptions::Lights, ParseLight>)
      .NamedIn("Light", "Lights");
  light.Repeats = true;
  light.Words = { "sun:", "spot:", "point:" };
  rows
    .AddNumber("--fill", "F",
      "strength of a preset's fill lights, which light the areas that its first light, or "
      "--light, leaves dark, @bounds@ (1; 0.4 with --light)",
      { 0.0, 1.0 }, [](RenderOptions& options, double fill) { options.Fill = fill; })
    .NamedIn("Light", "Fill");
  rows
    .Add("--time", "T", "the time of models with bones, in seconds (the animation's start)",
      TakePart<&RenderOptions::Model, TakeTime>)
    .Is(Option::READS_FILES | Option::OF_FILES);
  rows
    .Add("--times", "START:END:STEP",
      "draws a frame for each of these times, including the end; the names of --png, --exr "
      "and --report must contain %d or %04d, the frame number from 0. The fitted camera "
      "sees all frames, and each frame's files are written before the next frame is drawn",
      TakePart<&RenderOptions::Model, TakeTimes>)
    .Is(Option::READS_FILES | Option::OF_FILES | Option::OF_ONE_VIEW);
  rows
    .Add("--animation", "NAME", "the animation of the models to play (the first)",
      TakePart<&RenderOptions::Model, TakeAnimation>)
    .Is(Option::READS_FILES | Option::OF_FILES)
    .NamedIn("Scene", "Animation");
  rows
    .Add("--blend", "NAME=W", "blends in another animation with weight W, 0 to 1",
      TakePart<&RenderOptions::Model, TakeBlend>)
    .Is(Option::READS_FILES | Option::OF_FILES);
  rows
    .Add("--loop", "",
      "times after the end of an animation start again from its beginning (the end holds)",
      TakePart<&RenderOptions::Model, TakeLoop>)
    .Is(Option::READS_FILES | Option::OF_FILES)
    .NamedIn("Scene", "Start anew after the end");
  rows
    .AddChoice("--skin", "METHOD", { "linear", "dual-quaternion", "key-matrix", "off" },
      "how bones move points: linear, dual-quaternion, key-matrix, or off for the mesh at "
      "rest (linear)",
      [&all](std::size_t place) {
        constexpr SkinChoice kinds[] = { SkinChoice::Linear, SkinChoice::DualQuaternion,
          SkinChoice::KeyMatrix, SkinChoice::Off };
        all.Model.Skin = kinds[place];
        all.Model.Given = true;
      })
    .Is(Option::READS_FILES | Option::OF_FILES)
    .NamedIn("Scene", "Skinning");
  rows
    .Add("--skeleton", "",
      "draws the bones, and the axes of their joints in red, green and blue; --opacity "
      "affects only the mesh",
      TakePart<&RenderOptions::Model, TakeSkeleton>)
    .Is(Option::READS_FILES | Option::OF_FILES)
    .NamedIn("Scene", "Show the bones");
  rows
    .Add("--bone-weight", "BONE",
      "colours by the weight of one bone; --color-by first_bone colours by the strongest",
      TakePart<&RenderOptions::Model, TakeBoneWeight>)
    .Is(Option::READS_FILES | Option::OF_FILES);
  rows
    .AddSwitch("--shadows", "METHOD", "shadows", "method",
      "shadows of the lights in the picture: @choices@ (map with studio and town, else off)")
    .Is(Option::KEEPS_STYLE)
    .NamedIn("Light", "Shadows");
  rows
    .AddChoice("--volume-shadows", "KIND", { "both", "casts", "receives", "none" },
      "whether volumes (--image volume) cast shadows and receive them, also their own, if there "
      "are "
      "shadows: @choices@ (both)",
      [&all](std::size_t place) {
        all.VolumesCast = place < 2;
        all.VolumesReceive = place % 2 == 0;
      })
    .NamedIn("Look", "Volume shadows");
  rows.AddOfStage("--shadow-size N", "shadows", "map_size", "Side of each shadow map")
    .NamedIn("Light", "Map size");
  rows.AddOfStage("--soft-shadows N", "shadows", "soft_samples", "-")
    .NamedIn("Light", "Samples")
    .Help = "shadows of lights with a size: the mean of N samples of each light's shape, 0 to "
            "4096 (24 with studio and town, 4 with --image volume, unless --shadows, --certify, "
            "--shadow-tolerance, --time-budget or --layers is given; else 0: hard shadows)";
  rows
    .AddOfStage("--colored-shadows", "shadows", "colored_shadows",
      "Translucent meshes cast shadows too, and colour the light that passes them; needs "
      "--shadows exact, except for coloured volumes (--image volume), which then colour it")
    .NamedIn("Light", "Coloured shadows");
  rows
    .AddOfStage("--shadow-tolerance S", "shadows", "tolerance", "-",
      [](const std::string& word) { return WriteNumber(ParseShare("--shadow-tolerance", word)); })
    .NamedIn("Light", "Tolerance")
    .Help = "shadows by the cheapest method with an expected share of wrong pixels of at most S, "
            "such as 0.05% or 0.0005";
  rows.Command.Options.back().Implies = { "--shadows", "map" }; // the method is chosen later
  rows
    .AddOfStage("--time-budget MS", "shadows", "time_budget", "-",
      [](const std::string& word) {
        return WriteNumber(ParseNumberBetween("--time-budget", word, 0.0, Infinity));
      })
    .NamedIn("Light", "Time budget")
    .Help = "shadows by the most accurate method whose frames are expected to take at most MS "
            "milliseconds";
  rows.Command.Options.back().Implies = { "--shadows", "map" };
  rows
    .Add("--certify", "N",
      "checks N shadow verdicts, chosen at random, by rays in double precision, and prints "
      "the share of wrong ones with its 95 % bound",
      TakeCertify)
    .RefuseLens("it checks only a pinhole's picture")
    .OfOutputs = true;
  rows
    .Add("--ambient", "STRENGTH[,radius=R][,NAME=VALUE]...",
      "ambient occlusion by rays: opaque surfaces are darker by up to this share, 0 to 1, "
      "where they see less of the sky; R limits the distance of occluders in world units "
      "(0: no limit). Other values are parameters of the stage ambient, such as samples=N, "
      "rays per pixel (64)",
      TakeAmbient)
    .Sets = "ambient";
  rows
    .Add("--normal-map", "F",
      "tangent-space normals from an image (" + listed +
        "; green points up, as in OpenGL), placed by the meshes' texture coordinates; linear "
        "values, not sRGB",
      [](RenderOptions& options, const std::string& word) { options.Surface.NormalMap = word; })
    .Is(Option::READS_FILES | Option::SHAPES_SURFACE)
    .NamedIn("Look", "Normal map")
    .DropAs("the normal map")
    .Files = images;
  rows
    .Add("--height-map", "F[,SCALE]",
      "heights from an image; the ground lies SCALE below the mesh, in world units "
      "(0.02 of the scene's longest side)",
      TakePart<&RenderOptions::Surface, TakeHeightMap>)
    .Is(Option::READS_FILES | Option::SHAPES_SURFACE)
    .NamedIn("Look", "Height map")
    .DropAs("the height map")
    .Files = images;
  rows
    .AddChoice("--relief", "METHOD", GetReliefMethods(),
      "how heights are drawn: off (as normals only), parallax, steep, occlusion or relief (relief)",
      [&all](std::size_t place) { all.Surface.ReliefMethod = GetReliefMethods()[place]; })
    .Is(Option::SHAPES_SURFACE | Option::OF_FILES)
    .NamedIn("Look", "Relief method");
  rows
    .Add("--material", "NAME=VALUE[,NAME=VALUE]...",
      "other values of the material of all surfaces" + ofMaterial,
      TakePart<&RenderOptions::Surface, TakeMaterial>)
    .Is(Option::SHAPES_SURFACE)
    .NamedIn("Look", "Material");
  rows
    .AddChoice("--texture-coordinates", "METHOD", { "box", "plane", "sphere" },
      "how texture coordinates are made for meshes without them: @choices@ (box, with a "
      "note)",
      [&all](std::size_t place) {
        constexpr Mapping methods[] = { Mapping::Box, Mapping::Plane, Mapping::Sphere };
        all.Surface.TextureMapping = methods[place];
      })
    .Is(Option::READS_FILES | Option::SHAPES_SURFACE | Option::OF_FILES)
    .NamedIn("Look", "Texture coordinates");
  rows
    .Add("--environment", "F[,DEG][,NAME=VALUE]...",
      "light from all directions, for reflections and ambient light, from an image (" + listed +
        ") that is twice as wide as high, or square for a photograph of a mirror ball; "
        "rotated by DEG about the up axis (0). 8 and 16 bits are sRGB, floats linear light. "
        "Other values are" +
        ofEnvironment,
      TakePart<&RenderOptions::Surface, TakeEnvironment>)
    .Is(Option::SHAPES_SURFACE)
    .NamedIn("Light", "Environment")
    .Files = images;
  rows
    .Add("--reflectivity", "R[,ROUGHNESS]",
      "share of the environment's light that surfaces mirror at normal incidence, and "
      "roughness of the mirror, each 0 to 1 (0.04,0.2)",
      TakePart<&RenderOptions::Surface, TakeReflectivity>)
    .Is(Option::SHAPES_SURFACE)
    .NamedIn("Light", "Reflectivity");
  rows.AddFlag("--skybox", "shows the environment behind everything", all.Surface.Skybox)
    .Is(Option::SHAPES_SURFACE)
    .NamedIn("Light", "Show as sky");
  rows
    .AddChoice("--up", "AXIS", { "x", "y", "z" },
      "the up axis, @choices@, of --environment, the fitted camera, the ground, "
      "--texture-coordinates and the shadows of --markers (y with --preset none; else by "
      "the first file: y for models; z for data that is low along z, unless it stands on y "
      "= 0 like a figure; y or z for data that stands on y = 0 or on z = 0; else z for STL "
      "and grids with depth, y for others)",
      [&all](std::size_t place) { all.UpAxis = static_cast<int>(place); })
    .Is(Option::READS_FILES | Option::SHAPES_SURFACE)
    .NamedIn("Scene", "Up")
    .DropAs("the up axis");
  for (const PointStage& stage : GetPointStages())
  {
    vtkRelievoOption& points = rows.Add("--" + stage.Name, "FILE[,NAME=VALUE]...", stage.Help,
      [name = stage.Name](
        RenderOptions& of, const std::string& word) { TakePoints(of, name, word); });
    points.Repeats = true;
    points.Files = extensions;
    const vtkRelievoStageDescription& description =
      GetNewFrame()->GetStage(stage.Name)->GetDescription();
    const bool isLight = description.Slot == vtkRelievoStageDescription::SHADE;
    points.NamedIn(isLight ? "Light" : "Look", description.Label);
  }
  vtkRelievoOption& deferred =
    rows
      .Add("--deferred", "",
        "shades opaque surfaces once per pixel, after they are drawn: the same picture, but "
        "for fill lights, faster if many surfaces overlap",
        [](RenderOptions& options, const std::string&) {
          AddStage(options.Stages, "deferred", "--deferred");
        })
      .NamedIn("Look", "Deferred shading");
  deferred.Sets = "deferred";
  vtkRelievoOption& stage = rows.Add("--stage", "NAME[:PARAMETER=VALUE,...]",
    "runs a stage of the frame with these parameters; may be repeated; `relievo stages` lists them",
    TakeNext<&RenderOptions::Stages, ParseStage>);
  stage.Repeats = true;
  stage.Sets = "any";
  vtkRelievoOption& tone =
    rows
      .Add("--tone", "OPERATOR[,white=W]",
        "how light above 1 is shown in the picture: neutral, clamp, simple, reinhard or "
        "reinhard-rgb; W is the light that reinhard and reinhard-rgb show as white (neutral, if "
        "--exposure is given). The EXR stores the colour before the operator",
        TakeTone)
      .NamedIn("Look", "Tone");
  tone.Sets = "tone";
  tone.Words = { "neutral", "clamp", "simple", "reinhard", "reinhard-rgb" };
  vtkRelievoOption& exposure =
    rows
      .Add("--exposure", "STOPS",
        "multiplies the light by 2 to this power, -20 to 20; auto: makes the mean of the "
        "drawn pixels a middle grey (0)",
        TakeExposure)
      .NamedIn("Look", "Exposure");
  exposure.Sets = "tone";
  exposure.Words = { "auto" };
  vtkRelievoOption& layers =
    rows
      .Add("--layers", "A,B,...",
        "layers in the EXR besides its colour (depth): " +
          vtkRelievoLayerCatalogue::GetLayerNames() +
          " (shadow_N: visibility of the Nth --light, from 0: 1 lit, 0 dark), or the name of a "
          "point or cell array; with --times also flow, motion and flow_valid, towards the "
          "previous frame",
        TakeLayers)
      .Is(Option::OF_ALL_VIEWS);
  layers.Repeats = true;
  layers.OfOutputs = true;
  vtkRelievoOption& png =
    rows.Add("--png", "F", "the picture", [](RenderOptions& options, const std::string& word) {
      options.PNG = NamedAs(".png", "--png", word);
    });
  png.OfOutputs = true;
  png.Files = "png";
  rows
    .AddFlag("--transparent",
      "the picture without its background, RGBA; the ground shows only its shadows, as "
      "translucent black",
      all.Transparent)
    .RefuseLens("only a pinhole's picture can leave out its background")
    .OfOutputs = true;
  vtkRelievoOption& turn = rows.Add("--turntable", "N",
    "draws N frames while the camera goes once around the scene, about the up axis, "
    "counter-clockwise seen from above; the names of --png, --exr, --baseline and --report must "
    "contain %d or %04d, the frame number from 0. The fitted camera sees the scene in all frames",
    [](RenderOptions& options, const std::string& word) {
      options.Motion.Turntable = ParseWhole("--turntable", word, 2, 1000000);
    });
  turn.OfOutputs = true;
  vtkRelievoOption& path = rows.Add("--camera-path", "F",
    "draws frames of a camera that moves through the views of a JSON or CSV file, from the first "
    "one's time to the last one's by --fps, or at --times",
    [](RenderOptions& options, const std::string& word) { options.Motion.Path = word; });
  path.OfOutputs = true;
  path.Files = "json|csv";
  vtkRelievoOption& video = rows.Add("--video", "F",
    "a film of the frames of --turntable, --camera-path or --times: .mp4 (H.264) or .mkv (FFV1, "
    "lossless). The program ffmpeg makes it; where it is missing, the frames are written as PNG "
    "files beside it",
    TakePart<&RenderOptions::Motion, TakeVideo>);
  video.OfOutputs = true;
  video.Files = "mp4|mkv";
  rows.AddNumber("--fps", "N", "frames per second of --video and --camera-path, @bounds@ (25)",
    { 0.1, 1000.0 },
    [](RenderOptions& options, double rate) { options.Motion.FramesPerSecond = rate; });
  rows.Command.Options.back().OfOutputs = true;
  rows
    .AddFlag("--resume",
      "draws only the frames whose files do not exist, after an interrupted run; whether the "
      "existing files were drawn with the same options is not checked",
      all.Motion.Resume)
    .OfOutputs = true;
  vtkRelievoOption& exr = rows.Add("--exr", "F",
    "OpenEXR: the colour as R G B A, then the layers as depth.Z normal.X ...",
    [](RenderOptions& options, const std::string& word) {
      options.EXR = NamedAs(".exr", "--exr", word);
    });
  exr.OfOutputs = true;
  exr.Files = "exr";
  rows
    .AddFlag("--hdr", "stores the EXR's colour unclamped, as linear light in half floats", all.HDR)
    .OfOutputs = true;
  vtkRelievoOption& baseline = rows.Add("--baseline", "F",
    "OpenEXR for `relievo compare`: the picture, the layers that identify causes, and a record of "
    "objects, camera, lights and settings",
    [](RenderOptions& options, const std::string& word) {
      options.Baseline = NamedAs(".exr", "--baseline", word);
    });
  baseline.OfOutputs = true;
  baseline.Files = "exr";
  rows
    .AddFlag("--portable",
      "takes the baseline's ids, depth, normals and arrays from rays instead of OpenGL: equal on "
      "all processors and drivers; surfaces only",
      all.Portable)
    .OfOutputs = true;
  vtkRelievoOption& gltf = rows.Add("--gltf", "F",
    "glTF: the scene's surfaces with their colours, materials, lights and camera, in one .glb file "
    "that is read again and compared with the scene. With --times, --turntable or --camera-path a "
    "name without %d holds all frames as an animation",
    [](RenderOptions& options, const std::string& word) {
      options.Gltf = NamedAs(".glb", "--gltf", word);
    });
  gltf.OfOutputs = true;
  gltf.Files = "glb";
  vtkRelievoOption& report = rows.Add("--report", "F",
    "the frame report, JSON: which stages ran and why, GPU milliseconds, bytes held",
    [](RenderOptions& options, const std::string& word) { options.Report = word; });
  report.OfOutputs = true;
  report.Files = "json";
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
void CheckSaidOnce(const RenderOptions& options, const std::set<std::string>& given)
{
  const std::string byStage = StageChoice().Option;
  for (const StageChoice& own : options.Stages)
  {
    const bool isOwn = own.Option != byStage && own.Option != "--preset" && given.count(own.Option);
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
// Rejects options about shadows that have no effect without shadows.
void CheckShadowsAsked(const RenderOptions& options, const std::set<std::string>& given)
{
  const auto find = [&options](const std::string& parameter) {
    return FindStageChoice(options.Stages, "shadows", parameter);
  };
  const bool asked = find("enabled") ||
    std::any_of(options.Layers.begin(), options.Layers.end(),
      [](const std::string& name) { return vtkRelievoLayerCatalogue::GetLight(name) >= 0; });
  const bool sizes = given.count("--shadow-size") > 0;
  const bool softens = given.count("--soft-shadows") > 0;
  if (!asked && (sizes || softens))
  {
    throw UsageError(std::string(sizes ? "--shadow-size: there are no shadows to size"
                                       : "--soft-shadows: there are no shadows") +
      ": give --shadows map, --stage shadows, or a layer shadow_N, as well");
  }
  const std::string* method = find("method");
  if (given.count("--colored-shadows") && options.Image.Is != ImageChoice::Kind::Volume &&
    (!method || *method != "exact"))
  {
    throw UsageError("--colored-shadows: shadow maps store no colour of surfaces: give --shadows "
                     "exact as well, or a volume (--image volume)");
  }
  const bool sized =
    std::any_of(options.Lights.begin(), options.Lights.end(), [](const LightChoice& light) {
      return light.Size ? *light.Size > 0.0 : light.Is == LightChoice::Kind::Sun;
    });
  if (softens && !options.Lights.empty() && !sized && !find("lamp_radius"))
  {
    throw UsageError("--soft-shadows: no light has a size: give one, as in --light "
                     "point:PX,PY,PZ,size=RADIUS");
  }
}

//------------------------------------------------------------------------------
void CheckLens(const RenderOptions& options, const std::set<std::string>& given)
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
  for (const Option& option : GetRenderCommand().Options)
  {
    if (!option.NotWithLens.empty() && given.count(option.Name))
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
void CheckTogether(RenderOptions& options, const std::set<std::string>& given)
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
  if (options.Portable && options.Baseline.empty())
  {
    throw UsageError("--portable: describes a baseline: give --baseline F as well");
  }
  if (options.Portable && options.View.Clip)
  {
    throw UsageError("--portable and --clip: give one of them; the rays of a portable baseline do "
                     "not end at clipping distances");
  }
  if (options.HDR && options.EXR.empty())
  {
    throw UsageError("--hdr: unclamped colour is written to OpenEXR: give --exr F as well");
  }
  if (options.Transparent && options.PNG.empty())
  {
    throw UsageError("--transparent: it is the picture that has no background: give --png F as "
                     "well; the colour of the EXR has its alpha");
  }
  CheckLens(options, given);
  CheckModelOptions(options);
  CheckSequence(options, given);
  CheckLookOptions(options.Look, given);
  CheckStages(options.Stages);
  if (!options.Lights.empty())
  {
    const int lights = static_cast<int>(options.Lights.size());
    CheckShadowLayers(options, lights, lights == 1 ? "--light option" : "--light options");
  }
  CheckSurfaceOptions(options.Surface, given);
  CheckSaidOnce(options, given);
  CheckShadowsAsked(options, given);
}
}

//------------------------------------------------------------------------------
void CheckOutputs(const RenderOptions& options)
{
  if (options.Files.empty())
  {
    throw UsageError("render: no FILE given; see relievo render --help");
  }
  if (options.PNG.empty() && options.EXR.empty() && options.Baseline.empty() &&
    options.Gltf.empty() && options.Report.empty() && options.Motion.Video.empty() &&
    !options.Certify)
  {
    throw UsageError("render: nothing to write: give --png F, --exr F, --video F, "
                     "--baseline F.exr, --gltf F.glb, --report F.json or --certify N");
  }
}

//------------------------------------------------------------------------------
RenderOptions ParseOptions(const std::vector<std::string>& words)
{
  RenderOptions options;
  const std::set<std::string> seen = TakeArguments(words, DescribeRender(options),
    [&](const std::string& word) { options.Files.push_back(word); });
  // Options of points override --stage.
  std::stable_partition(options.Stages.begin(), options.Stages.end(),
    [](const StageChoice& choice) { return choice.Option.find(' ') == std::string::npos; });
  ApplyPreset(options, seen);
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
  CheckShadowWishes(options, seen);
  options.Surface.Shadowed = ShowsShadows(options);
  // Pictures without a preset, and those with an exposure, keep the environment's light.
  options.Surface.FindsIntensity = options.Preset != "none" &&
    FindWords(options.Surface.EnvironmentValues, "intensity").empty() &&
    std::none_of(options.Stages.begin(), options.Stages.end(),
      [](const StageChoice& stage) { return stage.Name == "tone"; });
  CheckTogether(options, seen);
  return options;
}
}
