// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGlyphDraws.h"

#include "vtkBitArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkRelievoAccess.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{
bool IsDrawn(vtkDataObject* source)
{
  auto* mesh = vtkPolyData::SafeDownCast(source);
  return mesh && mesh->GetNumberOfPoints() > 0 && mesh->GetNumberOfCells() > 0;
}

// For every source of the mapper, how many meshes it draws.
std::vector<int> CountMeshes(vtkGlyph3DMapper* mapper)
{
  std::vector<int> counts;
  if (!mapper->GetUseSourceTableTree())
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(1); ++i)
    {
      counts.push_back(IsDrawn(mapper->GetSource(i)) ? 1 : 0);
    }
    return counts;
  }
  vtkDataObjectTree* tree = mapper->GetSourceTableTree();
  vtkSmartPointer<vtkDataObjectTreeIterator> it;
  it.TakeReference(tree->NewTreeIterator());
  it->SetTraverseSubTree(false);
  it->SetVisitOnlyLeaves(false);
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    vtkDataObject* source = it->GetCurrentDataObject();
    int count = IsDrawn(source) ? 1 : 0;
    if (auto* parts = vtkCompositeDataSet::SafeDownCast(source))
    {
      vtkSmartPointer<vtkCompositeDataIterator> part;
      part.TakeReference(parts->NewIterator());
      for (part->InitTraversal(); !part->IsDoneWithTraversal(); part->GoToNextItem())
      {
        count += IsDrawn(part->GetCurrentDataObject()) ? 1 : 0;
      }
    }
    counts.push_back(count);
  }
  return counts;
}

// One draw for every mesh of every source that a point of the input shows.
void AddInput(vtkGlyph3DMapper* mapper, vtkDataSet* points, int block,
  const std::vector<int>& meshes, std::vector<vtkRelievoGlyphDraw>& draws)
{
  std::vector<vtkRelievoGlyphDraw> bySource(meshes.size());
  auto* mask = mapper->GetMasking()
    ? vtkBitArray::SafeDownCast(vtkRelievoAccess::GlyphMapper::MaskArray(mapper, points))
    : nullptr;
  vtkDataArray* index = vtkRelievoAccess::GlyphMapper::SourceIndexArray(mapper, points);
  const int last = static_cast<int>(meshes.size()) - 1;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints() && last >= 0; ++i)
  {
    if (mask && mask->GetValue(i) == 0)
    {
      continue;
    }
    int source = 0;
    if (index)
    {
      const double length = vtkMath::Norm(index->GetTuple(i), index->GetNumberOfComponents());
      source = std::max(0, std::min(last, static_cast<int>(length)));
    }
    bySource[source].Ids.push_back(i);
  }
  for (std::size_t source = 0; source < meshes.size(); ++source)
  {
    vtkRelievoGlyphDraw& draw = bySource[source];
    draw.Block = block;
    draw.Points = points;
    if (!draw.Ids.empty())
    {
      draws.insert(draws.end(), static_cast<std::size_t>(meshes[source]), draw);
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoGlyphDraw> vtkRelievoGetGlyphDraws(vtkGlyph3DMapper* mapper)
{
  std::vector<vtkRelievoGlyphDraw> draws;
  const std::vector<int> meshes = CountMeshes(mapper);
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (auto* points = vtkDataSet::SafeDownCast(input))
  {
    AddInput(mapper, points, 0, meshes, draws);
  }
  else if (auto* blocks = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkCompositeDataDisplayAttributes* attributes = mapper->GetBlockAttributes();
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(blocks->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      vtkDataObject* block = it->GetCurrentDataObject();
      const bool hidden = attributes && attributes->HasBlockVisibility(block) &&
        !attributes->GetBlockVisibility(block);
      auto* blockPoints = vtkDataSet::SafeDownCast(block);
      if (blockPoints && !hidden)
      {
        AddInput(mapper, blockPoints, static_cast<int>(it->GetCurrentFlatIndex()), meshes, draws);
      }
    }
  }
  return draws;
}
