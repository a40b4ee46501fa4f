// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelCells.h"

#include "Check.h"

#include <vtkCellData.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

//------------------------------------------------------------------------------
void relievoTest::SetGrid(vtkRelievoVoxelShell* filter, int count)
{
  filter->SetBounds(-1.5, 1.5, -1.45, 1.55, -1.52, 1.48);
  filter->SetDimensions(count, count, count);
}

//------------------------------------------------------------------------------
relievoTest::Cells relievoTest::CellsOf(vtkRelievoVoxelShell* filter)
{
  filter->Update();
  RELIEVO_CHECK(filter->GetErrorCode() == vtkErrorCode::NoError);
  auto* mask =
    vtkUnsignedCharArray::SafeDownCast(filter->GetOutput()->GetCellData()->GetArray("mask"));
  const unsigned char* first = mask->GetPointer(0);
  return Cells(first, first + mask->GetNumberOfValues());
}

//------------------------------------------------------------------------------
relievoTest::Cells relievoTest::CellsOf(vtkDataObject* data, int method)
{
  vtkNew<vtkRelievoVoxelShell> filter;
  filter->SetInputDataObject(data);
  filter->SetMethod(method);
  SetGrid(filter);
  return CellsOf(filter);
}

//------------------------------------------------------------------------------
vtkIdType relievoTest::Differences(const Cells& a, const Cells& b)
{
  vtkIdType count = a.size() == b.size() ? 0 : 1000000;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
  {
    count += a[i] != b[i] ? 1 : 0;
  }
  return count;
}
