// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFogSpheres.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkRelievoFogSpheres);

//------------------------------------------------------------------------------
vtkRelievoFogSpheres::vtkRelievoFogSpheres()
{
  this->AddValue("radius", 1, "one length per point, in world units", 1.0);
  this->AddValue("density", 1, "one number per point", 1.0);
  this->AddValue("color", 3, "red, green and blue per point", 1.0);
}

//------------------------------------------------------------------------------
vtkRelievoFogSpheres::~vtkRelievoFogSpheres() = default;

//------------------------------------------------------------------------------
void vtkRelievoFogSpheres::SetRadius(double radius)
{
  this->SetForAll(0, &radius);
}

//------------------------------------------------------------------------------
void vtkRelievoFogSpheres::SetDensity(double density)
{
  this->SetForAll(1, &density);
}

//------------------------------------------------------------------------------
void vtkRelievoFogSpheres::SetColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  this->SetForAll(2, color);
}

//------------------------------------------------------------------------------
void vtkRelievoFogSpheres::GetColor(double color[3]) const
{
  std::copy_n(this->GetForAll(2), 3, color);
}

//------------------------------------------------------------------------------
bool vtkRelievoFogSpheres::HasEffect(const double* row) const
{
  return row[3] > 0.0 && row[4] > 0.0;
}
