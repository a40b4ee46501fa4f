// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Validate.h"

#include "DataSets.h"
#include "Errors.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

namespace scene
{
namespace
{
void CheckCellArray(vtkCellArray* cells, vtkIdType numberOfPoints, const std::string& path)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  if (!cells->IsValid())
  {
    throw WorkError(path + ": its cells are broken: the places where they begin are out of order");
  }
  vtkDataArray* points = cells->GetConnectivityArray();
  if (points->GetNumberOfTuples() == 0)
  {
    return;
  }
  double range[2];
  points->GetRange(range, 0);
  if (range[0] < 0 || range[1] >= static_cast<double>(numberOfPoints))
  {
    const double wrong = range[0] < 0 ? range[0] : range[1];
    throw WorkError(path + ": a cell uses point " + std::to_string(static_cast<long long>(wrong)) +
      ", but there are points 0 to " + std::to_string(numberOfPoints - 1) +
      " only; is the file whole?");
  }
}
}

//------------------------------------------------------------------------------
void CheckCells(vtkDataObject* data, const std::string& path)
{
  ForEachDataSet(data, [&path](vtkDataSet* block) {
    if (vtkPolyData* mesh = vtkPolyData::SafeDownCast(block))
    {
      for (vtkCellArray* cells :
        { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
      {
        CheckCellArray(cells, mesh->GetNumberOfPoints(), path);
      }
    }
    else if (vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(block))
    {
      CheckCellArray(grid->GetCells(), grid->GetNumberOfPoints(), path);
    }
  });
}
}
