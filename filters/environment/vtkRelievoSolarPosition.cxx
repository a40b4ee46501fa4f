// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSolarPosition.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRelievoSolarPosition);

namespace
{
constexpr double Degree = 3.14159265358979323846 / 180.0;

double Wrap(double degrees)
{
  const double rest = std::fmod(degrees, 360.0);
  return rest < 0.0 ? rest + 360.0 : rest;
}

// Wraps degrees to [-180, 180).
double WrapSigned(double degrees)
{
  return Wrap(degrees + 180.0) - 180.0;
}

// The sun's position among the stars, in degrees.
struct Sun
{
  double MeanLongitude;
  double Longitude; // apparent
  double Obliquity; // apparent
  double RightAscension;
  double Declination;
  double Nutation; // in right ascension
};

// Days from 2000-01-01 12:00.
Sun LocateSun(double days)
{
  const double t = days / 36525.0;
  Sun sun;
  sun.MeanLongitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
  const double anomaly = Degree * (357.52911 + t * (35999.05029 - t * 0.0001537));
  const double center = (1.914602 - t * (0.004817 + t * 0.000014)) * std::sin(anomaly) +
    (0.019993 - t * 0.000101) * std::sin(2.0 * anomaly) + 0.000289 * std::sin(3.0 * anomaly);
  const double node = Degree * (125.04 - 1934.136 * t);
  sun.Longitude = Wrap(sun.MeanLongitude + center - 0.00569 - 0.00478 * std::sin(node));
  sun.Obliquity = 23.0 + 26.0 / 60.0 +
    (21.448 - t * (46.8150 + t * (0.00059 - t * 0.001813))) / 3600.0 + 0.00256 * std::cos(node);
  const double longitude = Degree * sun.Longitude;
  const double obliquity = Degree * sun.Obliquity;
  sun.RightAscension =
    Wrap(std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude)) / Degree);
  sun.Declination = std::asin(std::sin(obliquity) * std::sin(longitude)) / Degree;
  sun.Nutation = -0.00478 * std::sin(node) * std::cos(obliquity);
  return sun;
}

double GetSiderealTime(double days, const Sun& sun)
{
  const double t = days / 36525.0;
  return 280.46061837 + 360.98564736629 * days + t * t * (0.000387933 - t / 38710000.0) +
    sun.Nutation;
}
}

//------------------------------------------------------------------------------
double vtkRelievoSolarPosition::GetDays(double hour)
{
  // Meeus, chapter 7; a year begins in March.
  const int year = this->Date[1] > 2 ? this->Date[0] : this->Date[0] - 1;
  const int month = this->Date[1] > 2 ? this->Date[1] : this->Date[1] + 12;
  const double century = std::floor(year / 100.0);
  const double julian = std::floor(365.25 * (year + 4716)) + std::floor(30.6001 * (month + 1)) +
    this->Date[2] + 2.0 - century + std::floor(century / 4.0) - 1524.5;
  return julian - 2451545.0 + (hour - this->TimeZone) / 24.0;
}

//------------------------------------------------------------------------------
void vtkRelievoSolarPosition::GetDirection(double direction[3])
{
  const double days = this->GetDays(this->Hour);
  const Sun sun = LocateSun(days);
  const double angle = Degree * (GetSiderealTime(days, sun) + this->Longitude - sun.RightAscension);
  const double high = Degree * sun.Declination;
  const double place = Degree * this->Latitude;
  direction[0] = -std::cos(high) * std::sin(angle);
  direction[1] =
    std::sin(high) * std::cos(place) - std::cos(high) * std::sin(place) * std::cos(angle);
  direction[2] =
    std::sin(high) * std::sin(place) + std::cos(high) * std::cos(place) * std::cos(angle);
}

//------------------------------------------------------------------------------
bool vtkRelievoSolarPosition::IsDay(int year, int month, int day)
{
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  const int days[12] = { 31, leap ? 29 : 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31 };
  return month >= 1 && month <= 12 && day >= 1 && day <= days[month - 1];
}

//------------------------------------------------------------------------------
double vtkRelievoSolarPosition::GetAzimuth()
{
  double direction[3];
  this->GetDirection(direction);
  return Wrap(std::atan2(direction[0], direction[1]) / Degree);
}

//------------------------------------------------------------------------------
double vtkRelievoSolarPosition::GetElevation()
{
  double direction[3];
  this->GetDirection(direction);
  return std::atan2(direction[2], std::hypot(direction[0], direction[1])) / Degree;
}

//------------------------------------------------------------------------------
double vtkRelievoSolarPosition::GetEclipticLongitude()
{
  return LocateSun(this->GetDays(this->Hour)).Longitude;
}

//------------------------------------------------------------------------------
double vtkRelievoSolarPosition::GetDeclination()
{
  return LocateSun(this->GetDays(this->Hour)).Declination;
}

//------------------------------------------------------------------------------
double vtkRelievoSolarPosition::GetEquationOfTime()
{
  // Meeus, chapter 28; four minutes a degree.
  const Sun sun = LocateSun(this->GetDays(this->Hour));
  return 4.0 * WrapSigned(sun.MeanLongitude - 0.0057183 - sun.RightAscension + sun.Nutation);
}

//------------------------------------------------------------------------------
double vtkRelievoSolarPosition::GetNoon()
{
  double noon = 12.0;
  for (int i = 0; i < 3; ++i) // the equation of time depends on the hour sought
  {
    const double days = this->GetDays(noon);
    const Sun sun = LocateSun(days);
    noon -= WrapSigned(GetSiderealTime(days, sun) + this->Longitude - sun.RightAscension) / 15.0;
  }
  return noon;
}

//------------------------------------------------------------------------------
double vtkRelievoSolarPosition::GetDayLength()
{
  const double high = Degree * LocateSun(this->GetDays(this->GetNoon())).Declination;
  const double cosine = -std::tan(Degree * this->Latitude) * std::tan(high);
  return 24.0 / 180.0 * std::acos(std::min(1.0, std::max(-1.0, cosine))) / Degree;
}

//------------------------------------------------------------------------------
void vtkRelievoSolarPosition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Date: " << this->Date[0] << " " << this->Date[1] << " " << this->Date[2] << "\n";
  os << indent << "Hour: " << this->Hour << "\n";
  os << indent << "TimeZone: " << this->TimeZone << "\n";
  os << indent << "Latitude: " << this->Latitude << "\n";
  os << indent << "Longitude: " << this->Longitude << "\n";
}
