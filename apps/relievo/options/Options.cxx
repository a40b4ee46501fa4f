// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Errors.h"
#include "Presets.h"
#include "Readers.h"
#include "ShadowOptions.h"
#include "Shadows.h"
#include "SurfaceOptions.h"
#include "ToneOptions.h"
#include "Triples.h"
#include "Values.h"

#include "vtkRelievoLayerCatalogue.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace cli
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

double SineBetween(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  const std::array<double, 3> cross = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
  return Length(cross) / (Length(a) * Length(b));
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
}

//------------------------------------------------------------------------------
void TakeCamera(RenderOptions& options, const std::string& word)
{
  const std::vector<double> n = ParseNumbers("--camera", word, 9, "PX,PY,PZ,FX,FY,FZ,UX,UY,UZ");
  const CameraPlace camera = { Triple(n, 0), Triple(n, 3), Triple(n, 6) };
  const std::array<double, 3> direction = Minus(camera.FocalPoint, camera.Position);
  if (Length(direction) == 0.0)
  {
    RefuseValue("--camera", word, "a focal point FX,FY,FZ apart from the position PX,PY,PZ");
  }
  // Below this angle VTK chooses an up direction of its own, and the picture turns without a word.
  if (Length(camera.ViewUp) == 0.0 || SineBetween(direction, camera.ViewUp) < 1e-6)
  {
    RefuseValue("--camera", word, "an up direction UX,UY,UZ that is not along the view direction");
  }
  options.Camera = camera;
}

//------------------------------------------------------------------------------
void TakeClip(RenderOptions& options, const std::string& word)
{
  const std::vector<double> n = ParseNumbers("--clip", word, 2, "NEAR,FAR");
  if (n[0] <= 0.0 || n[1] <= n[0])
  {
    RefuseValue("--clip", word, "NEAR,FAR with 0 < NEAR < FAR");
  }
  options.Clip = { n[0], n[1] };
}

//------------------------------------------------------------------------------
void TakeShading(RenderOptions& options, const std::string& word)
{
  constexpr Shading kinds[] = { Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::PBR };
  options.ShadingKind =
    kinds[ParseChoice("--shading", word, { "flat", "gouraud", "phong", "pbr" })];
}

//------------------------------------------------------------------------------
void TakeShadows(RenderOptions& options, const std::string& word)
{
  constexpr Shadows methods[] = { Shadows::Off, Shadows::Map, Shadows::Forward, Shadows::Warped,
    Shadows::Exact };
  options.ShadowMethod =
    methods[ParseChoice("--shadows", word, { "off", "map", "forward", "warped", "exact" })];
}

//------------------------------------------------------------------------------
void TakeShadowSize(RenderOptions& options, const std::string& word)
{
  options.ShadowSize = ParseWhole("--shadow-size", word, SmallestShadowSize, LargestSize);
}

