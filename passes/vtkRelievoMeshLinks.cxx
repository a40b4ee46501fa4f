// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMeshLinks.h"

#include "vtkPolyData.h"

//------------------------------------------------------------------------------
bool vtkRelievoMeshLinks::Entry::IsValid() const
{
  return this->Mesh && this->Mesh->GetMTime() == this->Time;
}

//------------------------------------------------------------------------------
vtkRelievoMeshLinks::Links& vtkRelievoMeshLinks::Get(vtkPolyData* mesh)
{
  Entry& entry = this->Entries[mesh];
  if (!entry.IsValid())
  {
    entry.Mesh = mesh;
    entry.Time = mesh->GetMTime();
    entry.Cells.reset(new Links);
    entry.Cells->BuildLinks(mesh);
  }
  return *entry.Cells;
}

//------------------------------------------------------------------------------
void vtkRelievoMeshLinks::Prune()
{
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    it = it->second.IsValid() ? std::next(it) : this->Entries.erase(it);
  }
}
