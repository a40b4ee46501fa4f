// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMeshLinks.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRelievoCellGeometry.h"

#include <iterator>

//------------------------------------------------------------------------------
void vtkRelievoMeshLinks::Links::Build(vtkPolyData* mesh)
{
  const vtkIdType points = mesh->GetNumberOfPoints();
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  const vtkIdType last = first + mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips();
  vtkNew<vtkIdList> scratch;
  auto forCorners = [&](auto f) {
    for (vtkIdType id = first; id < last; ++id)
    {
      const vtkRelievoCell cell(mesh, id, scratch);
      for (vtkIdType i = 0; i < cell.Count; ++i)
      {
        f(cell.Points[i], id);
      }
    }
  };
  // Each point's offset is first where its cells end, and goes back by one for every cell put in.
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
