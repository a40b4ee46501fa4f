// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Copies a model's point data to nearby points.
#ifndef vtkRelievoVoxelNearest_h
#define vtkRelievoVoxelNearest_h

#include "vtkType.h"

#include <string>

class vtkDataSet;
class vtkPointData;
class vtkPoints;

namespace vtkRelievoVoxelNearest
{
// Copies the data of the nearest point to each point. Returns the names of arrays left out because
// cubes have their own arrays of these names.
std::string Add(vtkDataSet* model, vtkPoints* points, vtkPointData* output);

// The bytes that Add needs for so many points.
double EstimateBytes(vtkDataSet* model, double points);
}

#endif
