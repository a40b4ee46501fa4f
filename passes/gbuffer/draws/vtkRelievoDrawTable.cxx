// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoDrawTable.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoAccess.h"
#include "vtkRelievoFrameCamera.h"
#include "vtkRelievoGBufferSplice.h"
#include "vtkRelievoGlyphDraws.h"
#include "vtkRelievoSurfaces.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <algorithm>
#include <map>

namespace
{
using Composites = vtkRelievoAccess::CompositeHelper;

vtkIdType CountPrimitivesAtMost(vtkPolyData* mesh)
{
  // Every primitive ends at a different point of its cell; strips drawn as lines have two for a
  // point.
  return mesh->GetVerts()->GetNumberOfConnectivityIds() +
    mesh->GetLines()->GetNumberOfConnectivityIds() +
    mesh->GetPolys()->GetNumberOfConnectivityIds() +
    2 * mesh->GetStrips()->GetNumberOfConnectivityIds();
}

// A draw shows points of one block: at most as many as the largest block has.
vtkIdType CountGlyphsAtMost(vtkDataObject* input)
{
  vtkIdType most = 1;
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(blocks->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      most = std::max(most, it->GetCurrentDataObject()->GetNumberOfElements(vtkDataObject::POINT));
    }
  }
  else if (input)
  {
    most = std::max(most, input->GetNumberOfElements(vtkDataObject::POINT));
  }
  return most;
}

vtkIdType CountPrimitives(vtkActor* actor, vtkOpenGLPolyDataMapper* mapper, int source)
{
  if (source == vtkRelievoGBufferSplice::NoPrimitive)
  {
    return 1;
  }
  if (source == vtkRelievoGBufferSplice::InstanceOfGlyphs)
  {
    return actor->GetMapper() ? CountGlyphsAtMost(actor->GetMapper()->GetInputDataObject(0, 0)) : 1;
  }
  if (Composites::Draws(mapper))
  {
    vtkIdType count = 0;
    for (const vtkRelievoAccess::Block& block : Composites::GetBlocks(mapper))
    {
      count += CountPrimitivesAtMost(block.Mesh);
    }
    return count;
  }
  return mapper->CurrentInput ? std::max(CountPrimitivesAtMost(mapper->CurrentInput),
                                  mapper->CurrentInput->GetNumberOfPoints())
                              : 1;
}

// VTK 9.6.1 and later let blocks' numbers overlap unless its own shaders use the numbers.
void NumberBlocks(vtkOpenGLPolyDataMapper* mapper)
{
  if (Composites::NumbersPrimitives(mapper))
  {
    return;
  }
  vtkIdType first = 0;
  for (const vtkRelievoAccess::Block& block : Composites::GetBlocks(mapper))
  {
    block.Map->SetStartOffset(first);
    first += CountPrimitivesAtMost(block.Mesh);
  }
}

// The mesh that the mapper draws now. A mapper may draw several pieces in turn from one mesh
// object, which it refills, so the table stores the arrays of each piece.
vtkSmartPointer<vtkPolyData> GetMesh(vtkOpenGLPolyDataMapper* mapper)
{
  vtkSmartPointer<vtkPolyData> mesh = mapper->CurrentInput;
  if (mesh && mapper->GetNumberOfSubPieces() > 1)
  {
    mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->ShallowCopy(mapper->CurrentInput);
  }
  return mesh;
}
}

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::Clear()
{
  this->Draws.clear();
  this->Maps.Prune();
}

