// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sun.h"

#include "Numbers.h"
#include "Values.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRelievoSolarPosition.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <vector>

namespace look
{
namespace
{
// Exact at quarter turns, to keep written directions short.
void SineCosine(double degrees, double& sine, double& cosine)
{
  sine = std::sin(vtkMath::RadiansFromDegrees(degrees));
  cosine = std::cos(vtkMath::RadiansFromDegrees(degrees));
  for (double* value : { &sine, &cosine })
  {
    *value = std::abs(*value) < 1e-15 ? 0.0 : *value;
  }
}

std::string Digits(long number, std::size_t count)
{
  const std::string digits = std::to_string(number);
  return std::string(count - std::min(count, digits.size()), '0') + digits;
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
bool IsSunTime(const std::string& numbers)
{
  return numbers.find('T') != std::string::npos;
}

//------------------------------------------------------------------------------
SunTime ParseSunTime(const std::string& option, const std::string& numbers)
{
  static const std::regex form("([0-9]{4})-([0-9]{2})-([0-9]{2})T([0-9]{2}):([0-9]{2})"
                               "(:([0-9]{2}))?(Z|([+-])([0-9]{2}):([0-9]{2}))?");
  const std::size_t comma = numbers.find(',');
  const std::string clock = numbers.substr(0, comma);
  std::smatch parts;
  if (comma == std::string::npos || !std::regex_match(clock, parts, form))
  {
    RefuseValue(option, numbers,
      "a date and time, latitude and longitude, such as 2026-06-21T15:30+02:00,48.1,11.6");
  }
  const auto get = [&parts](int part) {
    return parts[part].length() > 0 ? std::stoi(parts[part].str()) : 0;
  };
  SunTime time;
  time.Year = get(1);
  time.Month = get(2);
  time.Day = get(3);
  time.Hour = get(4) + get(5) / 60.0 + get(7) / 3600.0;
  time.TimeZone = (get(10) + get(11) / 60.0) * (parts[9].str() == "-" ? -1.0 : 1.0);
  if (!vtkRelievoSolarPosition::IsDay(time.Year, time.Month, time.Day))
  {
    RefuseValue(option, numbers, "a day of the calendar");
  }
  if (time.Hour > 24.0 || get(5) > 59 || get(7) > 59)
  {
    RefuseValue(option, numbers, "a time from 00:00 to 24:00");
  }
  if (time.TimeZone < -12.0 || time.TimeZone > 14.0 || get(11) > 59)
  {
    RefuseValue(option, numbers, "an offset from -12:00 to +14:00");
  }
  const std::vector<double> place =
    ParseNumbers(option, numbers.substr(comma + 1), 2, "LATITUDE,LONGITUDE");
  if (std::abs(place[0]) > 90.0 || std::abs(place[1]) > 180.0)
  {
    RefuseValue(option, numbers, "a latitude from -90 to 90 and a longitude from -180 to 180");
  }
  time.Latitude = place[0];
  time.Longitude = place[1];
  return time;
}

//------------------------------------------------------------------------------
std::string WriteSunTime(const SunTime& time)
{
  const long seconds = std::lround(3600.0 * time.Hour);
  const long minutes = std::lround(60.0 * std::abs(time.TimeZone));
  std::string clock = Digits(time.Year, 4) + "-" + Digits(time.Month, 2) + "-" +
    Digits(time.Day, 2) + "T" + Digits(seconds / 3600, 2) + ":" + Digits(seconds / 60 % 60, 2);
  clock += seconds % 60 ? ":" + Digits(seconds % 60, 2) : "";
  clock += minutes == 0
    ? "Z"
    : (time.TimeZone < 0.0 ? "-" : "+") + Digits(minutes / 60, 2) + ":" + Digits(minutes % 60, 2);
  return clock + "," + WriteNumbers({ time.Latitude, time.Longitude });
}
}
