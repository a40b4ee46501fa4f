// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bands.h"

#include "Flow.h"
#include "Messages.h"
#include "Options.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace scene
{
namespace
{
// Pixels of the largest picture that is drawn whole, and of a band.
constexpr std::int64_t MostPixels = std::int64_t(1) << 24;
constexpr std::int64_t BandPixels = std::int64_t(1) << 22;

// Patterns of noise have 64 x 64 pixels: bands begin at multiples of that.
constexpr int Step = 64;

// Rows below and above a band that are drawn with it: lines, markers and filters reach less far.
constexpr int Margin = 32;

// The option whose output needs the whole picture at once; empty: none.
std::string FindWhole(const RenderOptions& options)
{
  const auto has = [&options](const char* stage, const char* parameter) {
    const std::string* given = FindStageChoice(options.Stages, stage, parameter);
    return given ? *given : std::string();
  };
  const bool flows = std::any_of(options.Layers.begin(), options.Layers.end(),
    [&options](const std::string& name) { return IsFlowOfFrames(options, name); });
  return !options.Lens.empty()               ? "--lens"
    : !options.Baseline.empty()              ? "--baseline"
    : !options.Gltf.empty()                  ? "--gltf"
    : !options.Report.empty()                ? "--report"
    : options.Has("--certify")               ? "--certify"
    : options.Look.Grid                      ? "--grid"
    : options.Look.PointSize > 2 * Margin    ? "--point-size"
    : flows                                  ? "the layer flow"
    : has("tone", "auto_exposure") == "on"   ? "the automatic exposure of tone"
    : !has("display", "layer").empty()       ? "a layer that is shown in colours"
    : !has("shadows", "time_budget").empty() ? "--time-budget"
                                             : "";
}
}

//------------------------------------------------------------------------------
int ChooseBandRows(const RenderOptions& options, int wanted)
{
  const std::int64_t width = options.Size[0];
  const bool large = width * options.Size[1] > MostPixels;
  const std::string whole = large || wanted > 0 ? FindWhole(options) : "";
  if (!whole.empty())
  {
    Messages::Note("--size " + std::to_string(options.Size[0]) + "x" +
      std::to_string(options.Size[1]) + ": the picture is drawn at once, which takes more memory " +
      "than bands of it: " + whole + " needs all of it");
    return 0;
  }
  const std::int64_t rows = wanted > 0 ? wanted : large ? BandPixels / width : 0;
  if (rows == 0)
  {
    return 0;
  }
  return std::max(3 * Step, static_cast<int>(rows) / Step * Step);
}

//------------------------------------------------------------------------------
Bands::Bands(const std::array<int, 2>& size, int rows)
  : Size(size)
  , Rows(rows > 0 && rows < size[1] ? rows : size[1])
  , Count(1)
{
  if (this->Rows < size[1])
  {
    // The first row of all is the end of the lowest band, which has no margin below it.
    const int each = this->Rows - 2 * Margin;
    this->Count = (size[1] - Margin - 1) / each + 1;
  }
}

//------------------------------------------------------------------------------
Bands::Band Bands::Get(int number) const
{
  if (this->Count == 1)
  {
    return { 0, 0, this->Size[1] };
  }
  const int each = this->Rows - 2 * Margin;
  const int place = this->Count - 1 - number; // from the bottom
  const int drawn = place * each;
  return { drawn, place > 0 ? drawn + Margin : 0,
    number > 0 ? drawn + each + Margin : this->Size[1] };
}

//------------------------------------------------------------------------------
void Bands::SetTiles(vtkRenderWindow* window, vtkRenderer* renderer) const
{
  const int tiles = this->Count > 1 ? (this->Size[1] - 1) / this->Rows + 2 : 1;
  window->SetTileScale(1, tiles);
  renderer->SetViewport(0.0, 0.0, 1.0, this->Size[1] / (static_cast<double>(tiles) * this->Rows));
}
}
