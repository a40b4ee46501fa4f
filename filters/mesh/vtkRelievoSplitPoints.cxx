// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSplitPoints.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace relievo
{
//------------------------------------------------------------------------------
void SplitPoints(vtkPolyData* input, const std::vector<vtkIdType>& originals,
  const std::vector<vtkIdType>& corners, vtkPolyData* output)
{
  output->ShallowCopy(input);
  const auto count = static_cast<vtkIdType>(originals.size());
  if (count > input->GetNumberOfPoints())
  {
    vtkNew<vtkIdList> from;
    vtkNew<vtkIdList> to;
    from->SetNumberOfIds(count);
    to->SetNumberOfIds(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      from->SetId(i, originals[i]);
      to->SetId(i, i);
    }
    vtkNew<vtkPoints> points;
    points->SetDataType(input->GetPoints()->GetDataType());
    points->SetNumberOfPoints(count);
    points->InsertPoints(to, from, input->GetPoints());
    vtkNew<vtkPolyData> split;
    split->GetPointData()->CopyAllOn();
    split->GetPointData()->CopyAllocate(input->GetPointData(), count);
    split->GetPointData()->CopyData(input->GetPointData(), from, to);
    output->SetPoints(points);
    output->GetPointData()->ShallowCopy(split->GetPointData());

    vtkCellArray* old = input->GetPolys();
    vtkNew<vtkCellArray> polys;
    polys->AllocateExact(old->GetNumberOfCells(), old->GetNumberOfConnectivityIds());
    std::size_t corner = 0;
    for (vtkIdType cell = 0; cell < old->GetNumberOfCells(); ++cell)
    {
      const vtkIdType size = old->GetCellSize(cell);
      polys->InsertNextCell(size, corners.data() + corner);
      corner += static_cast<std::size_t>(size);
    }
    output->SetPolys(polys);
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("vtkOriginalPointIds");
  ids->SetNumberOfValues(count);
  std::copy(originals.begin(), originals.end(), ids->GetPointer(0));
  output->GetPointData()->AddArray(ids);
}
}
