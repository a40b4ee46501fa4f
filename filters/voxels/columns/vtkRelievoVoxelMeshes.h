// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The polygons of any data set, and the leaves of composite data.
#ifndef vtkRelievoVoxelMeshes_h
#define vtkRelievoVoxelMeshes_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkPolyData;

namespace vtkRelievoVoxelMeshes
{
// The data set, or a composite's data sets.
std::vector<vtkDataSet*> GetLeaves(vtkDataObject* data);

// False if no point has finite coordinates.
bool GetBounds(vtkDataObject* data, double bounds[6]);

// A vtkPolyData itself, otherwise the outer surface.
vtkSmartPointer<vtkPolyData> GetSurface(vtkDataSet* data);
}

#endif
