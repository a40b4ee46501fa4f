// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCell.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkPolyData.h"

//------------------------------------------------------------------------------
vtkRelievoCell::vtkRelievoCell(vtkPolyData* mesh, vtkIdType cell, vtkIdList* scratch)
{
  vtkCellArray* arrays[4] = { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(),
    mesh->GetStrips() };
  for (this->Kind = Verts; this->Kind <= Strips; ++this->Kind)
  {
    vtkCellArray* array = arrays[this->Kind];
    const vtkIdType count = array->GetNumberOfCells();
    if (cell >= count)
    {
      cell -= count;
      continue;
    }
    if (array->IsStorageShareable())
    {
      array->GetCellAtId(cell, this->Count, this->Points);
    }
    else
    {
      array->GetCellAtId(cell, scratch);
      this->Count = scratch->GetNumberOfIds();
      this->Points = scratch->GetPointer(0);
    }
    return;
  }
}
