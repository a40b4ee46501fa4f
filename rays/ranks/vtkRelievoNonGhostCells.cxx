// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoNonGhostCells.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

//------------------------------------------------------------------------------
vtkUnsignedCharArray* vtkRelievoNonGhostCells::GetGhosts(vtkPolyData* mesh)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    mesh->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts && ghosts->GetNumberOfValues() == mesh->GetNumberOfCells() ? ghosts : nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkRelievoNonGhostCells::Find(vtkPolyData* mesh)
{
  vtkUnsignedCharArray* ghosts = GetGhosts(mesh);
  const auto isCopy = [ghosts](vtkIdType cell) {
    return (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
  };
  bool any = false;
  for (vtkIdType cell = 0; ghosts && !any && cell < ghosts->GetNumberOfValues(); ++cell)
  {
    any = isCopy(cell);
  }
  if (!any)
  {
    return mesh;
  }
  vtkNew<vtkCellArray> kept[2];
  vtkCellArray* const all[2] = { mesh->GetPolys(), mesh->GetStrips() };
  vtkIdType cell = 0;
  for (int i = 0; i < 2; ++i)
  {
    auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(all[i]->NewIterator());
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      it->GetCurrentCell(count, ids);
      if (!isCopy(cell++))
      {
        kept[i]->InsertNextCell(count, ids);
      }
    }
  }
  auto own = vtkSmartPointer<vtkPolyData>::New();
  own->SetPoints(mesh->GetPoints());
  own->SetPolys(kept[0]);
  own->SetStrips(kept[1]);
  return own;
}
