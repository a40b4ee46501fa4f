// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoGlyphDraws.h"

#include "vtkBitArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLGlyph3DHelper.h"
#include "vtkPolyData.h"
#include "vtkRelievoCell.h"
#include "vtkRelievoCellMap.h"
#include "vtkRelievoGlyphArrays.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <iterator>

namespace
{
bool IsDrawn(vtkDataObject* source)
{
  auto* mesh = vtkPolyData::SafeDownCast(source);
  return mesh && mesh->GetNumberOfPoints() > 0 && mesh->GetNumberOfCells() > 0;
}

// The number of meshes that the mapper draws for each source.
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

// One draw for every mesh of every source used by a point of the input.
void AddInput(vtkGlyph3DMapper* mapper, vtkDataSet* points, int block,
  const std::vector<int>& meshes, std::vector<vtkRelievoGlyphDraw>& draws)
{
  std::vector<vtkRelievoGlyphDraw> bySource(meshes.size());
  auto* mask = mapper->GetMasking()
    ? vtkBitArray::SafeDownCast(vtkRelievoGlyphArrays::GetMask(mapper, points))
    : nullptr;
  vtkDataArray* index = vtkRelievoGlyphArrays::GetSourceIndex(mapper, points);
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

//------------------------------------------------------------------------------
void vtkRelievoGlyphReach::Reach::Measure()
{
  double box[6];
  this->Source->GetBounds(box);
  const glm::dvec3 centre(
    0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]));
  auto point = [this](vtkIdType id) {
    glm::dvec3 p;
    this->Source->GetPoint(id, &p[0]);
    return p;
  };
  double radius = 0.0;
  for (vtkIdType i = 0; i < this->Source->GetNumberOfPoints(); ++i)
  {
    radius = std::max(radius, glm::distance(point(i), centre));
  }
  double edge = 0.0;
  vtkNew<vtkIdList> scratch;
  for (vtkIdType id = 0; id < this->Source->GetNumberOfCells(); ++id)
  {
    const vtkRelievoCell cell(this->Source, id, scratch);
    for (vtkIdType i = 1; i < cell.Count; ++i)
    {
      const vtkIdType last = cell.Points[i];
      edge = std::max(edge, glm::distance(point(last), point(cell.Points[i - 1])));
      // The other edges of the triangle in the fan or strip.
      const vtkIdType other =
        cell.Points[cell.Kind == vtkRelievoCell::Polys ? 0 : std::max<vtkIdType>(0, i - 2)];
      edge = std::max(edge, glm::distance(point(last), point(other)));
    }
  }
  const glm::vec4 ball(centre, radius);
  std::copy(&ball[0], &ball[0] + 4, this->Ball);
  this->Edge = static_cast<float>(edge);
}

//------------------------------------------------------------------------------
void vtkRelievoGlyphReach::SetUniforms(vtkShaderProgram* program, vtkOpenGLPolyDataMapper* mapper)
{
  vtkPolyData* source = mapper->CurrentInput;
  if (!source || !vtkOpenGLGlyph3DHelper::SafeDownCast(mapper))
  {
    return;
  }
  Reach& reach = this->Reaches[source];
  const vtkMTimeType time = vtkRelievoCellMaps::GetTime(source);
  if (reach.Source != source || reach.Time != time)
  {
    // Removes deleted sources.
    for (auto it = this->Reaches.begin(); it != this->Reaches.end();)
    {
      it = it->second.Source || it->first == source ? std::next(it) : this->Reaches.erase(it);
    }
    reach.Source = source;
    reach.Time = time;
    reach.Measure();
  }
  program->SetUniform4f("relievoGlyphBall", reach.Ball);
  program->SetUniformf("relievoGlyphEdge", reach.Edge);
}
