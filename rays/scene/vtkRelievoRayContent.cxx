// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoRayContent.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkIdTypeArray.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRelievoMatrix.h"
#include "vtkRelievoMeshTree.h"
#include "vtkRelievoPropMeshes.h"
#include "vtkRelievoPropParts.h"
#include "vtkSkybox.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace
{
vtkSmartPointer<vtkPolyData> MakeSurface(vtkDataSet* data)
{
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(data);
  filter->PassThroughCellIdsOn();
  filter->PassThroughPointIdsOn();
  filter->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->ShallowCopy(filter->GetOutput());
  return mesh;
}

// Whether the prop can be hit: not a sky, nor lines drawn over the scene.
bool IsShown(vtkProp* prop)
{
  std::vector<vtkRelievoPropParts::Part> parts;
  vtkRelievoPropParts::Collect(prop, parts);
  for (const vtkRelievoPropParts::Part& part : parts)
  {
    vtkActor* actor = vtkActor::SafeDownCast(part.Prop);
    const bool isHit = actor && !vtkSkybox::SafeDownCast(actor) &&
      !vtkRelievoPropParts::IsAnnotation(actor) && !vtkRelievoPropParts::DrawsNoOpaque(part);
    if (isHit || vtkVolume::SafeDownCast(part.Prop))
    {
      return true;
    }
  }
  return false;
}

// Whether the meshes from index `first` on draw only points or lines.
bool DrawLinesAlone(const std::vector<vtkRelievoPlacedMesh>& meshes, std::size_t first)
{
  vtkIdType others = 0;
  vtkIdType surfaces = 0;
  for (std::size_t i = first; i < meshes.size(); ++i)
  {
    vtkPolyData* mesh = meshes[i].Mesh;
    others += mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
    surfaces += mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips();
  }
  return surfaces == 0 && others > 0;
}

void UpdateMapper(vtkMapper* mapper)
{
  for (int port = 0; mapper && port < mapper->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(port); ++i)
    {
      mapper->GetInputAlgorithm(port, i)->Update();
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkRelievoRayContent::Collect(const char* pointIds)
{
  this->OwnedBefore = std::move(this->Owned);
  this->Owned.clear();
  this->Meshes.clear();
  this->Sources.clear();
  this->LeftOut.clear();
  this->Fault.clear();
  this->Copies.Begin();
  for (auto it = this->Surfaces.begin(); it != this->Surfaces.end();)
  {
    it = it->second.Data ? std::next(it) : this->Surfaces.erase(it);
  }
  if (this->Renderer)
  {
    this->AddProps();
  }
  this->AddAdded();
  if (pointIds && *pointIds)
  {
    this->TakeIds(pointIds);
  }
  this->Copies.End();
}

//------------------------------------------------------------------------------
void vtkRelievoRayContent::RemoveData()
{
  this->Data.clear();
  this->Surfaces.clear();
}

//------------------------------------------------------------------------------
void vtkRelievoRayContent::FindNormals(vtkPolyData* mesh, vtkRelievoRaySource& source)
{
  const auto isFit = [](vtkDataArray* normals, vtkIdType count) {
    return normals && normals->GetNumberOfComponents() == 3 &&
      normals->GetNumberOfTuples() == count;
  };
  vtkDataArray* ofPoints = mesh->GetPointData()->GetNormals();
  vtkDataArray* ofCells = mesh->GetCellData()->GetNormals();
  if (isFit(ofPoints, mesh->GetNumberOfPoints()))
  {
    source.Normals = ofPoints;
  }
  else if (isFit(ofCells, mesh->GetNumberOfCells()))
  {
    source.Normals = ofCells;
    source.OfCells = true;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoRayContent::AddProps()
{
  std::map<vtkProp*, int> numbers;
  vtkActorCollection* actors = this->Renderer->GetActors();
  vtkCollectionSimpleIterator it;
  actors->InitTraversal(it);
  int count = 0;
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    numbers.emplace(actor, count++);
  }
  vtkPropCollection* props = this->Renderer->GetViewProps();
  props->InitTraversal(it);
  std::vector<vtkProp*> all;
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (prop->GetVisibility())
    {
      all.push_back(prop);
    }
  }
  for (vtkProp* prop : all)
  {
    this->AddActors(prop, numbers);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoRayContent::AddActors(vtkProp* prop, std::map<vtkProp*, int>& numbers)
{
  std::vector<vtkRelievoPropParts::Part> parts;
  vtkRelievoPropParts::Collect(prop, parts);
  bool meshes = false;
  for (const vtkRelievoPropParts::Part& part : parts)
  {
    if (vtkActor* actor = vtkRelievoPropParts::GetMeshActor(part))
    {
      UpdateMapper(actor->GetMapper());
      meshes = true;
    }
  }
  const std::size_t before = this->Meshes.size();
  bool followed = vtkRelievoPropMeshes::Collect(
    prop, vtkRelievoPropMeshes::Wanted::Geometry, this->Glyphs, this->Meshes);
  const bool enters =
    std::none_of(this->Meshes.begin() + static_cast<std::ptrdiff_t>(before), this->Meshes.end(),
      [](const vtkRelievoPlacedMesh& mesh) { return !vtkRelievoWorldCopies::IsTraceable(mesh); });
  if (!enters || DrawLinesAlone(this->Meshes, before))
  {
    followed = false;
    this->Meshes.resize(before);
  }
  if (!(meshes && followed) && IsShown(prop))
  {
    this->LeftOut.emplace_back(prop);
  }
  vtkActor* last = nullptr; // blocks of one actor are consecutive
  bool isOpaque = true;
  for (std::size_t i = before; i < this->Meshes.size(); ++i)
  {
    vtkRelievoPlacedMesh& mesh = this->Meshes[i];
    isOpaque = mesh.Actor == last ? isOpaque : mesh.Actor->HasOpaqueGeometry() != 0;
    last = mesh.Actor;
    vtkRelievoRaySource source;
    const auto number = numbers.find(mesh.Actor);
    source.Prop = number == numbers.end() ? -1 : number->second;
    source.Actor = mesh.Actor;
    // A block may be translucent even if other blocks of its actor are opaque.
    source.IsOpaque = isOpaque && (mesh.Actor->GetForceOpaque() || !(mesh.Opacity < 1.0));
    this->Copies.Enter(mesh, source);
    if (mesh.Actor->GetProperty()->GetInterpolation() != VTK_FLAT)
    {
      FindNormals(mesh.Mesh, source);
    }
    this->Sources.push_back(source);
    this->Owned.emplace_back(mesh.Mesh);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoRayContent::AddAdded()
{
  int prop = this->Renderer ? this->Renderer->GetActors()->GetNumberOfItems() : 0;
  for (const Added& added : this->Data)
  {
    const auto add = [&](vtkDataObject* data, int block) {
      const std::size_t before = this->Sources.size();
      const std::string fault = this->AddBlock(data, block, prop, added.Matrix);
      for (std::size_t i = before; i < this->Sources.size(); ++i)
      {
        this->Sources[i].Added = static_cast<int>(&added - this->Data.data());
      }
      if (!fault.empty() && this->Fault.empty())
      {
        this->Fault = "prop " + std::to_string(prop) + ": " + fault;
      }
    };
    if (auto* blocks = vtkCompositeDataSet::SafeDownCast(added.Data))
    {
      auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
      for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
      {
        add(it->GetCurrentDataObject(), static_cast<int>(it->GetCurrentFlatIndex()));
      }
    }
    else
    {
      add(added.Data, 0);
    }
    ++prop;
  }
}

//------------------------------------------------------------------------------
std::string vtkRelievoRayContent::AddBlock(
  vtkDataObject* data, int block, int prop, vtkMatrix4x4* matrix)
{
  auto* set = vtkDataSet::SafeDownCast(data);
  if (!set)
  {
    return {}; // e.g. a table among the blocks
  }
  vtkRelievoPlacedMesh placed;
  placed.Mesh = vtkPolyData::SafeDownCast(set);
  placed.Block = block;
  placed.ByOutline = true;
  vtkRelievoRaySource source;
  source.Prop = prop;
  if (matrix)
  {
    placed.MeshToWorld = vtkRelievoToGlm(matrix);
  }
  if (!placed.Mesh)
  {
    Surface& surface = this->Surfaces[set];
    if (surface.Data != set || surface.Time != set->GetMTime())
    {
      surface = { set, set->GetMTime(), MakeSurface(set) };
    }
    placed.Mesh = surface.Mesh;
    source.Cells =
      vtkIdTypeArray::SafeDownCast(placed.Mesh->GetCellData()->GetArray("vtkOriginalCellIds"));
    source.Points =
      vtkIdTypeArray::SafeDownCast(placed.Mesh->GetPointData()->GetArray("vtkOriginalPointIds"));
  }
  const vtkIdType triangles = vtkRelievoPolygonCut::CountTriangles(placed.Mesh);
  if (triangles > vtkRelievoMeshTree::MostTriangles)
  {
    return "there are " + std::to_string(triangles) + " triangles, expected at most " +
      std::to_string(vtkRelievoMeshTree::MostTriangles) + " in a block";
  }
  if (!vtkRelievoWorldCopies::IsTraceable(placed))
  {
    return "got a matrix that is not finite, or maps points to infinity or beyond, expected a "
           "last row that is positive for all points, such as 0 0 0 1";
  }
  this->Copies.Enter(placed, source);
  FindNormals(placed.Mesh, source);
  this->Meshes.push_back(placed);
  this->Sources.push_back(source);
  this->Owned.emplace_back(placed.Mesh);
  return {};
}

//------------------------------------------------------------------------------
// Copies the user's ids, so that a copied state keeps them.
void vtkRelievoRayContent::TakeIds(const char* name)
{
  for (std::size_t i = 0; i < this->Sources.size(); ++i)
  {
    vtkPolyData* mesh = this->Meshes[i].Mesh;
    vtkDataArray* given = mesh->GetPointData()->GetArray(name);
    if (given && given->GetNumberOfComponents() == 1 && given->GetDataType() != VTK_FLOAT &&
      given->GetDataType() != VTK_DOUBLE && given->GetNumberOfTuples() == mesh->GetNumberOfPoints())
    {
      this->Sources[i].Ids = vtkSmartPointer<vtkIdTypeArray>::New();
      this->Sources[i].Ids->DeepCopy(given);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkRelievoRayContent::HasIds() const
{
  return std::any_of(this->Sources.begin(), this->Sources.end(),
    [](const vtkRelievoRaySource& source) { return source.Ids != nullptr; });
}
