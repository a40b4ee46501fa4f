// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileFacts.h"

#include "DataSets.h"
#include "Picture.h"

#include "vtkActorCollection.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace viewer
{
namespace
{
// The kind of the cells so far.
struct Kinds
{
  bool Triangles = false;
  bool Polygons = false;
  bool Lines = false;
  bool Points = false;
  bool Others = false;

  void Add(vtkDataSet* block)
  {
    auto* mesh = vtkPolyData::SafeDownCast(block);
    if (!mesh)
    {
      this->Others = true;
      return;
    }
    const bool flat = mesh->GetNumberOfPolys() > 0;
    const bool small = flat && mesh->GetPolys()->GetMaxCellSize() <= 3;
    this->Triangles = this->Triangles || small;
    this->Polygons = this->Polygons || (flat && !small);
    this->Lines = this->Lines || mesh->GetNumberOfLines() > 0;
    this->Points = this->Points || mesh->GetNumberOfVerts() > 0;
    this->Others = this->Others || mesh->GetNumberOfStrips() > 0;
  }

  const char* GetName() const
  {
    const int kinds = this->Triangles + this->Polygons + this->Lines + this->Points;
    return this->Others || kinds > 1 + (this->Triangles && this->Polygons) ? "cells"
      : this->Polygons                                                     ? "polygons"
      : this->Triangles                                                    ? "triangles"
      : this->Lines                                                        ? "lines"
      : this->Points                                                       ? "points"
                                                                           : "cells";
  }
};

// Collects properties from the actors and volumes of one file.
struct Contents
{
  FileFacts Facts;
  Kinds Is;
  vtkBoundingBox Bounds;
  std::set<vtkTexture*> Textures;
  std::map<std::pair<std::string, bool>, ArrayFacts> Arrays; // by name, and whether of cells

  void AddArrays(vtkDataSetAttributes* attributes, bool ofCells, bool ranges)
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (!array || !array->GetName())
      {
        continue;
      }
      ArrayFacts& known = this->Arrays[{ array->GetName(), ofCells }];
      known.Name = array->GetName();
      known.OfCells = ofCells;
      known.Type = array->GetDataTypeAsString();
      known.Components = std::max(known.Components, array->GetNumberOfComponents());
      std::array<double, 2> range = { 1.0, -1.0 };
      if (ranges)
      {
        array->GetFiniteRange(range.data(), array->GetNumberOfComponents() > 1 ? -1 : 0);
      }
      const bool first = known.Range[0] > known.Range[1];
      if (range[0] <= range[1])
      {
        known.Range = first ? range
                            : std::array<double, 2>{ std::min(known.Range[0], range[0]),
                                std::max(known.Range[1], range[1]) };
      }
    }
  }

  void Add(vtkProp3D* prop, vtkDataObject* data, bool ranges)
  {
    ++this->Facts.Parts;
    this->Bounds.AddBounds(prop->GetBounds());
    reading::ForEachDataSet(data, [&](vtkDataSet* block) {
      this->Is.Add(block);
      this->Facts.Points += block->GetNumberOfPoints();
      this->Facts.Cells += block->GetNumberOfCells();
      this->AddArrays(block->GetPointData(), false, ranges);
      this->AddArrays(block->GetCellData(), true, ranges);
    });
  }

  void AddTextures(vtkActor* actor)
  {
    if (actor->GetTexture())
    {
      this->Textures.insert(actor->GetTexture());
    }
    for (const auto& texture : actor->GetProperty()->GetAllTextures())
    {
      this->Textures.insert(texture.second);
    }
  }

  FileFacts Get()
  {
    this->Facts.Kind = this->Is.GetName();
    this->Facts.Textures = static_cast<int>(this->Textures.size());
    for (const auto& array : this->Arrays)
    {
      this->Facts.Arrays.push_back(array.second);
    }
    if (this->Bounds.IsValid())
    {
      this->Bounds.GetBounds(this->Facts.Bounds.data());
    }
    return this->Facts;
  }
};
}

//------------------------------------------------------------------------------
std::vector<FileFacts> GetFileFacts(
  const Picture& picture, const std::vector<std::string>& files, bool ranges)
{
  const scene::StyledScene& shown = picture.GetScene();
  const scene::Scene& scene = shown.GetScene();
  vtkActorCollection* actors = scene.Renderer->GetActors();
  vtkVolumeCollection* volumes = scene.Renderer->GetVolumes();
  std::vector<FileFacts> all;
  int next = 0, nextVolume = 0;
  for (std::size_t i = 0; i < files.size() && i < scene.Counts.size(); ++i)
  {
    Contents file;
    file.Facts.Path = files[i];
    file.Facts.Dimensions = scene.Dimensions[i];
    for (int left = scene.Counts[i]; left > 0 && next < actors->GetNumberOfItems(); ++next)
    {
      vtkActor* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(next));
      if (!shown.IsOfFiles(actor)) // a skeleton
      {
        continue;
      }
      --left;
      file.Add(actor, actor->GetMapper()->GetInputDataObject(0, 0), ranges);
      file.AddTextures(actor);
    }
    if (scene.Counts[i] == 0 && nextVolume < volumes->GetNumberOfItems())
    {
      auto* volume = vtkVolume::SafeDownCast(volumes->GetItemAsObject(nextVolume++));
      file.Add(volume, volume->GetMapper()->GetInputDataObject(0, 0), ranges);
    }
    all.push_back(file.Get());
  }
  return all;
}
}
