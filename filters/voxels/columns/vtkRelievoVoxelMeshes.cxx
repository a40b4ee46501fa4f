// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelMeshes.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cmath>

//------------------------------------------------------------------------------
std::vector<vtkDataSet*> vtkRelievoVoxelMeshes::GetLeaves(vtkDataObject* data)
{
  std::vector<vtkDataSet*> leaves;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (auto* leaf = vtkDataSet::SafeDownCast(it->GetCurrentDataObject()))
      {
        leaves.push_back(leaf);
      }
    }
  }
  else if (auto* single = vtkDataSet::SafeDownCast(data))
  {
    leaves.push_back(single);
  }
  return leaves;
}

//------------------------------------------------------------------------------
bool vtkRelievoVoxelMeshes::GetBounds(vtkDataObject* data, double bounds[6])
{
  vtkBoundingBox box;
  for (vtkDataSet* leaf : GetLeaves(data))
  {
    double own[6];
    leaf->GetBounds(own);
    bool finite = leaf->GetNumberOfPoints() > 0;
    for (const double value : own)
    {
      finite = finite && std::isfinite(value);
    }
    if (finite)
    {
      box.AddBounds(own);
      continue;
    }
    // Non-finite points spoil VTK's bounds.
    for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
    {
      double place[3];
      leaf->GetPoint(i, place);
      if (std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]))
      {
        box.AddPoint(place);
      }
    }
  }
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
  return box.IsValid() != 0;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkRelievoVoxelMeshes::GetSurface(vtkDataSet* data)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh;
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(data);
  surface->Update();
  return surface->GetOutput();
}
