// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDrawTable.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoGBufferSplice.h"
#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::Clear()
{
  this->Draws.clear();
}

//------------------------------------------------------------------------------
int vtkRelievoDrawTable::Add(
  vtkActor* actor, vtkOpenGLPolyDataMapper* mapper, int primitiveSource)
{
  this->Draws.push_back(
    Draw{ actor, actor->GetPropertyKeys(), mapper, primitiveSource, -1, actor, {} });
  return static_cast<int>(this->Draws.size()) - 1;
}

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::ResolveRanges(Draw& draw)
{
  draw.Ranges.clear();
  vtkOpenGLPolyDataMapper* mapper = draw.Mapper;
  if (!mapper || !draw.Actor || draw.PrimitiveSource != vtkRelievoGBufferSplice::PrimitiveOfMesh)
  {
    return;
  }
  const int representation = draw.Actor->GetProperty()->GetRepresentation();
  auto update = [representation](vtkOpenGLCellToVTKCellMap* map, vtkPolyData* mesh)
  {
    vtkCellArray* cells[4] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
      mesh->GetStrips() };
    map->Update(cells, representation, mesh->GetPoints());
  };
#ifdef RELIEVO_COMPOSITE_HELPER
  if (auto* helper = vtkCompositeMapperHelper2::SafeDownCast(mapper))
  {
    for (const auto& block : vtkRelievoAccess::CompositeHelper::Blocks(helper))
    {
      vtkOpenGLCellToVTKCellMap* map = block.second->CellCellMap;
      update(map, block.first);
      draw.Ranges.push_back(Range{ map->GetPrimitiveOffsets()[0],
        static_cast<int>(block.second->FlatIndex), block.first, map });
    }
    std::sort(draw.Ranges.begin(), draw.Ranges.end(),
      [](const Range& a, const Range& b) { return a.First < b.First; });
    return;
  }
#endif
  if (vtkPolyData* mesh = mapper->CurrentInput)
  {
    vtkOpenGLCellToVTKCellMap* map = vtkRelievoAccess::Mapper::CellMap(mapper);
    update(map, mesh);
    draw.Ranges.push_back(Range{ 0, 0, mesh, map });
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::Resolve(vtkRenderer* renderer)
{
  std::map<const void*, std::pair<int, vtkActor*>> actors;
  vtkActorCollection* collection = renderer->GetActors();
  vtkCollectionSimpleIterator it;
  collection->InitTraversal(it);
  for (int i = 0; vtkActor* actor = collection->GetNextActor(it); ++i)
  {
    actors.emplace(actor, std::make_pair(i, actor));
    if (actor->GetPropertyKeys())
    {
      actors.emplace(actor->GetPropertyKeys(), std::make_pair(i, actor));
    }
  }
  for (Draw& draw : this->Draws)
  {
    auto found = actors.find(draw.Actor.GetPointer());
    if (found == actors.end())
    {
      found = actors.find(draw.Keys);
    }
    draw.ActorIndex = found == actors.end() ? -1 : found->second.first;
    draw.Prop = found == actors.end() ? draw.Actor.GetPointer() : found->second.second;
    ResolveRanges(draw);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoDrawTable::Hit> vtkRelievoDrawTable::GetMeshes() const
{
  std::vector<Hit> meshes;
  for (const Draw& draw : this->Draws)
  {
    Hit hit;
    hit.Actor = draw.ActorIndex;
    hit.Prop = draw.Prop;
    if (draw.PrimitiveSource == vtkRelievoGBufferSplice::InstanceOfGlyphs)
    {
      meshes.push_back(hit);
    }
    for (const Range& range : draw.Ranges)
    {
      hit.Block = range.Block;
      hit.Mesh = range.Mesh;
      meshes.push_back(hit);
    }
  }
  return meshes;
}

//------------------------------------------------------------------------------
vtkRelievoDrawTable::Hit vtkRelievoDrawTable::Find(
  std::uint32_t drawId, std::uint32_t primitive) const
{
  Hit hit;
  if (drawId >= this->Draws.size())
  {
    return hit;
  }
  const Draw& draw = this->Draws[drawId];
  hit.Actor = draw.ActorIndex;
  hit.Prop = draw.Prop;
  hit.Block = 0;
  if (primitive == 0xffffffffu)
  {
    return hit;
  }
  if (draw.PrimitiveSource == vtkRelievoGBufferSplice::InstanceOfGlyphs)
  {
    hit.Cell = primitive;
    return hit;
  }
  auto behind = std::upper_bound(draw.Ranges.begin(), draw.Ranges.end(),
    static_cast<vtkIdType>(primitive),
    [](vtkIdType value, const Range& range) { return value < range.First; });
  if (behind == draw.Ranges.begin())
  {
    return hit;
  }
  const Range& range = *(behind - 1);
  hit.Block = range.Block;
  hit.Mesh = range.Mesh;
  hit.Cell = range.Map->ConvertOpenGLCellIdToVTKCellId(false, primitive);
  hit.Primitive = 0;
  while (static_cast<vtkIdType>(primitive) - hit.Primitive > range.First &&
    range.Map->ConvertOpenGLCellIdToVTKCellId(
      false, static_cast<vtkIdType>(primitive) - hit.Primitive - 1) == hit.Cell)
  {
    ++hit.Primitive;
  }
  return hit;
}
