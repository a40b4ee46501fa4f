// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoFogSpheres.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoParameter.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkRelievoFogSpheres);

//------------------------------------------------------------------------------
vtkRelievoFogSpheres::vtkRelievoFogSpheres()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double white[3] = { 1.0, 1.0, 1.0 };
  this->SetThings(
    "fog", "places must be finite, radii and densities above 0, colours not negative");
  this->AddValue("radius", 1.0, 0.0, infinity, "world units", "Radius of the spheres.");
  this
    ->AddValue("density", 1.0, 0.0, infinity, "per world unit",
      "Mode beer: absorption per world unit (63 % of the light over a length of 1 / density); mode "
      "chord: the share of light absorbed through a sphere's centre, 0 to 1.")
    .Usual = 5.0;
  this->AddColorValue("color", white, "Linear colour of the fog.");
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
  return row[RADIUS] > 0.0 && row[DENSITY] > 0.0;
}
