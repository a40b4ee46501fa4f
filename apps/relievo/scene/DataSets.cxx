// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataSets.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

namespace cli
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
}
