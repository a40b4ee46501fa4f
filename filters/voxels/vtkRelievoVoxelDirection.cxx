// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoVoxelDirection.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"

#include <cmath>

//------------------------------------------------------------------------------
vtkRelievoVoxelDirection::vtkRelievoVoxelDirection(vtkImageData* image)
{
  const vtkMatrix3x3* matrix = image->GetDirectionMatrix();
  double columns[3][3];
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      columns[axis][row] = matrix->GetElement(row, axis);
      this->Turned = this->Turned || columns[axis][row] != (row == axis ? 1. : 0.);
    }
  }
  for (int a = 0; a < 3; ++a)
  {
    for (int b = a; b < 3; ++b)
    {
      const double product = vtkMath::Dot(columns[a], columns[b]);
      this->Skewed = this->Skewed || !(std::abs(product - (a == b ? 1. : 0.)) < 1e-6);
    }
  }
  if (!this->Turned || this->Skewed)
  {
    return;
  }
  // A box equals its mirror image.
  const double sign = vtkMath::Determinant3x3(columns) < 0. ? -1. : 1.;
  double turn[3][3];
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      turn[row][axis] = sign * columns[axis][row];
    }
  }
  vtkMath::Matrix3x3ToQuaternion(turn, this->Quaternion);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> vtkRelievoVoxelDirection::MakeArray(
  const char* name, vtkIdType tuples) const
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(4);
  array->SetNumberOfTuples(tuples);
  for (int c = 0; c < 4; ++c)
  {
    array->FillTypedComponent(c, static_cast<float>(this->Quaternion[c]));
  }
  return array;
}
