// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rotation of an image's cells by its direction matrix.
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
  // Whether the cells are not boxes.
  bool IsSkewed() const { return this->Skewed; }

  // An array that repeats the quaternion w x y z.
  vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, vtkIdType tuples) const;

private:
  bool Turned = false;
  bool Skewed = false;
  double Quaternion[4] = { 1., 0., 0., 0. };
};

#endif
