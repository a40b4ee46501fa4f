// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMovedPoints.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace
{
bool AreEqual(vtkDataArray* a, vtkDataArray* b)
{
  if (a == b || !a || !b)
  {
    return a == b;
  }
  const vtkIdType count = a->GetNumberOfValues();
  if (a->GetDataType() != b->GetDataType() || count != b->GetNumberOfValues())
  {
    return false;
  }
  if (a->HasStandardMemoryLayout() && b->HasStandardMemoryLayout())
  {
    return count == 0 ||
      std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
        static_cast<std::size_t>(count) * static_cast<std::size_t>(a->GetDataTypeSize())) == 0;
  }
  vtkIdType i = 0;
  while (i < count && a->GetComponent(i, 0) == b->GetComponent(i, 0)) // both have one component
  {
    ++i;
  }
  return i == count;
}

bool AreEqual(vtkCellArray* a, vtkCellArray* b)
{
  return a == b ||
    (AreEqual(a->GetOffsetsArray(), b->GetOffsetsArray()) &&
      AreEqual(a->GetConnectivityArray(), b->GetConnectivityArray()));
}
}

//------------------------------------------------------------------------------
vtkRelievoMovedPoints::vtkRelievoMovedPoints(
  const vtkRelievoRayContent& from, const vtkRelievoRayTree& tree, const vtkRelievoRayContent& to)
  : From(from)
  , Tree(tree)
  , To(to)
  , Meshes(from.Meshes.size(), -1)
{
  std::map<Key, int> targets;
  const std::vector<Key> keys = GetKeys(to);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    targets.emplace(keys[i], static_cast<int>(i));
  }
  const std::vector<Key> wanted = GetKeys(from);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const auto found = targets.find(wanted[i]);
    const bool known = std::get<0>(wanted[i]) || std::get<1>(wanted[i]) >= 0;
    this->Meshes[i] = known && found != targets.end() ? found->second : -1;
  }
  for (std::size_t i = 0; i < this->Meshes.size(); ++i)
  {
    const int mesh = this->Meshes[i];
    if (mesh >= 0)
    {
      this->Add(mesh);
      const auto other = static_cast<std::size_t>(mesh);
      const bool samePoints = this->HasSamePoints(i, other);
      this->IsChanged.push_back(!samePoints || !this->HasSameCells(i, other));
      if (this->IsChanged.back() && samePoints)
      {
        this->AddCells(mesh);
      }
    }
    else
    {
      this->IsChanged.push_back(true);
    }
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkRelievoMovedPoints::Get(
  const vtkRelievoRayTree::Hit& hit, const double weights[3]) const
{
  const glm::dvec3 nowhere(std::numeric_limits<double>::quiet_NaN());
  const auto from = static_cast<std::size_t>(this->Tree.GetMesh(hit.Place));
  const int mesh = this->Meshes[from];
  if (mesh < 0)
  {
    return nowhere;
  }
  const Target& target = this->Targets.at(mesh);
  const vtkRelievoPlacedMesh& placed = this->To.Meshes[static_cast<std::size_t>(mesh)];
  std::size_t instance = 0;
  if (placed.Points)
  {
    const vtkRelievoPlacedMesh& before = this->From.Meshes[from];
    const auto at = before.Points
      ? target.Places.find(
          (*before.Points)[static_cast<std::size_t>(this->Tree.GetInstance(hit.Place))])
      : target.Places.end();
    if (at == target.Places.end())
    {
      return nowhere;
    }
    instance = at->second;
  }
  const vtkRelievoMeshTree& triangles = this->Tree.GetMeshTree(hit.Place);
  if (this->IsChanged[from] && !this->HasCell(from, triangles.GetCell(hit.Triangle), target))
  {
    return nowhere;
  }
  vtkIdTypeArray* ids = this->From.Sources[from].GetIds();
  glm::dvec3 sum(0.0);
  for (int i = 0; i < 3; ++i)
  {
    vtkIdType point = triangles.GetPoint(hit.Triangle, i);
    // In equal meshes points have equal indices, even if several have one id.
    if (this->IsChanged[from] && this->To.Sources[static_cast<std::size_t>(mesh)].GetIds())
    {
      const auto at = target.Points.find(ids ? ids->GetValue(point) : point);
      point = at == target.Points.end() ? -1 : at->second;
    }
    if (point < 0 || point >= placed.Mesh->GetNumberOfPoints())
    {
      return nowhere;
    }
    glm::dvec3 corner;
    placed.Mesh->GetPoint(point, &corner.x);
    sum += weights[i] * corner;
  }
  const glm::dvec4 place = placed.GetPlace(instance) * glm::dvec4(sum, 1.0);
  return glm::dvec3(place) / place.w;
}

//------------------------------------------------------------------------------
void vtkRelievoMovedPoints::TakeCellPoints(
  vtkCellArray* cells, vtkIdType cell, vtkIdTypeArray* ids, vtkIdList* list, CellPoints& points)
{
  cells->GetCellAtId(cell, list);
  points.clear();
  for (vtkIdType i = 0; i < list->GetNumberOfIds(); ++i)
  {
    points.push_back(ids ? ids->GetValue(list->GetId(i)) : list->GetId(i));
  }
  std::sort(points.begin(), points.end());
}

//------------------------------------------------------------------------------
bool vtkRelievoMovedPoints::HasSameCells(std::size_t from, std::size_t to) const
{
  vtkPolyData* before = this->From.Meshes[from].Mesh;
  vtkPolyData* after = this->To.Meshes[to].Mesh;
  return AreEqual(this->From.Sources[from].GetIds(), this->To.Sources[to].GetIds()) &&
    AreEqual(before->GetPolys(), after->GetPolys()) &&
    AreEqual(before->GetStrips(), after->GetStrips());
}

//------------------------------------------------------------------------------
bool vtkRelievoMovedPoints::HasSamePoints(std::size_t from, std::size_t to) const
{
  const auto count = [](const vtkRelievoRayContent& scene, std::size_t mesh) {
    return scene.Sources[mesh].GetIds() ? -1 : scene.Meshes[mesh].Mesh->GetNumberOfPoints();
  };
  // The user's ids and indices in the data do not identify each other.
  return (this->From.Sources[from].Ids != nullptr) == (this->To.Sources[to].Ids != nullptr) &&
    count(this->From, from) == count(this->To, to);
}

//------------------------------------------------------------------------------
bool vtkRelievoMovedPoints::HasCell(std::size_t from, vtkIdType cell, const Target& target) const
{
  vtkPolyData* mesh = this->From.Meshes[from].Mesh;
  const vtkIdType polygon = cell - mesh->GetNumberOfVerts() - mesh->GetNumberOfLines();
  const vtkIdType polygons = mesh->GetNumberOfPolys();
  vtkNew<vtkIdList> list;
  CellPoints points;
  TakeCellPoints(polygon < polygons ? mesh->GetPolys() : mesh->GetStrips(),
    polygon < polygons ? polygon : polygon - polygons, this->From.Sources[from].GetIds(), list,
    points);
  return target.Cells.count(points) != 0;
}

//------------------------------------------------------------------------------
void vtkRelievoMovedPoints::AddCells(int mesh)
{
  vtkPolyData* data = this->To.Meshes[static_cast<std::size_t>(mesh)].Mesh;
  vtkIdTypeArray* ids = this->To.Sources[static_cast<std::size_t>(mesh)].GetIds();
  vtkNew<vtkIdList> list;
  CellPoints points;
  for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      TakeCellPoints(cells, cell, ids, list, points);
      this->Targets[mesh].Cells.insert(points);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<vtkRelievoMovedPoints::Key> vtkRelievoMovedPoints::GetKeys(
  const vtkRelievoRayContent& scene)
{
  std::map<Key, int> counts;
  std::vector<Key> keys;
  for (std::size_t i = 0; i < scene.Meshes.size(); ++i)
  {
    const vtkRelievoRaySource& source = scene.Sources[i];
    Key key(source.Actor, source.Added, scene.Meshes[i].Block, 0);
    std::get<3>(key) = counts[key]++;
    keys.push_back(key);
  }
  return keys;
}

//------------------------------------------------------------------------------
void vtkRelievoMovedPoints::Add(int mesh)
{
  const vtkRelievoPlacedMesh& placed = this->To.Meshes[static_cast<std::size_t>(mesh)];
  Target& target = this->Targets[mesh];
  for (std::size_t k = 0; placed.Points && k < placed.Points->size(); ++k)
  {
    target.Places.emplace((*placed.Points)[k], k);
  }
  vtkIdTypeArray* points = this->To.Sources[static_cast<std::size_t>(mesh)].GetIds();
  for (vtkIdType k = 0; points && k < points->GetNumberOfTuples(); ++k)
  {
    const auto [known, isNew] = target.Points.emplace(points->GetValue(k), k);
    if (!isNew && known->second >= 0)
    {
      glm::dvec3 first, again;
      placed.Mesh->GetPoint(known->second, &first.x);
      placed.Mesh->GetPoint(k, &again.x);
      known->second = first == again ? known->second : -1;
    }
  }
}
