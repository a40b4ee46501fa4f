// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDrawTable.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoGBufferSplice.h"
#include "vtkRelievoGlyphDraws.h"
#include "vtkRelievoView.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <algorithm>

namespace
{
vtkIdType CountPrimitivesAtMost(vtkPolyData* mesh)
{
  // Every primitive ends at another point of its cell; strips drawn as lines have two for a point.
  return mesh->GetVerts()->GetNumberOfConnectivityIds() +
    mesh->GetLines()->GetNumberOfConnectivityIds() +
    mesh->GetPolys()->GetNumberOfConnectivityIds() +
    2 * mesh->GetStrips()->GetNumberOfConnectivityIds();
}

vtkIdType CountGlyphs(vtkDataObject* input)
{
  return input ? std::max<vtkIdType>(1, input->GetNumberOfElements(vtkDataObject::POINT)) : 1;
}

vtkIdType CountPrimitives(vtkActor* actor, vtkOpenGLPolyDataMapper* mapper, int source)
{
  if (source == vtkRelievoGBufferSplice::NoPrimitive)
  {
    return 1;
  }
  if (source == vtkRelievoGBufferSplice::InstanceOfGlyphs)
  {
    return actor->GetMapper() ? CountGlyphs(actor->GetMapper()->GetInputDataObject(0, 0)) : 1;
  }
#ifdef RELIEVO_COMPOSITE_HELPER
  if (auto* helper = vtkCompositeMapperHelper2::SafeDownCast(mapper))
  {
    vtkIdType count = 0;
    for (const auto& block : vtkRelievoAccess::CompositeHelper::Blocks(helper))
    {
      count += CountPrimitivesAtMost(block.first);
    }
    return count;
  }
#endif
  return mapper->CurrentInput ? std::max(CountPrimitivesAtMost(mapper->CurrentInput),
                                  mapper->CurrentInput->GetNumberOfPoints())
                              : 1;
}
}

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::Clear()
{
  this->Draws.clear();
}

//------------------------------------------------------------------------------
std::uint32_t vtkRelievoDrawTable::Add(
  vtkActor* actor, vtkOpenGLPolyDataMapper* mapper, int primitiveSource)
{
  std::uint32_t first = 0;
  if (!this->Draws.empty())
  {
    const Draw& last = this->Draws.back();
    // A mapper's verts, lines, polys and strips count through.
    if (last.Actor == actor && last.Mapper == mapper && last.PrimitiveSource == primitiveSource)
    {
      return last.First;
    }
    first = last.First + last.Count;
  }
  const vtkIdType most = CountPrimitives(actor, mapper, primitiveSource);
  const std::uint32_t count =
    static_cast<std::uint32_t>(std::min<vtkIdType>(most, Nothing - first));
  Draw draw{};
  draw.Actor = actor;
  draw.Keys = actor->GetPropertyKeys();
  draw.Mapper = mapper;
  draw.PrimitiveSource = primitiveSource;
  draw.First = first;
  draw.Count = count;
  vtkMatrix4x4* matrix = actor->GetMatrix();
  for (int i = 0; i < 16; ++i)
  {
    draw.ModelToWorld[i % 4][i / 4] = matrix->GetElement(i / 4, i % 4);
  }
  if (primitiveSource == vtkRelievoGBufferSplice::PrimitiveOfMesh)
  {
    AddRanges(draw, mapper);
  }
  else if (primitiveSource == vtkRelievoGBufferSplice::PointOfMesh)
  {
    draw.Points = mapper->CurrentInput;
  }
  this->Draws.push_back(draw);
  return first;
}

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::AddRanges(Draw& draw, vtkOpenGLPolyDataMapper* mapper)
{
  const int representation = draw.Actor->GetProperty()->GetRepresentation();
  auto add = [&](int block, vtkPolyData* mesh, vtkOpenGLCellToVTKCellMap* map) {
    vtkCellArray* cells[4] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
      mesh->GetStrips() };
    // Before VTK takes its offsets from it: until it is asked, the map also counts triangles
    // without area, which are not drawn.
    map->Update(cells, representation, mesh->GetPoints());
    draw.Ranges.push_back(Range{ map->GetPrimitiveOffsets()[0], block, mesh, map });
  };
#ifdef RELIEVO_COMPOSITE_HELPER
  if (auto* helper = vtkCompositeMapperHelper2::SafeDownCast(mapper))
  {
    for (const auto& block : vtkRelievoAccess::CompositeHelper::Blocks(helper))
    {
      add(static_cast<int>(block.second->FlatIndex), block.first, block.second->CellCellMap);
    }
    std::sort(draw.Ranges.begin(), draw.Ranges.end(),
      [](const Range& x, const Range& y) { return x.First < y.First; });
    return;
  }
