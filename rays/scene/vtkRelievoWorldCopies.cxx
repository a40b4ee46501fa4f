// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoWorldCopies.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRelievoRaySource.h"

#include <algorithm>
#include <cmath>

namespace
{
// Least volume of a box, relative to a rectangular one with its sides.
constexpr double Flat = 1e-6;
constexpr vtkIdType MostCorners = 1 << 24; // of copies

// Restores the outside of cells mirrored by a matrix: reverses polygons from the same corner, so
// that their triangles are the same, and repeats the first corner of strips.
void AppendTurned(vtkCellArray* all, vtkCellArray* cells, vtkIdType first, bool strips)
{
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(count, ids);
    all->InsertNextCell(static_cast<int>(count + (strips && count > 0 ? 1 : 0)));
    for (vtkIdType i = 0; i < count; ++i)
    {
      all->InsertCellPoint(first + ids[strips || i == 0 ? i : count - i]);
      if (strips && i == 0)
      {
        all->InsertCellPoint(first + ids[0]);
      }
    }
  }
}

// Ways of tracing rays in a mesh.
enum class Entry
{
  ByMatrix,
  ByScaledMatrix, // by the matrix divided by its last element
  ByCopy,         // by a copy in world coordinates: the matrix has no exact inverse
  // A matrix is not finite, or maps points to infinity or beyond; or there are too many copies.
  None
};

bool IsCopiedAtMost(const vtkRelievoPlacedMesh& placed, vtkIdType most)
{
  const vtkIdType corners = placed.Mesh->GetPolys()->GetNumberOfConnectivityIds() +
    placed.Mesh->GetStrips()->GetNumberOfConnectivityIds();
  return corners <= most / static_cast<vtkIdType>(placed.GetNumberOfPlaces());
}

Entry FindEntry(const vtkRelievoPlacedMesh& placed)
{
  const glm::dmat4& matrix = placed.MeshToWorld;
  const double* const first = &matrix[0][0];
  const glm::dvec4 last(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]);
  const glm::dmat3 turn(matrix);
  const double volume = std::abs(glm::determinant(turn));
  if (!std::all_of(first, first + 16, [](double x) { return std::isfinite(x); }) ||
    !std::isfinite(volume))
  {
    return Entry::None;
  }
  const bool isAffine = glm::dvec3(last) == glm::dvec3(0.0);
  if (isAffine && last.w > 0.0 &&
    volume > Flat * glm::length(turn[0]) * glm::length(turn[1]) * glm::length(turn[2]))
  {
    return last.w == 1.0 ? Entry::ByMatrix : Entry::ByScaledMatrix;
  }
  if (!IsCopiedAtMost(placed, MostCorners) || (isAffine && !(last.w > 0.0)))
  {
    return Entry::None;
  }
  for (std::size_t k = 0; k < placed.GetNumberOfPlaces() && !isAffine; ++k)
  {
    for (vtkIdType i = 0; i < placed.Mesh->GetNumberOfPoints(); ++i)
    {
      glm::dvec4 point(0.0, 0.0, 0.0, 1.0);
      placed.Mesh->GetPoint(i, &point.x);
      if (!((placed.GetPlace(k) * point).w > 0.0))
      {
        return Entry::None;
      }
    }
  }
  return Entry::ByCopy;
}
}

//------------------------------------------------------------------------------
void vtkRelievoWorldCopies::Begin()
{
  this->Before.swap(this->Copies);
  this->Copies.clear();
}

//------------------------------------------------------------------------------
bool vtkRelievoWorldCopies::IsTraceable(const vtkRelievoPlacedMesh& placed)
{
  return FindEntry(placed) != Entry::None;
}

//------------------------------------------------------------------------------
void vtkRelievoWorldCopies::Enter(vtkRelievoPlacedMesh& placed, vtkRelievoRaySource& source)
{
  const Entry entry = FindEntry(placed);
  if (entry == Entry::ByScaledMatrix)
  {
    placed.MeshToWorld /= placed.MeshToWorld[3][3];
  }
  if (entry != Entry::ByCopy)
  {
    return;
  }
  Key key(placed.Mesh, placed.Places.get(), {});
  std::copy_n(&placed.MeshToWorld[0][0], 16, std::get<2>(key).begin());
  const auto before = this->Before.find(key);
  Copy& copy = before == this->Before.end()
    ? this->Copies[key]
    : this->Copies.try_emplace(key, before->second).first->second;
  if (copy.Mesh != placed.Mesh || copy.Time != placed.Mesh->GetMTime())
  {
    copy = { placed.Mesh, placed.Mesh->GetMTime(), placed.Places,
      vtkSmartPointer<vtkPolyData>::New() };
    CopyInWorld(placed, source.Cells, copy.InWorld);
  }
  source.PointsOfPlace = placed.Places ? placed.Mesh->GetNumberOfPoints() : 0;
  source.Cells = vtkIdTypeArray::SafeDownCast(copy.InWorld->GetCellData()->GetArray("cell"));
  placed.Mesh = copy.InWorld;
  placed.MeshToWorld = glm::dmat4(1.0);
  placed.Places = nullptr;
  placed.Points = nullptr;
}

//------------------------------------------------------------------------------
void vtkRelievoWorldCopies::CopyInWorld(
  const vtkRelievoPlacedMesh& placed, vtkIdTypeArray* cellsOfData, vtkPolyData* copy)
{
  vtkPolyData* mesh = placed.Mesh;
  const vtkIdType count = mesh->GetNumberOfPoints();
  const std::size_t places = placed.GetNumberOfPlaces();
  copy->Initialize();
  if (!placed.Places)
  {
    copy->GetPointData()->ShallowCopy(mesh->GetPointData());
    copy->GetCellData()->ShallowCopy(mesh->GetCellData());
    copy->GetPointData()->SetNormals(nullptr); // normals are not transformed
    copy->GetCellData()->SetNormals(nullptr);
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (std::size_t k = 0; k < places; ++k)
  {
    const glm::dmat4 matrix = placed.GetPlace(k);
    for (vtkIdType i = 0; i < count; ++i)
    {
      glm::dvec4 point(0.0, 0.0, 0.0, 1.0);
      mesh->GetPoint(i, &point.x);
      point = matrix * point;
      points->InsertNextPoint(point.x / point.w, point.y / point.w, point.z / point.w);
    }
  }
  copy->SetPoints(points);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("cell");
  vtkIdType first = 0;
  const auto gather = [&](vtkCellArray* cells) {
    auto all = vtkSmartPointer<vtkCellArray>::New();
    const bool strips = cells == mesh->GetStrips();
    const bool turns = strips || cells == mesh->GetPolys();
    for (std::size_t k = 0; k < places; ++k)
    {
      const vtkIdType offset = static_cast<vtkIdType>(k) * count;
      if (turns && glm::determinant(placed.GetPlace(k)) < 0.0)
      {
        AppendTurned(all, cells, offset, strips);
      }
      else
      {
        all->Append(cells, offset);
      }
      for (vtkIdType i = first; i < first + cells->GetNumberOfCells(); ++i)
      {
        ids->InsertNextValue(placed.Points ? (*placed.Points)[k]
            : cellsOfData                  ? cellsOfData->GetValue(i)
                                           : i);
      }
    }
    first += cells->GetNumberOfCells();
    return all;
  };
  copy->SetVerts(gather(mesh->GetVerts()));
  copy->SetLines(gather(mesh->GetLines()));
  copy->SetPolys(gather(mesh->GetPolys()));
  copy->SetStrips(gather(mesh->GetStrips()));
  copy->GetCellData()->AddArray(ids);
}
