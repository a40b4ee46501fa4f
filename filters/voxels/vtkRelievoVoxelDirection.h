// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the cells of an image are turned by its direction matrix.
#ifndef vtkRelievoVoxelDirection_h
#define vtkRelievoVoxelDirection_h

#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

class vtkImageData;

class vtkRelievoVoxelDirection
{
public:
  explicit vtkRelievoVoxelDirection(vtkImageData* image);

  bool IsTurned() const { return this->Turned; }
  // Whether the cells are no boxes.
  bool IsSkewed() const { return this->Skewed; }

  // The quaternion w x y z, so many times.
  vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, vtkIdType tuples) const;

private:
  bool Turned = false;
  bool Skewed = false;
  double Quaternion[4] = { 1., 0., 0., 0. };
};

#endif
