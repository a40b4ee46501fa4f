// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sun.h"

#include "Settings.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRelievoSolarPosition.h"

#include <cmath>

namespace viewer
{
namespace
{
// Exact at quarters of a turn, so that the words are short there.
void SineCosine(double degrees, double& sine, double& cosine)
{
  sine = std::sin(vtkMath::RadiansFromDegrees(degrees));
  cosine = std::cos(vtkMath::RadiansFromDegrees(degrees));
  for (double* value : { &sine, &cosine })
  {
    *value = std::abs(*value) < 1e-15 ? 0.0 : *value;
  }
}
}

//------------------------------------------------------------------------------
SunAngles GetSunAngles(const SunTime& time)
{
  vtkNew<vtkRelievoSolarPosition> sun;
  sun->SetDate(time.Year, time.Month, time.Day);
  sun->SetHour(time.Hour);
  sun->SetTimeZone(time.TimeZone);
  sun->SetLatitude(time.Latitude);
  sun->SetLongitude(time.Longitude);
  return { sun->GetAzimuth(), sun->GetElevation() };
}

//------------------------------------------------------------------------------
std::array<double, 3> GetSunDirection(const SunAngles& angles, int upAxis)
{
  double sine, cosine, up, along;
  SineCosine(angles.Azimuth, sine, cosine);
  SineCosine(angles.Elevation, up, along);
  const double east = along * sine;
  const double north = along * cosine;
  return upAxis == 0 ? std::array<double, 3>{ up, east, north }
    : upAxis == 1    ? std::array<double, 3>{ east, up, 0.0 - north }
                     : std::array<double, 3>{ east, north, up };
}

//------------------------------------------------------------------------------
SunAngles GetSunAngles(const std::array<double, 3>& d, int upAxis)
{
  const double east = upAxis == 0 ? d[1] : d[0];
  const double north = upAxis == 0 ? d[2] : upAxis == 1 ? -d[2] : d[1];
  const double up = d[upAxis];
  const double azimuth = vtkMath::DegreesFromRadians(std::atan2(east, north));
  return { azimuth < 0.0 ? azimuth + 360.0 : azimuth,
    vtkMath::DegreesFromRadians(std::atan2(up, std::hypot(east, north))) };
}

//------------------------------------------------------------------------------
std::string WriteSun(const std::array<double, 3>& direction)
{
  return "sun:" + scene::WriteNumbers({ direction.begin(), direction.end() });
}

//------------------------------------------------------------------------------
bool IsSun(const std::string& light)
{
  return light.rfind("sun:", 0) == 0;
}
}