//------------------------------------------------------------------------------
std::uint32_t vtkRelievoDrawTable::Add(
  vtkActor* actor, vtkOpenGLPolyDataMapper* mapper, int primitiveSource)
{
  const int type = vtkRelievoAccess::Mapper::BoundPrimitiveType(mapper);
  std::uint32_t first = 0;
  vtkIdType most = -1;
  if (!this->Draws.empty())
  {
    Draw& last = this->Draws.back();
    // A mapper numbers its verts, lines, polys and strips consecutively, and draws them in this
    // order: a kind that does not come later starts another piece, or draws the actor again.
    if (last.Actor == actor && last.Mapper == mapper && last.PrimitiveSource == primitiveSource &&
      type > last.LastPrimitiveType)
    {
      last.LastPrimitiveType = type;
      SetOffset(last, mapper, type);
      return last.First;
    }
    first = last.First + last.Count;
    // Glyphs take many draws, and counting looks through all blocks: only the first draw counts.
    const bool goesOn = last.Actor == actor && last.PrimitiveSource == primitiveSource &&
      primitiveSource == vtkRelievoGBufferSplice::InstanceOfGlyphs;
    most = goesOn ? static_cast<vtkIdType>(last.Count) : -1;
  }
  most = most < 0 ? CountPrimitives(actor, mapper, primitiveSource) : most;
  // Beyond the last number, this and all later draws have no ids.
  const bool reached = most < static_cast<vtkIdType>(Nothing - first);
  const std::uint32_t count = reached ? static_cast<std::uint32_t>(most) : 0;
  first = reached ? first : Nothing;
  Draw draw{};
  draw.Actor = actor;
  draw.Keys = actor->GetPropertyKeys();
  draw.Mapper = mapper;
  draw.PrimitiveSource = primitiveSource;
  draw.LastPrimitiveType = type;
  draw.Representation = actor->GetProperty()->GetRepresentation();
  draw.First = first;
  draw.Count = count;
  vtkMatrix4x4* matrix = actor->GetMatrix();
  for (int i = 0; i < 16; ++i)
  {
    draw.ModelToWorld[i % 4][i / 4] = matrix->GetElement(i / 4, i % 4);
  }
  if (primitiveSource == vtkRelievoGBufferSplice::PrimitiveOfMesh)
  {
    this->AddRanges(draw, mapper);
    SetOffset(draw, mapper, type);
  }
  else if (primitiveSource == vtkRelievoGBufferSplice::PointOfMesh)
  {
    draw.Points = GetMesh(mapper);
  }
  draw.Time = GetTime(draw);
  this->Draws.push_back(draw);
  return first;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoDrawTable::GetTime(const Draw& draw)
{
  vtkMTimeType time = draw.Points ? draw.Points->GetMTime() : 0;
  for (const Range& range : draw.Ranges)
  {
    time = std::max(time, range.Mesh->GetMTime());
  }
  vtkMapper* mapper = draw.Actor ? draw.Actor->GetMapper() : nullptr;
  vtkDataObject* glyphs =
    draw.PrimitiveSource == vtkRelievoGBufferSplice::InstanceOfGlyphs && mapper
    ? mapper->GetInputDataObject(0, 0)
    : nullptr;
  return glyphs ? std::max(time, glyphs->GetMTime()) : time;
}

//------------------------------------------------------------------------------
bool vtkRelievoDrawTable::IsStale() const
{
  return std::any_of(this->Draws.begin(), this->Draws.end(),
    [](const Draw& draw) { return GetTime(draw) != draw.Time; });
}

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::AddRanges(Draw& draw, vtkOpenGLPolyDataMapper* mapper)
{
  auto add = [&](int block, vtkPolyData* mesh, vtkOpenGLCellToVTKCellMap* map) {
    Range range;
    const vtkIdType* offsets = map->GetPrimitiveOffsets();
    std::copy(offsets, offsets + vtkRelievoCellMap::Kinds, range.Offsets.begin());
    range.Block = block;
    range.Mesh = mesh;
    range.Map = this->Maps.Get(mesh, draw.Representation);
    range.Time = vtkRelievoCellMaps::GetTime(mesh);
    draw.Ranges.push_back(range);
  };
  if (Composites::Draws(mapper))
  {
    NumberBlocks(mapper);
    for (const vtkRelievoAccess::Block& block : Composites::GetBlocks(mapper))
    {
      add(block.FlatIndex, block.Mesh, block.Map);
    }
    std::sort(draw.Ranges.begin(), draw.Ranges.end(),
      [](const Range& x, const Range& y) { return x.Offsets[0] < y.Offsets[0]; });
    for (std::size_t i = 1; i < draw.Ranges.size(); ++i)
    {
      const Range& before = draw.Ranges[i - 1];
      if (draw.Ranges[i].Offsets[0] < before.Map->GetEnd(before.Offsets))
      {
        draw.Ambiguous = true;
      }
    }
    if (draw.Ambiguous)
    {
      draw.Ranges.clear();
      draw.Block = -1;
    }
    return;
  }
  if (mapper->CurrentInput)
  {
    add(0, GetMesh(mapper), vtkRelievoAccess::Mapper::CellMap(mapper));
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::SetOffset(Draw& draw, vtkOpenGLPolyDataMapper* mapper, int type)
{
  if (Composites::Draws(mapper))
  {
    return;
  }
  // The map's offset, unless the kind follows one of which nothing is drawn.
  if (!draw.Ranges.empty() && type < vtkRelievoCellMap::Kinds)
  {
    draw.Ranges[0].Offsets[type] = vtkRelievoAccess::Mapper::PrimitiveOffset(mapper);
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
    // The glyph points of other classes of mappers are unknown. An actor may be drawn several
    // times.
    const bool known = !glyphs.empty() && draws.size() % glyphs.size() == 0;
    for (std::size_t i = 0; i < draws.size() && known; ++i)
    {
      const vtkRelievoGlyphDraw& glyph = glyphs[i % glyphs.size()];
      draws[i]->Block = glyph.Block;
      draws[i]->Points = glyph.Points;
      draws[i]->Ids = glyph.Ids;
    }
  }
}

//------------------------------------------------------------------------------
void vtkRelievoDrawTable::Resolve(vtkRenderer* renderer, const vtkRelievoFrameCamera& view)
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
    // The frame's own stages have left the keys; remaining passes may move vertices.
    vtkInformation* keys = draw.Prop ? draw.Prop->GetPropertyKeys() : nullptr;
    draw.Deformed = (keys && keys->Has(vtkOpenGLRenderPass::RenderPasses())) ||
      (shaders &&
        (shaders->HasVertexShaderCode() || shaders->HasGeometryShaderCode() ||
          shaders->GetNumberOfShaderReplacements() > 0));
    draw.Moved = draw.Prop && vtkRelievoSurfaces::IsMoved(draw.Prop);
    for (Range& range : draw.Ranges)
    {
      range.Changed = vtkRelievoCellMaps::GetTime(range.Mesh) != range.Time;
    }
  }
  this->ResolveGlyphs();
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoDrawTable::Hit::GetPrimitiveInCell() const
{
  return this->Map ? this->Map->GetPrimitiveInCell(*this->Offsets, this->Primitive) : 0;
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
std::vector<vtkRelievoDrawTable::PartStart> vtkRelievoDrawTable::GetParts() const
{
  std::vector<PartStart> parts;
  std::map<std::pair<const void*, int>, int> numbers; // the pieces of a block form one part
  const auto add = [&](std::uint32_t first, const Draw& draw, int block) {
    const auto number = static_cast<int>(numbers.size());
    parts.push_back({ first,
      numbers.emplace(std::make_pair(draw.Actor.GetPointer(), block), number).first->second });
  };
  for (const Draw& draw : this->Draws)
  {
    if (draw.First == Nothing)
    {
      continue;
    }
    if (draw.PrimitiveSource == vtkRelievoGBufferSplice::InstanceOfGlyphs)
    {
      parts.push_back({ draw.First, -1 });
      continue;
    }
    if (draw.Ranges.size() < 2)
    {
      add(draw.First, draw, draw.Ranges.empty() ? 0 : draw.Ranges[0].Block);
      continue;
    }
    for (const Range& range : draw.Ranges)
    {
      add(draw.First + static_cast<std::uint32_t>(range.Offsets[0]), draw, range.Block);
    }
  }
  return parts;
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
  hit.Representation = draw.Representation;
  hit.Deformed = draw.Deformed;
  hit.Moved = draw.Moved;
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
      [](vtkIdType value, const Range& range) { return value < range.Offsets[0]; });
  if (behind == draw.Ranges.begin())
  {
    return hit;
  }
  const Range& range = *(behind - 1);
  hit.Block = range.Block;
  hit.Mesh = range.Mesh;
  hit.Changed = range.Changed;
  hit.Map = range.Map.get();
  hit.Offsets = &range.Offsets;
  hit.Primitive = primitive;
  hit.Cell = range.Map->GetCell(range.Offsets, primitive);
  return hit;
}
