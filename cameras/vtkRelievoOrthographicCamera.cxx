// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOrthographicCamera.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRelievoOrthographicCamera);

//------------------------------------------------------------------------------
std::vector<vtkRelievoSensorWords> vtkRelievoOrthographicCamera::GetWords()
{
  vtkRelievoSensorWords map = { "orthographic", "orthographic[:PIXELS]", { 0, 1 },
    ": a finite number above 0" };
  map.IsGood = [](const std::vector<double>& n) { return n[0] > 0.0; };
  map.Make = [](const std::vector<double>& n,
               const vtkRelievoSensorView& view) -> vtkRelievoCameraModel* {
    auto* made = vtkRelievoOrthographicCamera::New();
    made->SetPixelsPerUnit(n.empty() ? 0.5 * view.Rows / view.HalfHeight : n[0]);
    made->SetPrincipalPoint(0.5 * (view.Columns - 1), 0.5 * (view.Rows - 1));
    return made;
  };
  return { map };
}

//------------------------------------------------------------------------------
bool vtkRelievoOrthographicCamera::GetCameraRay(
  double u, double v, double origin[3], double direction[3])
{
  if (!std::isfinite(u + v))
  {
    Nowhere(origin, 3);
    return Nowhere(direction, 3);
  }
  origin[0] = (u - this->PrincipalPoint[0]) / this->PixelsPerUnit;
  origin[1] = (v - this->PrincipalPoint[1]) / this->PixelsPerUnit;
  origin[2] = direction[0] = direction[1] = 0.0;
  direction[2] = 1.0;
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoOrthographicCamera::ProjectCameraPoint(const double point[3], double pixel[2])
{
  if (!(std::isfinite(point[0] + point[1]) && point[2] >= 0.0))
  {
    return Nowhere(pixel, 2);
  }
  pixel[0] = this->PixelsPerUnit * point[0] + this->PrincipalPoint[0];
  pixel[1] = this->PixelsPerUnit * point[1] + this->PrincipalPoint[1];
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoOrthographicCamera::Copy(vtkRelievoCameraModel* other)
{
  this->Superclass::Copy(other);
  if (auto* same = vtkRelievoOrthographicCamera::SafeDownCast(other))
  {
    this->PixelsPerUnit = same->PixelsPerUnit;
    std::copy_n(same->PrincipalPoint, 2, this->PrincipalPoint);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoOrthographicCamera::AddTo(vtkFieldData* fields)
{
  this->Superclass::AddTo(fields);
  AddText(fields, "lens", "orthographic");
  const double values[3] = { this->PixelsPerUnit, this->PrincipalPoint[0],
    this->PrincipalPoint[1] };
  AddNumbers(fields, "orthographic", values, 3);
}

//------------------------------------------------------------------------------
void vtkRelievoOrthographicCamera::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PixelsPerUnit: " << this->PixelsPerUnit << "\n";
  os << indent << "PrincipalPoint: " << this->PrincipalPoint[0] << ", " << this->PrincipalPoint[1]
     << "\n";
}