#endif
  if (mapper->CurrentInput)
  {
    add(0, mapper->CurrentInput, vtkRelievoAccess::Mapper::CellMap(mapper));
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::ResolveGlyphs()
{
  std::map<const void*, std::vector<Draw*>> byActor;
  for (Draw& draw : this->Draws)
  {
    if (draw.PrimitiveSource == vtkRelievoGBufferSplice::InstanceOfGlyphs && draw.Prop)
    {
      byActor[draw.Prop].push_back(&draw);
    }
  }
  for (auto& actor : byActor)
  {
    std::vector<Draw*>& draws = actor.second;
    auto* mapper = vtkGlyph3DMapper::SafeDownCast(draws[0]->Prop->GetMapper());
    std::vector<vtkRelievoGlyphDraw> glyphs;
    if (mapper)
    {
      glyphs = vtkRelievoGetGlyphDraws(mapper);
    }
    // A mapper that draws in another way than VTK's keeps its points to itself.
    for (std::size_t i = 0; i < draws.size() && glyphs.size() == draws.size(); ++i)
    {
      draws[i]->Block = glyphs[i].Block;
      draws[i]->Points = glyphs[i].Points;
      draws[i]->Ids = std::move(glyphs[i].Ids);
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::Resolve(vtkRenderer* renderer, const vtkRelievoView& view)
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
    draw.ModelToView = view.WorldToView * draw.ModelToWorld;
    draw.ViewToModel = glm::inverse(draw.ModelToView);
    vtkShaderProperty* shaders = draw.Prop ? draw.Prop->GetShaderProperty() : nullptr;
    // The frame's own stages have left the actor by now; who stays may move what is seen.
    vtkInformation* keys = draw.Prop ? draw.Prop->GetPropertyKeys() : nullptr;
    draw.Deformed = (keys && keys->Has(vtkOpenGLRenderPass::RenderPasses())) ||
      (shaders &&
        (shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode() ||
          shaders->GetNumberOfShaderReplacements() > 0));
  }
  this->ResolveGlyphs();
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoDrawTable::Hit::GetPrimitiveInCell() const
{
  // A mesh's primitives are in the order of its cells; a cell may have millions (a long line).
  vtkIdType from = this->First;
  vtkIdType to = this->Word;
  while (from < to)
  {
    const vtkIdType middle = from + (to - from) / 2;
    if (this->Map->ConvertOpenGLCellIdToVTKCellId(false, middle) < this->Cell)
    {
      from = middle + 1;
    }
    else
    {
      to = middle;
    }
  }
  return this->Word - from;
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
    hit.Points = draw.Points;
    if (draw.Points)
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
vtkRelievoDrawTable::Hit vtkRelievoDrawTable::Find(std::uint32_t word) const
{
  Hit hit;
  if (word == Nothing)
  {
    return hit;
  }
  auto next = std::upper_bound(this->Draws.begin(), this->Draws.end(), word,
    [](std::uint32_t value, const Draw& draw) { return value < draw.First; });
  if (next == this->Draws.begin())
  {
    return hit;
  }
  const Draw& draw = *(next - 1);
  const std::uint32_t primitive = word - draw.First;
  if (primitive >= draw.Count)
  {
    return hit;
  }
  hit.Actor = draw.ActorIndex;
  hit.Prop = draw.Prop;
  hit.ViewToModel = &draw.ViewToModel;
  hit.ModelToView = &draw.ModelToView;
  hit.Deformed = draw.Deformed;
  hit.Block = draw.Block;
  if (draw.Points)
  {
    hit.Points = draw.Points;
    hit.Cell = draw.PrimitiveSource == vtkRelievoGBufferSplice::PointOfMesh ? primitive
      : primitive < draw.Ids.size()                                         ? draw.Ids[primitive]
                                                                            : -1;
  }
  auto behind =
    std::upper_bound(draw.Ranges.begin(), draw.Ranges.end(), static_cast<vtkIdType>(primitive),
      [](vtkIdType value, const Range& range) { return value < range.First; });
  if (behind == draw.Ranges.begin())
  {
    return hit;
  }
  const Range& range = *(behind - 1);
  hit.Block = range.Block;
  hit.Mesh = range.Mesh;
  hit.Cell = range.Map->ConvertOpenGLCellIdToVTKCellId(false, primitive);
  hit.Word = primitive;
  hit.First = range.First;
  hit.Map = range.Map;
  return hit;
}
