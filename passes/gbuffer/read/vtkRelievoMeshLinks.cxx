// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMeshLinks.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <iterator>

namespace
{
// Calls visit(point, cell) for the corners, if the arrays hold integers of this type.
template <typename Integer, typename Visit>
bool VisitTyped(vtkCellArray* cells, const Visit& visit)
{
  using Array = vtkAOSDataArrayTemplate<Integer>;
  auto* offsets = Array::FastDownCast(cells->GetOffsetsArray());
  auto* corners = Array::FastDownCast(cells->GetConnectivityArray());
  if (!offsets || !corners)
  {
    return false;
  }
  const Integer* from = offsets->GetPointer(0);
  const Integer* points = corners->GetPointer(0);
  const vtkIdType count = cells->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    for (Integer i = from[cell]; i < from[cell + 1]; ++i)
    {
      visit(static_cast<vtkIdType>(points[i]), cell);
    }
  }
  return true;
}

template <typename Visit>
void VisitCorners(vtkCellArray* cells, const Visit& visit)
{
  if (VisitTyped<vtkTypeInt32>(cells, visit) || VisitTyped<vtkTypeInt64>(cells, visit))
  {
    return;
  }
  vtkNew<vtkIdList> scratch;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, scratch);
    for (vtkIdType i = 0; i < scratch->GetNumberOfIds(); ++i)
    {
      visit(scratch->GetId(i), cell);
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkRelievoMeshLinks::Links::Build(vtkPolyData* mesh)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  const vtkIdType polys = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const vtkIdType strips = polys + mesh->GetNumberOfPolys();
  const auto forCorners = [&](const auto& f) {
    VisitCorners(
      mesh->GetPolys(), [&](vtkIdType point, vtkIdType cell) { f(point, polys + cell); });
    VisitCorners(
      mesh->GetStrips(), [&](vtkIdType point, vtkIdType cell) { f(point, strips + cell); });
  };
  // Each offset starts at the end of its point's cells, and moves back by one for every cell
  // inserted.
  this->Offsets.assign(static_cast<std::size_t>(points) + 1, 0);
  forCorners([&](vtkIdType point, vtkIdType) { ++this->Offsets[point]; });
  for (vtkIdType i = 0; i < points; ++i)
  {
    this->Offsets[i + 1] += this->Offsets[i];
  }
  this->Cells.resize(static_cast<std::size_t>(this->Offsets[points]));
  forCorners([&](vtkIdType point, vtkIdType id) { this->Cells[--this->Offsets[point]] = id; });
}

//------------------------------------------------------------------------------
bool vtkRelievoMeshLinks::Entry::IsValid() const
{
  return this->Mesh && this->Mesh->GetMTime() == this->Time;
}

//------------------------------------------------------------------------------
const vtkRelievoMeshLinks::Links& vtkRelievoMeshLinks::Get(vtkPolyData* mesh)
{
  Entry& entry = this->Entries[mesh];
  if (!entry.IsValid())
  {
    entry.Mesh = mesh;
    entry.Time = mesh->GetMTime();
    entry.Cells.Build(mesh);
  }
  return entry.Cells;
}

//------------------------------------------------------------------------------
void vtkRelievoMeshLinks::Prune()
{
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    it = it->second.IsValid() ? std::next(it) : this->Entries.erase(it);
  }
}