//------------------------------------------------------------------------------
void TakeSoftShadows(RenderOptions& options, const std::string& word)
{
  options.SoftShadows = ParseWhole("--soft-shadows", word, 1, MostSoftSamples);
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
template <std::string RenderOptions::*Member>
void TakePath(RenderOptions& options, const std::string& word)
{
  options.*Member = word;
}

//------------------------------------------------------------------------------
template <auto All, auto Parse>
void TakeNext(RenderOptions& options, const std::string& word)
{
  (options.*All).push_back(Parse(word));
}

//------------------------------------------------------------------------------
// A picture in another format than its name says would be a surprise.
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
struct OptionRow
{
  const char* Name;
  void (*Take)(RenderOptions&, const std::string& word);
  bool Repeats;
  bool IsFlag = false; // stands alone, without a value
};

const OptionRow RenderRows[] = {
  { "--size", TakeSize, false },
  { "--camera", TakeCamera, false },
  { "--view-angle",
    [](RenderOptions& options, const std::string& word) {
      options.ViewAngle = ParseNumberBetween("--view-angle", word, 0.0, 180.0);
    },
    false },
  { "--parallel-scale",
    [](RenderOptions& options, const std::string& word) {
      options.ParallelScale = ParseNumberBetween("--parallel-scale", word, 0.0, Infinity);
    },
    false },
  { "--clip", TakeClip, false },
  { "--shading", TakeShading, false },
  { "--preset", TakePreset, false },
  { "--color-by", TakeColorBy, false },
  { "--range", TakeRange, false },
  { "--colormap", TakeColormap, false },
  { "--scalar-bar",
    [](RenderOptions& options, const std::string&) { options.Look.ScalarBar = true; }, false,
    true },
  { "--color", TakeColor, false },
  { "--opacity", TakeOpacity, false },
  { "--edges", [](RenderOptions& options, const std::string&) { options.Look.Edges = true; }, false,
    true },
  { "--background", TakeBackground, false },
  { "--light", TakeNext<&RenderOptions::Lights, ParseLight>, true },
  { "--time", TakeTime, false },
  { "--times", TakeTimes, false },
  { "--animation", TakeAnimation, false },
  { "--blend", TakeBlend, false },
  { "--loop", TakeLoop, false, true },
  { "--skeleton", TakeSkeleton, false, true },
  { "--bone-weight", TakeBoneWeight, false },
  { "--skin", TakeSkin, false },
  { "--lamps", TakeLamps, true },
  { "--shadows", TakeShadows, false },
  { "--shadow-size", TakeShadowSize, false },
  { "--soft-shadows", TakeSoftShadows, false },
  { "--colored-shadows",
    [](RenderOptions& options, const std::string&) { options.ColoredShadows = true; }, false,
    true },
  { "--shadow-tolerance", TakeShadowTolerance, false },
  { "--time-budget", TakeTimeBudget, false },
  { "--certify", TakeCertify, false },
  { "--normal-map", TakePath<&RenderOptions::NormalMap>, false },
  { "--height-map", TakeHeightMap, false },
  { "--relief", TakeRelief, false },
  { "--texture-coordinates", TakeTextureCoordinates, false },
  { "--environment", TakeEnvironment, false },
  { "--reflectivity", TakeReflectivity, false },
  { "--skybox", [](RenderOptions& options, const std::string&) { options.Skybox = true; }, false,
    true },
  { "--up", TakeUp, false },
  { "--fog", TakeNext<&RenderOptions::Fogs, ParseFog>, true },
  { "--markers", TakeNext<&RenderOptions::Markers, ParseMarkers>, true },
  { "--stage", TakeNext<&RenderOptions::Stages, ParseStage>, true },
  { "--deferred",
    [](RenderOptions& options, const std::string&) {
      AddStage(options.Stages, "deferred", "--deferred");
    },
    false, true },
  { "--tone", TakeTone, false },
  { "--exposure", TakeExposure, false },
  { "--layers", TakeLayers, true },
  { "--hdr", [](RenderOptions& options, const std::string&) { options.HDR = true; }, false, true },
  { "--png",
    [](RenderOptions& options, const std::string& word) {
      options.PNG = NamedAs(".png", "--png", word);
    },
    false },
  { "--exr",
    [](RenderOptions& options, const std::string& word) {
      options.EXR = NamedAs(".exr", "--exr", word);
    },
    false },
  { "--report", TakePath<&RenderOptions::Report>, false },
};

//------------------------------------------------------------------------------
// Whether --stage sets a parameter of the shadows, to this value if there is one.
bool SetsShadows(
  const RenderOptions& options, const std::string& parameter, const std::string& value = {})
{
  return std::any_of(options.Stages.begin(), options.Stages.end(), [&](const StageChoice& stage) {
    return stage.Name == "shadows" &&
      std::any_of(stage.Parameters.begin(), stage.Parameters.end(), [&](const auto& given) {
        return given.first == parameter && (value.empty() || given.second == value);
      });
  });
}

//------------------------------------------------------------------------------
// An option and a parameter of --stage that set one thing may contradict each other.
void CheckShadowStage(const RenderOptions& options, const std::set<std::string>& given)
{
  constexpr std::pair<const char*, const char*> same[] = { { "--shadows", "visible" },
    { "--shadows", "method" }, { "--shadow-size", "map_size" },
    { "--soft-shadows", "soft_samples" }, { "--colored-shadows", "colored_shadows" } };
  for (const auto& [option, parameter] : same)
  {
    if (given.count(option) && SetsShadows(options, parameter))
    {
      throw UsageError(std::string(option) + " and --stage shadows:" + parameter +
        ": both set the same; give one of them");
    }
  }
}

//------------------------------------------------------------------------------
// Options about shadows where there are none would change nothing.
void CheckShadowsAsked(const RenderOptions& options, const std::set<std::string>& given)
{
  const bool asked = given.count("--shadows") != 0 || options.ShadowMethod != Shadows::Off ||
    SetsShadows(options, "visible") ||
    std::any_of(options.Layers.begin(), options.Layers.end(),
      [](const std::string& name) { return vtkRelievoLayerCatalogue::GetLight(name) >= 0; });
  if (!asked && (options.ShadowSize || options.SoftShadows))
  {
    throw UsageError(std::string(options.ShadowSize ? "--shadow-size: there are no shadows to size"
                                                    : "--soft-shadows: there are no shadows") +
      ": give --shadows map, --stage shadows:visible=on, or a layer shadow_N, as well");
  }
  if (options.ColoredShadows && options.ShadowMethod != Shadows::Exact &&
    !SetsShadows(options, "method", "exact"))
  {
    throw UsageError("--colored-shadows: maps know no colours: give --shadows exact as well");
  }
  const bool sized =
    std::any_of(options.Lights.begin(), options.Lights.end(), [](const LightChoice& light) {
      return light.Size ? *light.Size > 0.0 : light.Is == LightChoice::Kind::Sun;
    });
  if (options.SoftShadows && !options.Lights.empty() && !sized &&
    !SetsShadows(options, "lamp_radius"))
  {
    throw UsageError("--soft-shadows: no light has a size: give one, as in --light "
                     "point:PX,PY,PZ,size=RADIUS");
  }
}

//------------------------------------------------------------------------------
void CheckTogether(RenderOptions& options, const std::set<std::string>& given)
{
  if (options.Files.empty())
  {
    throw UsageError("render: no FILE given; see relievo --help");
  }
  if (options.PNG.empty() && options.EXR.empty() && options.Report.empty() && !options.Certify)
  {
    throw UsageError(
      "render: nothing to write: give --png F, --exr F, --report F.json or --certify N");
  }
  if (options.ViewAngle && options.ParallelScale)
  {
    throw UsageError("--view-angle and --parallel-scale: give one of them; a parallel projection "
                     "has no view angle");
  }
  if (!options.Layers.empty() && options.EXR.empty() && options.Report.empty())
  {
    throw UsageError("--layers: layers are written to OpenEXR: give --exr F as well");
  }
  if (options.HDR && options.EXR.empty())
  {
    throw UsageError("--hdr: unclamped colour is written to OpenEXR: give --exr F as well");
  }
  CheckModelOptions(options);
  CheckLookOptions(options, given);
  CheckToneOptions(options);
  CheckFogs(options.Fogs);
  CheckStages(options.Stages);
  if (!options.Lights.empty())
  {
    const int lights = static_cast<int>(options.Lights.size());
    CheckShadowLayers(options, lights, lights == 1 ? "--light option" : "--light options");
  }
  CheckSurfaceOptions(options, given);
  CheckShadowStage(options, given);
  CheckShadowsAsked(options, given);
}
}

//------------------------------------------------------------------------------
std::vector<KnownOption> GetRenderOptions()
{
  std::vector<KnownOption> known;
  for (const OptionRow& row : RenderRows)
  {
    known.push_back({ row.Name, row.IsFlag, row.Repeats });
  }
  return known;
}

//------------------------------------------------------------------------------
RenderOptions ParseRender(const std::vector<std::string>& words)
{
  RenderOptions options;
  std::set<std::string> seen;
  ParseArguments(
    words, "render", GetRenderOptions(),
    [&](const std::string& name, const std::string& value) {
      const auto row = std::find_if(std::begin(RenderRows), std::end(RenderRows),
        [&name](const OptionRow& candidate) { return name == candidate.Name; });
      if (!seen.insert(name).second && !row->Repeats)
      {
        throw UsageError(name + ": given twice, expected once");
      }
      if (value.empty() && !row->IsFlag)
      {
        throw UsageError(name + ": its value is empty; see relievo --help");
      }
      row->Take(options, value);
    },
    [&](const std::string& word) { options.Files.push_back(word); });
  ApplyPreset(options, seen);
  CheckShadowWishes(options, seen);
  CheckTogether(options, seen);
  return options;
}
}
