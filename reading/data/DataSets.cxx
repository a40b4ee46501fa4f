// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataSets.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <numeric>

namespace reading
{
//------------------------------------------------------------------------------
void ForEachDataSet(vtkDataObject* data, const std::function<void(vtkDataSet*)>& visit)
{
  if (vtkDataSet* dataSet = vtkDataSet::SafeDownCast(data))
  {
    visit(dataSet);
  }
  else if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      if (vtkDataSet* block = vtkDataSet::SafeDownCast(blocks->GetCurrentDataObject()))
      {
        visit(block);
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReplaceDataSets(
  vtkDataObject* data, const std::function<vtkSmartPointer<vtkDataObject>(vtkDataObject*)>& change)
{
  auto* from = vtkCompositeDataSet::SafeDownCast(data);
  if (!from)
  {
    return change(data);
  }
  const auto to = vtkSmartPointer<vtkCompositeDataSet>::Take(from->NewInstance());
  to->CopyStructure(from);
  const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(from->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    to->SetDataSet(blocks, ReplaceDataSets(blocks->GetCurrentDataObject(), change));
  }
  return to;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> CopyDataSets(vtkDataObject* data)
{
  return ReplaceDataSets(data, [](vtkDataObject* block) {
    auto copy = vtkSmartPointer<vtkDataObject>::Take(block->NewInstance());
    copy->ShallowCopy(block);
    return copy;
  });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> KeepPoints(vtkDataObject* data)
{
  return ReplaceDataSets(data, [](vtkDataObject* block) -> vtkSmartPointer<vtkDataObject> {
    auto* from = vtkDataSet::SafeDownCast(block);
    if (!from)
    {
      return block;
    }
    auto to = vtkSmartPointer<vtkPolyData>::New();
    if (auto* set = vtkPointSet::SafeDownCast(from))
    {
      to->SetPoints(set->GetPoints());
    }
    else
    {
      vtkNew<vtkPoints> points;
      points->SetDataTypeToDouble();
      points->SetNumberOfPoints(from->GetNumberOfPoints());
      for (vtkIdType i = 0; i < from->GetNumberOfPoints(); ++i)
      {
        points->SetPoint(i, from->GetPoint(i));
      }
      to->SetPoints(points);
    }
    to->GetPointData()->ShallowCopy(from->GetPointData());
    to->SetFieldData(from->GetFieldData());
    return to;
  });
}

//------------------------------------------------------------------------------
void NumberCells(vtkDataSet* data)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("vtkOriginalCellIds");
  ids->SetNumberOfTuples(data->GetNumberOfCells());
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + data->GetNumberOfCells(), vtkIdType(0));
  data->GetCellData()->AddArray(ids);
}
}
