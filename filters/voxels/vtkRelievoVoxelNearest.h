// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The point data of a model for points near it.
#ifndef vtkRelievoVoxelNearest_h
#define vtkRelievoVoxelNearest_h

#include "vtkType.h"

#include <string>

class vtkDataSet;
class vtkPointData;
class vtkPoints;

namespace vtkRelievoVoxelNearest
{
// The data of the nearest point, for each of the points. Returns the names of arrays that are left
// out, as cubes have their own of these names.
std::string Add(vtkDataSet* model, vtkPoints* points, vtkPointData* output);

// The bytes that this takes for so many points.
double EstimateBytes(vtkDataSet* model, double points);
}

#endif
