// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLamps.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkRelievoLamps);

//------------------------------------------------------------------------------
vtkRelievoLamps::vtkRelievoLamps()
{
  this->AddValue("radius", 1, "one length per point, in world units", 1.0);
  this->AddValue("intensity", 1, "one number per point", 1.0);
  this->AddValue("color", 3, "red, green and blue per point", 1.0);
  this->AddValue("casts", 1, "-1, 0 or 1 per point", -1.0);
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
