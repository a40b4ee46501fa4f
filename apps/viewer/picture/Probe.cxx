// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Probe.h"

#include "LayerWords.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRenderer.h"
#include "vtkVolumeCollection.h"

#include <cmath>
#include <iterator>

namespace viewer
{
namespace
{
const char* const Always[] = { "depth", "range", "position", "normal", "actor", "block", "cell" };
const char* const OfVolumes[] = { "volume_depth", "volume_position", "volume_value",
  "volume_opacity", "volume" };
}

//------------------------------------------------------------------------------
std::vector<ProbeValue> Probe::Read(
  vtkRenderer* renderer, const std::vector<std::string>& arrays, int x, int y)
{
  std::vector<ProbeValue> values;
  if (!renderer)
  {
    return values;
  }
  std::vector<std::string> layers(std::begin(Always), std::end(Always));
  if (renderer->GetVolumes()->GetNumberOfItems() > 0)
  {
    layers.insert(layers.end(), std::begin(OfVolumes), std::end(OfVolumes));
  }
  layers.insert(layers.end(), arrays.begin(), arrays.end());
  if (!this->Image)
  {
    vtkNew<vtkRelievoLayerSource> source;
    source->SetRenderer(renderer);
    for (const std::string& layer : layers)
    {
      source->AddLayer(layer);
    }
    source->Update();
    this->Image = source->GetOutput();
  }
  const int* size = this->Image->GetDimensions();
  if (x < 0 || y < 0 || x >= size[0] || y >= size[1])
  {
    return values;
  }
  const vtkIdType pixel = static_cast<vtkIdType>(y) * size[0] + x;
  const auto isBackground = [this, pixel](const char* layer) {
    vtkDataArray* depth = this->Image->GetPointData()->GetArray(layer);
    return !depth || !std::isfinite(depth->GetComponent(pixel, 0));
  };
  const bool empty = isBackground("depth");
  const bool beside = isBackground("volume_depth");
  // With `solid` of the stage volumes, depth, range and position are a volume's where it is nearer.
  vtkDataArray* actors = this->Image->GetPointData()->GetArray("actor");
  const bool background = empty || (!beside && actors && actors->GetComponent(pixel, 0) < 0.0);
  const auto isOfBoth = [](const std::string& layer) {
    return layer == "depth" || layer == "range" || layer == "position";
  };
  for (const std::string& layer : layers)
  {
    if (vtkDataArray* array = this->Image->GetPointData()->GetArray(layer.c_str()))
    {
      ProbeValue value = { layer, {},
        relievoQt::IsOfVolume(layer) ? beside && layer != "volume_opacity"
          : isOfBoth(layer)          ? empty
                                     : background };
      for (int i = 0; i < array->GetNumberOfComponents(); ++i)
      {
        value.Values.push_back(array->GetComponent(pixel, i));
      }
      values.push_back(value);
    }
  }
  return values;
}
}
