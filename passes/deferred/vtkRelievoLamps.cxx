// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLamps.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoParameter.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkRelievoLamps);

//------------------------------------------------------------------------------
vtkRelievoLamps::vtkRelievoLamps()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double white[3] = { 1.0, 1.0, 1.0 };
  this->SetThings("lamps",
    "places must be finite, radii above 0, intensities other than 0, colours not negative");
  this->AddValue(
    "radius", 1.0, 0.0, infinity, "world units", "Radius within which the lamps shine.");
  this
    ->AddValue("intensity", 1.0, -infinity, infinity, "",
      "Brightness of the lamps; a negative intensity removes light.")
    .Usual = 5.0;
  this->AddColorValue("color", white, "Linear colour of the light.");
  this->AddChoiceValue("casts", { "if-large", "never", "always" }, CASTS_IF_LARGE, CASTS_IF_LARGE,
    "Whether the lamps cast shadows, or shine through walls; if-large: only among the largest, as "
    "many as the stage's casting. At most eight cast. Array values: -1 if-large, 0 never, 1 "
    "always.");
  this->Description.AddChoice(
    "falloff", this->Falloff, [this](int falloff) { this->SetFalloff(falloff); },
    { "linear", "inverse-square", "vtk" },
    "Fall-off of light at distance d from a lamp of radius r: linear, 1 - d / r; "
    "inverse-square, 1 / d^2, brought to 0 at r; vtk, 1 / (A + B d + C d^2), nothing beyond r.");
  this->Description
    .AddVector(
      "attenuation", this->AttenuationValues,
      [this](const double* values) { this->SetAttenuationValues(values[0], values[1], values[2]); },
      "A, B and C of the fall-off vtk.")
    .OnlyIf = "falloff=vtk";
}

//------------------------------------------------------------------------------
vtkRelievoLamps::~vtkRelievoLamps() = default;

//------------------------------------------------------------------------------
void vtkRelievoLamps::SetRadius(double radius)
{
  this->SetForAll(0, &radius);
}

//------------------------------------------------------------------------------
void vtkRelievoLamps::SetIntensity(double intensity)
{
  this->SetForAll(1, &intensity);
}

//------------------------------------------------------------------------------
void vtkRelievoLamps::SetColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  this->SetForAll(2, color);
}

//------------------------------------------------------------------------------
void vtkRelievoLamps::GetColor(double color[3]) const
{
  std::copy_n(this->GetForAll(2), 3, color);
}

//------------------------------------------------------------------------------
void vtkRelievoLamps::SetCasts(int casts)
{
  const double value = std::clamp<int>(casts, CASTS_IF_LARGE, CASTS_ALWAYS);
  this->SetForAll(3, &value);
}

//------------------------------------------------------------------------------
int vtkRelievoLamps::GetCasts() const
{
  return static_cast<int>(this->GetForAll(3)[0]);
}

//------------------------------------------------------------------------------
bool vtkRelievoLamps::GetSomeCastAlways()
{
  if (this->LookedAt != this->GetRowsTime())
  {
    this->LookedAt = this->GetRowsTime();
    this->SomeCastAlways = false;
    const std::vector<double>& rows = this->GetRows();
    for (std::size_t i = 0; i < rows.size(); i += static_cast<std::size_t>(this->GetRowWidth()))
    {
      this->SomeCastAlways = this->SomeCastAlways || GetCastsOf(&rows[i]) > 0.0;
    }
  }
  return this->SomeCastAlways;
}

//------------------------------------------------------------------------------
bool vtkRelievoLamps::HasEffect(const double* row) const
{
  return row[3] > 0.0 && row[4] != 0.0 && (row[5] != 0.0 || row[6] != 0.0 || row[7] != 0.0);
}

//------------------------------------------------------------------------------
void vtkRelievoLamps::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Falloff: " << this->Falloff << "\n";
  os << indent << "AttenuationValues: " << this->AttenuationValues[0] << " "
     << this->AttenuationValues[1] << " " << this->AttenuationValues[2] << "\n";
}
