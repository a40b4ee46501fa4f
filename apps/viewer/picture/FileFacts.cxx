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

#include <algorithm>
#include <set>

namespace viewer
{
namespace
{
// What the cells that have been seen are.
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

void AddNames(vtkDataSetAttributes* attributes, const char* suffix, std::set<std::string>& names)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    const char* name = attributes->GetArrayName(i);
    if (name && attributes->GetArray(i))
    {
      names.insert(std::string(name) + suffix);
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<FileFacts> GetFileFacts(const Picture& picture, const std::vector<std::string>& files)
{
  const scene::BareScene& scene = picture.GetScene().GetBare();
  vtkActorCollection* actors = scene.Get().Renderer->GetActors();
  std::vector<FileFacts> all;
  int next = 0;
  for (std::size_t i = 0; i < files.size() && i < scene.Get().Counts.size(); ++i)
  {
    FileFacts file;
    file.Path = files[i];
    Kinds kinds;
    vtkBoundingBox bounds;
    std::set<std::string> names;
    for (int left = scene.Get().Counts[i]; left > 0 && next < actors->GetNumberOfItems(); ++next)
    {
      vtkActor* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(next));
      if (!scene.Find(actor)) // a skeleton
      {
        continue;
      }
      --left;
      bounds.AddBounds(actor->GetBounds());
      scene::ForEachDataSet(actor->GetMapper()->GetInputDataObject(0, 0), [&](vtkDataSet* block) {
        kinds.Add(block);
        file.Points += block->GetNumberOfPoints();
        file.Cells += block->GetNumberOfCells();
        AddNames(block->GetPointData(), "", names);
        AddNames(block->GetCellData(), " (cells)", names);
      });
    }
    file.Kind = kinds.GetName();
    file.Arrays.assign(names.begin(), names.end());
    if (bounds.IsValid())
    {
      bounds.GetBounds(file.Bounds.data());
    }
    all.push_back(file);
  }
  return all;
}
}
