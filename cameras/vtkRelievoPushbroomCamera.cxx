// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPushbroomCamera.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRelievoPushbroomCamera);

//------------------------------------------------------------------------------
bool vtkRelievoPushbroomCamera::GetCameraRay(
  double u, double v, double origin[3], double direction[3])
{
  if (!std::isfinite(u + v))
  {
    Nowhere(origin, 3);
    return Nowhere(direction, 3);
  }
  for (int i = 0; i < 3; ++i)
  {
    origin[i] = v * this->Velocity[i];
  }
  direction[0] = (u - this->PrincipalColumn) / this->FocalLength;
  direction[1] = 0.0;
  direction[2] = 1.0;
  vtkMath::Normalize(direction);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoPushbroomCamera::ProjectCameraPoint(const double point[3], double pixel[2])
{
  const double row = point[1] / this->Velocity[1];
  const double side = point[0] - row * this->Velocity[0];
  const double ahead = point[2] - row * this->Velocity[2];
  if (!(std::isfinite(row + side) && ahead > 0.0))
  {
    return Nowhere(pixel, 2);
  }
  pixel[0] = this->FocalLength * side / ahead + this->PrincipalColumn;
  pixel[1] = row;
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoPushbroomCamera::Copy(vtkRelievoCameraModel* other)
{
  this->Superclass::Copy(other);
  if (auto* same = vtkRelievoPushbroomCamera::SafeDownCast(other))
  {
    this->FocalLength = same->FocalLength;
    this->PrincipalColumn = same->PrincipalColumn;
    std::copy_n(same->Velocity, 3, this->Velocity);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoPushbroomCamera::AddTo(vtkFieldData* fields)
{
  this->Superclass::AddTo(fields);
  AddText(fields, "lens", "push-broom");
  const double values[5] = { this->FocalLength, this->PrincipalColumn, this->Velocity[0],
    this->Velocity[1], this->Velocity[2] };
  AddNumbers(fields, "push_broom", values, 5);
}

//------------------------------------------------------------------------------
void vtkRelievoPushbroomCamera::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FocalLength: " << this->FocalLength << "\n";
  os << indent << "PrincipalColumn: " << this->PrincipalColumn << "\n";
  os << indent << "Velocity: " << this->Velocity[0] << ", " << this->Velocity[1] << ", "
     << this->Velocity[2] << "\n";
}
