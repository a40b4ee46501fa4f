// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLightDepthStage.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoReportOnce.h"
#include "vtkRelievoScreenQuad.h"
#include "vtkRelievoScreenTarget.h"
#include "vtkRelievoShadowContext.h"
#include "vtkRelievoShadowStrengths.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkRelievoLightDepthStage);

namespace
{
const char* const Layer = "light_depth";
constexpr int MostColumns = 3;

// The largest area with the map's shape, centred in a cell of the picture.
std::array<int, 4> GetArea(
  const vtkRelievoShadowView& view, const int* picture, int maps, int number)
{
  const int columns = std::min(maps, MostColumns);
  const int rows = (maps + columns - 1) / columns;
  const int cell[2] = { picture[2] / columns, picture[3] / rows };
  const double scale = std::min(cell[0] / view.Width, cell[1] / view.Height);
  const int size[2] = { std::max(1, static_cast<int>(std::lround(scale * view.Width))),
    std::max(1, static_cast<int>(std::lround(scale * view.Height))) };
  return { (number % columns) * cell[0] + (cell[0] - size[0]) / 2,
    (rows - 1 - number / columns) * cell[1] + (cell[1] - size[1]) / 2, size[0], size[1] };
}
}

class vtkRelievoLightDepthStage::Internals
{
public:
  vtkRelievoScreenTarget Target{ "relievoLightDepth" };
  vtkRelievoScreenQuad Quad;
  vtkRelievoReportOnce Reported;

  const vtkRelievoShadowCache::Entry* Find(const vtkRelievoShadowContext* work, int light) const
  {
    if (!work)
    {
      return nullptr;
    }
    const auto& entries = work->Cache.GetEntries();
    const auto found = std::find_if(entries.begin(), entries.end(),
      [light](const auto& entry) { return light < 0 || entry.Light.Number == light; });
    return found == entries.end() ? nullptr : &*found;
  }
};

//------------------------------------------------------------------------------
vtkRelievoLightDepthStage::vtkRelievoLightDepthStage()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkRelievoLightDepthStage::~vtkRelievoLightDepthStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoLightDepthStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = Layer;
  description.Label = "Light's Depth";
  description.Help = "Shows the depth in a light's shadow maps.";
  description.Slot = vtkRelievoStageDescription::COMPOSITE;
  description.Reads = {
    vtkRelievoResources::Visibility
  }; // whether or not the picture shows shadows
  description.Layers = { Layer };
  description.OnByDefault = true;
  description.AddWhole(
    "light", this->Light, [this](int light) { this->SetLight(light); }, -1, 999, "",
    "Number of the light among the renderer's lights; -1: the first that casts.");
}

//------------------------------------------------------------------------------
void vtkRelievoLightDepthStage::Execute(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  this->DrawCalls = 0;
  vtkRelievoScreenTarget::Format format;
  format.Channels = 1;
  format.Halves = false;
  std::string error = in.Target.Prepare(context, format);
  const auto* shadows =
    static_cast<vtkRelievoShadowStrengths*>(context.Find(vtkRelievoResources::ShadowMaps));
  const vtkRelievoShadowContext* work = shadows ? shadows->GetWork() : nullptr;
  const vtkRelievoShadowCache::Entry* entry = in.Find(work, this->Light);
  vtkShaderProgram* program = nullptr;
  if (error.empty() && entry)
  {
    program = in.Quad.Ready(context, "shadow/lightDepthFS.glsl", {});
    error = in.Quad.GetError();
  }
  if (in.Reported.IsChange(error))
  {
    vtkErrorMacro("No " << Layer << ": " << error << ".");
  }
  if (!error.empty())
  {
    this->Explain("failed", error);
    return;
  }
  in.Target.Begin(context, std::numeric_limits<float>::infinity());
  const int maps = entry ? static_cast<int>(entry->Maps.size()) : 0;
  for (int i = 0; i < maps; ++i)
  {
    const vtkRelievoShadowCache::Map& map = entry->Maps[i];
    if (!(map.View.Width > 0.0 && map.View.Height > 0.0))
    {
      continue;
    }
    const std::array<int, 4> area = GetArea(map.View, in.Target.GetArea(), maps, i);
    const float range[3] = { static_cast<float>(map.View.Near), static_cast<float>(map.View.Far),
      map.View.Parallel ? 1.0f : 0.0f };
    program->SetUniformi("relievoLightMaps", work->Maps.GetTextureUnit());
    program->SetUniform3f("relievoLightRange", range);
    program->SetUniformf("relievoLightLayer", static_cast<float>(map.Layer));
    in.Quad.Draw(context, area.data());
    ++this->DrawCalls;
  }
  in.Target.End();
  context.ProvideLayer(Layer, &in.Target);
  this->Explain(maps > 0 ? "ran" : "idle",
    maps > 0 ? "shows " + std::to_string(maps) + (maps == 1 ? " map" : " maps") + " of light " +
        std::to_string(entry->Light.Number)
      : entry           ? "light " + std::to_string(entry->Light.Number) + " has no map"
      : this->Light < 0 ? "no light casts"
                        : "light " + std::to_string(this->Light) + " casts no shadow");
}

//------------------------------------------------------------------------------
std::string vtkRelievoLightDepthStage::ReadLayers(
  const std::vector<std::string>& names, vtkImageData* image)
{
  for (const std::string& name : names)
  {
    const std::string error = this->Internal->Target.Read(name, 1, image);
    if (!error.empty())
    {
      return "The layer '" + name + "' cannot be read: " + error + ".";
    }
  }
  return {};
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoLightDepthStage::GetBytesHeld()
{
  return this->Internal->Target.GetBytes();
}

//------------------------------------------------------------------------------
void vtkRelievoLightDepthStage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Target.Release(window);
  this->Internal->Quad.Release(window);
  this->DrawCalls = 0;
  this->Superclass::ReleaseGraphicsResources(window);
}
