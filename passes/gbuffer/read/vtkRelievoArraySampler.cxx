// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoArraySampler.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();

const void* GetData(const vtkRelievoDrawTable::Hit& hit)
{
  return hit.Mesh ? static_cast<const void*>(hit.Mesh) : hit.Points;
}

// The array if it has a tuple for every point or cell, else nullptr.
vtkDataArray* GetArray(vtkDataSetAttributes* attributes, const std::string& name, vtkIdType count)
{
  vtkDataArray* array = attributes->GetArray(name.c_str());
  return array && array->GetNumberOfTuples() >= count ? array : nullptr;
}
}

//------------------------------------------------------------------------------
vtkRelievoArraySampler::vtkRelievoArraySampler(
  const std::string& layer, const vtkRelievoDrawTable& draws, const vtkRelievoFrameCamera& view)
  : Name(layer)
  , Draws(draws)
  , View(view)
{
  if (layer.compare(0, 6, "point:") == 0)
  {
    this->Name = layer.substr(6);
    this->AllowCells = false;
  }
  else if (layer.compare(0, 5, "cell:") == 0)
  {
    this->Name = layer.substr(5);
    this->AllowPoints = false;
  }
}

//------------------------------------------------------------------------------
vtkRelievoArraySampler::Source vtkRelievoArraySampler::Find(vtkDataSet* data, bool cells) const
{
  Source source;
  if (this->AllowPoints)
  {
    source.Array = GetArray(data->GetPointData(), this->Name, data->GetNumberOfPoints());
    source.OfPoints = source.Array != nullptr;
  }
  if (!source.Array && this->AllowCells && cells)
  {
    source.Array = GetArray(data->GetCellData(), this->Name, data->GetNumberOfCells());
  }
  return source;
}

//------------------------------------------------------------------------------
bool vtkRelievoArraySampler::Take(vtkDataArray* array)
{
  if (array)
  {
    this->Components = std::max(this->Components, array->GetNumberOfComponents());
    this->Wide = this->Wide || (array->GetDataType() != VTK_FLOAT && array->GetDataTypeSize() >= 4);
  }
  return array != nullptr;
}

//------------------------------------------------------------------------------
bool vtkRelievoArraySampler::FindHidden(vtkRenderer* renderer)
{
  vtkNew<vtkPropCollection> parts;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    prop->GetActors(parts); // parts of assemblies included
  }
  bool found = false;
  const auto look = [&](vtkDataObject* data) {
    if (auto* set = vtkDataSet::SafeDownCast(data))
    {
      found = this->Take(this->Find(set, true).Array) || found;
    }
  };
  parts->InitTraversal(it);
  while (vtkProp* part = parts->GetNextProp(it))
  {
    auto* actor = vtkActor::SafeDownCast(part);
    vtkDataObject* data =
      actor && actor->GetMapper() && actor->GetMapper()->GetNumberOfInputPorts() > 0
      ? actor->GetMapper()->GetInputDataObject(0, 0)
      : nullptr;
    look(data);
    if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
    {
      auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
      for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
      {
        look(leaf->GetCurrentDataObject());
      }
    }
  }
  return found;
}

//------------------------------------------------------------------------------
int vtkRelievoArraySampler::Prepare(vtkRenderer* renderer, int& components, std::string& error)
{
  const std::vector<vtkRelievoDrawTable::Hit> meshes = this->Draws.GetMeshes();
  for (const vtkRelievoDrawTable::Hit& hit : meshes)
  {
    Source source;
    if (hit.Mesh)
    {
      source = this->Find(hit.Mesh, true);
    }
    else if (hit.Points)
    {
      source = this->Find(hit.Points, false);
    }
    if (this->Take(source.Array))
    {
      this->Sources[Key(hit.Prop, GetData(hit))] = source;
    }
  }
  if (this->Sources.empty() && !meshes.empty() && !(renderer && this->FindHidden(renderer)))
  {
    error =
      "it is neither a layer nor a point or cell array of any data in the renderer. Layers are " +
      vtkRelievoLayerCatalogue::GetLayerNames();
  }
  else if (this->Components > MaximumComponents)
  {
    error = "it has " + std::to_string(this->Components) + " components, but at most " +
      std::to_string(MaximumComponents) + " are read";
  }
  this->Components = std::max(1, this->Components);
  components = this->Components;
  return this->Wide ? VTK_DOUBLE : VTK_FLOAT;
}

//------------------------------------------------------------------------------
void vtkRelievoArraySampler::Enter(std::uint32_t word, Place& place) const
{
  if (word == place.Word)
  {
    return;
  }
  place.Word = word;
  place.Hit = this->Draws.Find(word);
  place.Values = Source();
  if (!place.Hit.Prop || place.Hit.Cell < 0)
  {
    return;
  }
  auto found = this->Sources.find(Key(place.Hit.Prop, GetData(place.Hit)));
  if (found == this->Sources.end())
  {
    return;
  }
  place.Values = found->second;
  if (place.Hit.Mesh && place.Values.OfPoints)
  {
    place.Geometry = vtkRelievoCellGeometry(place.Hit, place.Scratch);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoArraySampler::Sample(
  const Place& place, int x, int y, const glm::dvec3* eye, double* values) const
{
  std::fill(values, values + this->Components, NoValue);
  vtkDataArray* array = place.Values.Array;
  if (!array)
  {
    return;
  }
  if (place.Hit.Mesh && place.Values.OfPoints)
  {
    this->SampleInCell(place, x, y, eye, values);
  }
  else if (place.Hit.Cell < array->GetNumberOfTuples())
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      values[c] = array->GetComponent(place.Hit.Cell, c);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoArraySampler::SampleInCell(
  const Place& place, int x, int y, const glm::dvec3* eye, double* values) const
{
  const vtkRelievoCellGeometry& geometry = place.Geometry;
  vtkDataArray* array = place.Values.Array;
  vtkRelievoPixelRay ray(this->View, *place.Hit.ViewToModel, x, y);
  if (eye)
  {
    ray.From = glm::dvec3(*place.Hit.ViewToModel * glm::dvec4(*eye, 1.0));
    ray.Along = glm::dvec3(*place.Hit.ViewToModel * glm::dvec4(*eye, 0.0));
  }
  double weights[3];
  geometry.GetWeights(ray.From, ray.Along, weights);
  for (int c = 0; c < array->GetNumberOfComponents() && geometry.Count > 0; ++c)
  {
    values[c] = 0.0;
    for (int i = 0; i < geometry.Count; ++i)
    {
      // A zero weight must not multiply a NaN or an infinity at the other corner.
      if (weights[i] > 0.0)
      {
        values[c] += weights[i] * array->GetComponent(geometry.Points[i], c);
      }
    }
  }
}
