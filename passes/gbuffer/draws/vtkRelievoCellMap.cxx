// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCellMap.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRelievoVTKVersions.h"

#include <algorithm>
#include <iterator>

namespace
{
enum Kind
{
  Verts,
  Lines,
  Polys,
  Strips
};

vtkCellArray* GetCells(vtkPolyData* mesh, int kind)
{
  vtkCellArray* cells[vtkRelievoCellMap::Kinds] = { mesh->GetVerts(), mesh->GetLines(),
    mesh->GetPolys(), mesh->GetStrips() };
  return cells[kind];
}

// The number of primitives that VTK makes from a cell of `points` points, those without area
// included.
vtkIdType CountPrimitives(int kind, int representation, vtkIdType points)
{
  if (kind == Verts || representation == VTK_POINTS)
  {
    return points;
  }
  vtkIdType count = points - 2;
  if (kind == Lines)
  {
    count = points - 1;
  }
  else if (representation == VTK_WIREFRAME)
  {
    count = kind == Polys ? points : 2 * points - 3;
  }
  return std::max<vtkIdType>(0, count);
}

#ifdef RELIEVO_VTK_EAR_CLIPPING
// VTK draws all triangles of polygons, those without area included.
constexpr bool DropsTriangles = false;
#else
constexpr bool DropsTriangles = true;
#endif

template <typename Point>
bool AreEqual(const Point& a, const Point& b)
{
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

// VTK before 9.7 skips triangles of a polygon's fan with two corners at one position. Calls f(cell,
// triangles drawn) for every cell.
template <typename GetPoint, typename Function>
void ForDrawnTriangles(vtkCellArray* cells, GetPoint getPoint, Function f)
{
  const vtkIdType* ids = nullptr;
  vtkIdType size = 0;
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    it->GetCurrentCell(size, ids);
    vtkIdType drawn = 0;
    for (vtkIdType i = 2; i < size; ++i)
    {
      const auto a = getPoint(ids[0]);
      const auto b = getPoint(ids[i - 1]);
      const auto c = getPoint(ids[i]);
      drawn += AreEqual(a, b) || AreEqual(b, c) || AreEqual(c, a) ? 0 : 1;
    }
    f(it->GetCurrentCellId(), drawn);
  }
}

template <typename Function>
void ForDrawnTriangles(vtkPolyData* mesh, Function f)
{
  vtkCellArray* cells = mesh->GetPolys();
  vtkDataArray* points = mesh->GetPoints()->GetData();
  const auto forPlain = [&](auto* plain) {
    if (plain)
    {
      const auto* p = plain->GetPointer(0);
      ForDrawnTriangles(
        cells, [p](vtkIdType i) { return p + 3 * i; }, f);
    }
    return plain != nullptr;
  };
  if (forPlain(vtkAOSDataArrayTemplate<float>::FastDownCast(points)) ||
    forPlain(vtkAOSDataArrayTemplate<double>::FastDownCast(points)))
  {
    return;
  }
  ForDrawnTriangles(
    cells,
    [points](vtkIdType i) {
      std::array<double, 3> point;
      points->GetTuple(i, point.data());
      return point;
    },
    f);
}
}

