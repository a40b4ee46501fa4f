// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Probe.h"

#include "DataSets.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRelievoArraySampler.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoLayerSource.h"
#include "vtkRenderer.h"

#include <cmath>

namespace viewer
{
namespace
{
const char* const Always[] = { "depth", "range", "position", "normal", "actor", "block", "cell" };
}

//------------------------------------------------------------------------------
std::vector<std::string> Probe::GetLayers(const std::set<std::string>& arrays)
{
  std::vector<std::string> layers(std::begin(Always), std::end(Always));
  for (const std::string& name : arrays)
  {
    if (!vtkRelievoLayerCatalogue::GetIsLayer(name)) // whose values are not the array's
    {
      layers.push_back(name);
    }
  }
  return layers;
}

//------------------------------------------------------------------------------
// Arrays with more components than layers can have; one of them would spoil all values.
static std::set<std::string> FindWide(vtkRenderer* renderer)
{
  std::set<std::string> wide;
  vtkActorCollection* actors = renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkMapper* mapper = vtkActor::SafeDownCast(actors->GetItemAsObject(i))->GetMapper();
    vtkDataObject* data = mapper ? mapper->GetInputDataObject(0, 0) : nullptr;
    cli::ForEachDataSet(data, [&wide](vtkDataSet* block) {
      for (vtkDataSetAttributes* attributes :
        { static_cast<vtkDataSetAttributes*>(block->GetPointData()),
          static_cast<vtkDataSetAttributes*>(block->GetCellData()) })
      {
        for (int k = 0; k < attributes->GetNumberOfArrays(); ++k)
        {
          vtkDataArray* array = attributes->GetArray(k);
          if (array && array->GetName() &&
            array->GetNumberOfComponents() > vtkRelievoArraySampler::MaximumComponents)
          {
            wide.insert(array->GetName());
          }
        }
      }
    });
  }
  return wide;
}

//------------------------------------------------------------------------------
std::vector<ProbeValue> Probe::Read(
  vtkRenderer* renderer, const std::set<std::string>& arrays, int x, int y)
{
  std::vector<ProbeValue> values;
  if (!renderer)
  {
    return values;
  }
  const std::vector<std::string> layers = GetLayers(arrays);
  if (!this->Image)
  {
    vtkNew<vtkRelievoLayerSource> source;
    source->SetRenderer(renderer);
    const std::set<std::string> wide = FindWide(renderer);
    for (const std::string& layer : layers)
    {
      if (wide.count(layer) == 0)
      {
        source->AddLayer(layer);
      }
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
  vtkDataArray* depth = this->Image->GetPointData()->GetArray("depth");
  const bool background = !depth || !std::isfinite(depth->GetComponent(pixel, 0));
  for (const std::string& layer : layers)
  {
    if (vtkDataArray* array = this->Image->GetPointData()->GetArray(layer.c_str()))
    {
      ProbeValue value = { layer, {}, background };
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
