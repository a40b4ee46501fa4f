// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelSurface.h"

#include "vtkRelievoVTKVersions.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <atomic>
#include <cmath>
#include <cstring>

namespace
{
// The finaliser of splitmix64 (Steele, Lea and Flood 2014).
std::uint64_t Mix(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

std::uint64_t HashOf(const double* point)
{
  std::uint64_t hash = 0;
  for (int c = 0; c < 3; ++c)
  {
    const double value = point[c] + 0.; // -0 is 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    hash = Mix(hash ^ bits);
  }
  return hash;
}

// Cuts polygons whose fan would leave their outline.
class PolygonCutter
{
public:
  explicit PolygonCutter(const double* points)
    : Places(points)
  {
  }

  // Whether no corner turns against the others. True if that is undefined, for example without
  // area.
  bool IsConvex(const vtkIdType* ids, vtkIdType size) const
  {
    const glm::dvec3 first = this->PlaceOf(ids[0]);
    glm::dvec3 normal(0.);
    for (vtkIdType i = 2; i < size; ++i)
    {
      normal += glm::cross(this->PlaceOf(ids[i - 1]) - first, this->PlaceOf(ids[i]) - first);
    }
    const double limit = -1e-10 * glm::dot(normal, normal);
    for (vtkIdType i = 0; i < size; ++i)
    {
      const glm::dvec3 at = this->PlaceOf(ids[i]);
      const glm::dvec3 turn = glm::cross(
        at - this->PlaceOf(ids[(i + size - 1) % size]), this->PlaceOf(ids[(i + 1) % size]) - at);
      if (glm::dot(turn, normal) < limit)
      {
        return false;
      }
    }
    return true;
  }

  // Cuts ears by VTK; uses a fan if VTK finds none.
  template <typename Add>
  void Cut(const vtkIdType* ids, vtkIdType size, Add&& add)
  {
    this->Polygon->Initialize();
    this->Polygon->PointIds->SetNumberOfIds(size);
    this->Polygon->Points->SetDataTypeToDouble();
    this->Polygon->Points->SetNumberOfPoints(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Polygon->PointIds->SetId(i, i);
      this->Polygon->Points->SetPoint(i, this->Places + 3 * ids[i]);
    }
    this->Corners->Reset();
#ifdef RELIEVO_VTK_TRIANGULATE_LOCAL_IDS
    const int cut = this->Polygon->TriangulateLocalIds(0, this->Corners);
#else
    const int cut = this->Polygon->Triangulate(this->Corners);
#endif
    const bool fan = !cut || this->Corners->GetNumberOfIds() != 3 * (size - 2);
    for (vtkIdType i = 0; i < size - 2; ++i)
    {
      add(ids[fan ? 0 : this->Corners->GetId(3 * i)],
        ids[fan ? i + 1 : this->Corners->GetId(3 * i + 1)],
        ids[fan ? i + 2 : this->Corners->GetId(3 * i + 2)]);
    }
  }

private:
  glm::dvec3 PlaceOf(vtkIdType id) const
  {
    return glm::make_vec3(this->Places + 3 * id);
  }

  const double* Places;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Corners;
};
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelSurface::Add(vtkPolyData* mesh, const vtkRelievoVoxelGrid& grid)
{
  vtkPoints* points = mesh->GetPoints();
  if (!points)
  {
    return;
  }
  const auto offset = static_cast<vtkIdType>(this->Points.size() / 3);
  const vtkIdType count = points->GetNumberOfPoints();
  this->Points.resize(static_cast<std::size_t>(3 * (offset + count)));
  this->PointHashes.resize(static_cast<std::size_t>(offset + count));
  vtkSMPTools::For(0, count, 4096, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      double* place = &this->Points[static_cast<std::size_t>(3 * (offset + i))];
      points->GetPoint(i, place);
      for (int axis = 0; axis < 3; ++axis)
      {
        place[axis] = grid.ToGrid(place[axis], axis);
      }
      this->PointHashes[static_cast<std::size_t>(offset + i)] = HashOf(place);
    }
  });

  const std::size_t firstTriangle = this->Triangles.size();
  const auto addTriangle = [&](vtkIdType a, vtkIdType b, vtkIdType c) {
    double sum = 0.;
    for (const vtkIdType id : { a, b, c })
    {
      const double* place = &this->Points[static_cast<std::size_t>(3 * (offset + id))];
      sum += std::abs(place[0]) + std::abs(place[1]) + std::abs(place[2]);
    }
    if (!std::isfinite(sum))
    {
      ++this->Invalid;
      return;
    }
    this->Triangles.insert(this->Triangles.end(), { offset + a, offset + b, offset + c });
  };
  vtkUnsignedCharArray* ghosts = mesh->GetCellData()
    ? vtkUnsignedCharArray::SafeDownCast(
        mesh->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()))
    : nullptr;
  const vtkIdType firstPolygon = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const auto isGhost = [&](vtkIdType cell) {
    return ghosts && cell < ghosts->GetNumberOfTuples() &&
      (ghosts->GetValue(cell) &
        (vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL));
  };
  this->Triangles.reserve(firstTriangle + static_cast<std::size_t>(3 * mesh->GetNumberOfPolys()));
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  vtkIdType cell = firstPolygon;
  PolygonCutter cutter(this->Points.data() + 3 * offset);
  auto it = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
  {
    it->GetCurrentCell(size, ids);
    if (size > 3 && !isGhost(cell) && !cutter.IsConvex(ids, size))
    {
      cutter.Cut(ids, size, addTriangle);
      continue;
    }
    for (vtkIdType i = 2; i < size && !isGhost(cell); ++i)
    {
      addTriangle(ids[0], ids[i - 1], ids[i]);
    }
  }
  it = vtk::TakeSmartPointer(mesh->GetStrips()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
  {
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 2; i < size && !isGhost(cell); ++i)
    {
      addTriangle(ids[i - 2], ids[i - 1], ids[i]);
    }
  }
  this->HashEdges(firstTriangle / 3);
}

//------------------------------------------------------------------------------
void vtkRelievoVoxelSurface::HashEdges(std::size_t firstTriangle)
{
  std::atomic<std::uint64_t> all{ this->EdgeHash };
  vtkSMPTools::For(static_cast<vtkIdType>(firstTriangle), this->GetNumberOfTriangles(), 4096,
    [&](vtkIdType begin, vtkIdType end) {
      std::uint64_t sum = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType* ids = &this->Triangles[static_cast<std::size_t>(3 * i)];
        for (int c = 0; c < 3; ++c)
        {
          const std::uint64_t a = this->PointHashes[static_cast<std::size_t>(ids[c])];
          const std::uint64_t b = this->PointHashes[static_cast<std::size_t>(ids[(c + 1) % 3])];
          sum ^= a == b ? 0 : Mix(a + b); // zero length: it crosses nothing
        }
      }
      all ^= sum;
    });
  this->EdgeHash = all;
}
