// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputOptions.h"

#include "Errors.h"
#include "OptionRows.h"
#include "Options.h"
#include "Readers.h"
#include "Values.h"

#include "vtkRelievoLayerCatalogue.h"

#include <algorithm>

namespace scene
{
namespace
{
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
}

//------------------------------------------------------------------------------
void AddPictureOptions(OptionRows& rows, RenderOptions& all)
{
  vtkRelievoOption& layers =
    rows
      .Add("--layers", "A,B,...",
        "layers in the EXR besides its colour (depth): " +
          vtkRelievoLayerCatalogue::GetLayerNames() +
          " (shadow_N: visibility of the Nth --light, from 0: 1 lit, 0 dark), or the name of a "
          "point or cell array; with --times also flow, motion and flow_valid, towards the "
          "previous frame",
        all, TakeLayers)
      .Is(OptionRows::Option::OF_ALL_VIEWS);
  layers.Repeats = true;
  layers.OfOutputs = true;
  vtkRelievoOption& png = rows.Add("--png", "F", "the picture",
    [&all](const std::string& word) { all.PNG = NamedAs(".png", "--png", word); });
  png.OfOutputs = true;
  png.Files = "png";
  rows
    .AddFlag("--transparent",
      "the picture without its background, RGBA; the ground shows only its shadows, as "
      "translucent black")
    .RefuseLens("only a pinhole's picture can leave out its background")
    .OfOutputs = true;
}

//------------------------------------------------------------------------------
void AddOutputOptions(OptionRows& rows, RenderOptions& all)
{
  vtkRelievoOption& exr = rows.Add("--exr", "F",
    "OpenEXR: the colour as R G B A, then the layers as depth.Z normal.X ...",
    [&all](const std::string& word) { all.EXR = NamedAs(".exr", "--exr", word); });
  exr.OfOutputs = true;
  exr.Files = "exr";
  rows.AddFlag("--hdr", "stores the EXR's colour unclamped, as linear light in half floats")
    .OfOutputs = true;
  vtkRelievoOption& baseline = rows.Add("--baseline", "F",
    "OpenEXR for `relievo compare`: the picture, the layers that identify causes, and a record of "
    "objects, camera, lights and settings",
    [&all](const std::string& word) { all.Baseline = NamedAs(".exr", "--baseline", word); });
  baseline.OfOutputs = true;
  baseline.Files = "exr";
  rows
    .AddFlag("--portable",
      "takes the baseline's ids, depth, normals and arrays from rays instead of OpenGL: equal on "
      "all processors and drivers; surfaces only")
    .OfOutputs = true;
  vtkRelievoOption& gltf = rows.Add("--gltf", "F",
    "glTF: the scene's surfaces with their colours, materials, lights and camera, in one .glb file "
    "that is read again and compared with the scene. With --times, --turntable or --camera-path a "
    "name without %d holds all frames as an animation",
    [&all](const std::string& word) { all.Gltf = NamedAs(".glb", "--gltf", word); });
  gltf.OfOutputs = true;
  gltf.Files = "glb";
  vtkRelievoOption& report = rows.AddText("--report", "F",
    "the frame report, JSON: which stages ran and why, GPU milliseconds, bytes held", all.Report);
  report.OfOutputs = true;
  report.Files = "json";
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
    !options.Has("--certify"))
  {
    throw UsageError("render: nothing to write: give --png F, --exr F, --video F, "
                     "--baseline F.exr, --gltf F.glb, --report F.json or --certify N");
  }
}
}