//------------------------------------------------------------------------------
vtkRelievoCellMap::vtkRelievoCellMap(vtkPolyData* mesh, int representation)
{
  vtkIdType first = 0;
  for (int kind = 0; kind < Kinds; ++kind)
  {
    this->Parts[kind].FirstCell = first;
    if (GetCells(mesh, kind)->GetNumberOfCells() > 0 && mesh->GetPoints())
    {
      this->Fill(this->Parts[kind], mesh, kind, representation);
    }
    first += GetCells(mesh, kind)->GetNumberOfCells();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoCellMap::Fill(Part& part, vtkPolyData* mesh, int kind, int representation)
{
  vtkCellArray* cells = GetCells(mesh, kind);
  const vtkIdType count = cells->GetNumberOfCells();
  const vtkIdType size = cells->IsHomogeneous();
  part.PerCell = size > 0 ? CountPrimitives(kind, representation, size) : 0;
  bool equal = part.PerCell > 0;
  const bool fans = DropsTriangles && kind == Polys && representation == VTK_SURFACE;
  if (fans && equal)
  {
    ForDrawnTriangles(
      mesh, [&](vtkIdType, vtkIdType drawn) { equal = equal && drawn == part.PerCell; });
  }
  if (equal)
  {
    part.Size = count * part.PerCell;
    return;
  }
  part.PerCell = 0;
  auto add = [&part](vtkIdType cell, vtkIdType primitives) {
    part.Cells.insert(
      part.Cells.end(), static_cast<std::size_t>(primitives), static_cast<std::uint32_t>(cell));
  };
  if (fans)
  {
    ForDrawnTriangles(mesh, add);
  }
  else
  {
    for (vtkIdType cell = 0; cell < count; ++cell)
    {
      add(cell, CountPrimitives(kind, representation, cells->GetCellSize(cell)));
    }
  }
  part.Size = static_cast<vtkIdType>(part.Cells.size());
}

//------------------------------------------------------------------------------
const vtkRelievoCellMap::Part* vtkRelievoCellMap::Find(
  const Offsets& offsets, vtkIdType primitive, vtkIdType& place) const
{
  for (int kind = Kinds - 1; kind >= 0; --kind)
  {
    const Part& part = this->Parts[kind];
    place = primitive - offsets[kind];
    if (place >= 0 && place < part.Size)
    {
      return &part;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoCellMap::GetEnd(const Offsets& offsets) const
{
  vtkIdType end = offsets[0];
  for (int kind = 0; kind < Kinds; ++kind)
  {
    end = this->Parts[kind].Size > 0 ? offsets[kind] + this->Parts[kind].Size : end;
  }
  return end;
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoCellMap::GetCell(const Offsets& offsets, vtkIdType primitive) const
{
  vtkIdType place = 0;
  const Part* part = this->Find(offsets, primitive, place);
  if (!part)
  {
    return -1;
  }
  return part->FirstCell + (part->PerCell > 0 ? place / part->PerCell : part->Cells[place]);
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoCellMap::GetPrimitiveInCell(const Offsets& offsets, vtkIdType primitive) const
{
  vtkIdType place = 0;
  const Part* part = this->Find(offsets, primitive, place);
  if (!part)
  {
    return 0;
  }
  if (part->PerCell > 0)
  {
    return place % part->PerCell;
  }
  // Binary search: a cell may have millions of primitives (a long line).
  const auto end = part->Cells.begin() + place;
  return end - std::lower_bound(part->Cells.begin(), end, part->Cells[place]);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoCellMaps::GetTime(vtkPolyData* mesh)
{
  vtkMTimeType time = mesh->GetPoints() ? mesh->GetPoints()->GetMTime() : 0;
  for (int kind = 0; kind < vtkRelievoCellMap::Kinds; ++kind)
  {
    // For a kind without cells VTK returns an array shared by all meshes.
    vtkCellArray* cells = GetCells(mesh, kind);
    time = std::max(time, cells->GetNumberOfCells() > 0 ? cells->GetMTime() : 0);
  }
  return time;
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkRelievoCellMap> vtkRelievoCellMaps::Get(
  vtkPolyData* mesh, int representation)
{
  Entry& entry = this->Entries[std::make_pair(mesh, representation)];
  const vtkMTimeType time = GetTime(mesh);
  if (!entry.Map || entry.Mesh != mesh || entry.Time != time)
  {
    entry.Mesh = mesh;
    entry.Time = time;
    entry.Map = std::make_shared<vtkRelievoCellMap>(mesh, representation);
  }
  return entry.Map;
}

//------------------------------------------------------------------------------
void vtkRelievoCellMaps::Prune()
{
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    it = it->second.Mesh ? std::next(it) : this->Entries.erase(it);
  }
}
