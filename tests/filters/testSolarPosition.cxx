// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The position of the sun compared with published examples and tables: to the documented 0.01
// degrees, and effects left out.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoSolarPosition.h"

#include <vtkNew.h>

#include <cmath>
#include <iostream>
#include <string>

namespace testSolarPosition
{
namespace
{
constexpr double Degree = 3.14159265358979323846 / 180.0;
constexpr double Promised = 0.01; // degrees
constexpr double Minute = 1.0 / 60.0;

void CheckNear(double found, double truth, double tolerance, const std::string& what)
{
  const double error = std::remainder(found - truth, 360.0);
  std::cout << what << ": " << found << ", published " << truth << "\n";
  RELIEVO_CHECK(std::abs(error) <= tolerance);
}

// J. Meeus, Astronomical Algorithms, 2nd edition, examples 25.a, 25.b and 28.a: 1992 October 13, 0h
// dynamical time.
void TestMeeus()
{
  vtkNew<vtkRelievoSolarPosition> sun;
  sun->SetDate(1992, 10, 13);
  sun->SetHour(0.0);
  CheckNear(sun->GetEclipticLongitude(), 199.90895, 1e-5, "Meeus 25.a, apparent longitude");
  CheckNear(sun->GetDeclination(), -7.78507, 1e-5, "Meeus 25.a, declination");
  CheckNear(sun->GetEquationOfTime(), 13.0 + 42.6 * Minute, 4.0 * Promised, "Meeus 28.a");
  // Example 25.b, of the higher accuracy: the error of the lower one.
  CheckNear(
    sun->GetEclipticLongitude(), 199.0 + (54.0 + 21.818 * Minute) * Minute, Promised, "25.b");
  CheckNear(sun->GetDeclination(), -(7.0 + (47.0 + 1.74 * Minute) * Minute), Promised, "25.b");
}

// I. Reda and A. Andreas, Solar Position Algorithm for Solar Radiation Applications, NREL
// TP-560-34302, table A5.1: 17 October 2003, 12:30:30, seven hours behind UT.
void TestSPA()
{
  vtkNew<vtkRelievoSolarPosition> sun;
  sun->SetDate(2003, 10, 17);
  sun->SetHour(12.0 + (30.0 + 30.0 * Minute) * Minute);
  sun->SetTimeZone(-7.0);
  sun->SetLatitude(39.742476);
  sun->SetLongitude(-105.1786);
  CheckNear(sun->GetAzimuth(), 194.34024, Promised, "SPA, azimuth");
  CheckNear(sun->GetDeclination(), -9.31434, Promised, "SPA, declination");
  CheckNear(sun->GetEclipticLongitude(), 204.0085519281, Promised, "SPA, longitude");
  // The example's zenith angle holds refraction, of its equation 42 at 820 mbar and 11 degrees.
  double elevation = 90.0 - 50.11162;
  double geometric = elevation;
  for (int i = 0; i < 5; ++i)
  {
    geometric = elevation -
      (820.0 / 1010.0) * (283.0 / 284.0) * 1.02 /
        (60.0 * std::tan(Degree * (geometric + 10.3 / (geometric + 5.11))));
  }
  CheckNear(sun->GetElevation(), geometric, Promised, "SPA, elevation without refraction");
}

// Equinoxes and solstices as the Astronomical Almanac has them, to the minute of UT.
void TestSeasons()
{
  const struct
  {
    int Year, Month, Day, Hour, Minutes;
    double Longitude;
  } seasons[] = { { 2000, 3, 20, 7, 35, 0.0 }, { 2000, 6, 21, 1, 48, 90.0 },
    { 2000, 9, 22, 17, 28, 180.0 }, { 2000, 12, 21, 13, 37, 270.0 }, { 2026, 3, 20, 14, 46, 0.0 },
    { 2026, 6, 21, 8, 24, 90.0 }, { 2026, 9, 23, 0, 5, 180.0 }, { 2026, 12, 21, 20, 50, 270.0 } };
  vtkNew<vtkRelievoSolarPosition> sun;
  for (const auto& season : seasons)
  {
    sun->SetDate(season.Year, season.Month, season.Day);
    sun->SetHour(season.Hour + season.Minutes * Minute);
    CheckNear(sun->GetEclipticLongitude(), season.Longitude, Promised,
      std::to_string(season.Year) + "-" + std::to_string(season.Month));
    // The obliquity of the ecliptic is 23.44 degrees in these years.
    CheckNear(
      sun->GetDeclination(), 23.44 * std::sin(Degree * season.Longitude), Promised, "declination");
  }
}

// The equation of time's extremes and zeros, as almanacs print them, to half a minute and a day.
void TestEquationOfTime()
{
  const struct
  {
    int Month, Day;
    double Minutes;
  } table[] = { { 2, 11, -14.23 }, { 4, 15, 0.0 }, { 5, 14, 3.66 }, { 6, 13, 0.0 },
    { 7, 26, -6.53 }, { 9, 1, 0.0 }, { 11, 3, 16.43 }, { 12, 25, 0.0 } };
  vtkNew<vtkRelievoSolarPosition> sun;
  for (const auto& row : table)
  {
    sun->SetDate(2025, row.Month, row.Day);
    CheckNear(sun->GetEquationOfTime(), row.Minutes, 0.4, "equation of time");
    CheckNear(sun->GetNoon(), 12.0 - row.Minutes * Minute, 0.4 * Minute, "noon in Greenwich");
  }
}

// Consequences of the definitions: culmination, day and night, poles, zones, dates that roll over.
void TestGeometry()
{
  vtkNew<vtkRelievoSolarPosition> sun;
  sun->SetDate(2026, 3, 20);
  for (const double latitude : { -60.0, -20.0, 30.0, 65.0 })
  {
    sun->SetLatitude(latitude);
    sun->SetLongitude(33.0);
    sun->SetTimeZone(3.0);
    sun->SetHour(sun->GetNoon());
    RELIEVO_CHECK(
      std::abs(std::remainder(sun->GetAzimuth() - (latitude > 0 ? 180. : 0.), 360.)) < 1e-6);
    CheckNear(
      sun->GetElevation(), 90.0 - std::abs(latitude - sun->GetDeclination()), 1e-9, "culmination");
    // The sun rises and sets according to the length of the day, except for its movement in
    // between.
    const double half = sun->GetDayLength() / 2.0;
    const double noon = sun->GetHour();
    RELIEVO_CHECK(std::abs(half - 6.0) < 0.02); // the equinox
    sun->SetHour(noon - half);
    CheckNear(sun->GetElevation(), 0.0, 0.12, "sunrise");
    RELIEVO_CHECK(sun->GetAzimuth() > 85.0 && sun->GetAzimuth() < 95.0);
    sun->SetHour(noon - half - 1.0);
    RELIEVO_CHECK(sun->GetElevation() < -5.0);
  }
  // One moment by two clocks.
  const double azimuth = sun->GetAzimuth();
  sun->SetTimeZone(-5.5);
  sun->SetHour(sun->GetHour() - 8.5);
  CheckNear(sun->GetAzimuth(), azimuth, 1e-7, "another time zone");
  sun->SetDate(2026, 3, 19);
  sun->SetHour(sun->GetHour() + 24.0);
  CheckNear(sun->GetAzimuth(), azimuth, 1e-7, "the day before, 24 hours later");
  sun->SetHour(12.0);
  sun->SetDate(2026, 2, 30);
  const double rolled = sun->GetDeclination();
  sun->SetDate(2026, 3, 2);
  RELIEVO_CHECK(sun->GetDeclination() == rolled);
  sun->SetDate(2026, 6, 21);
  sun->SetLatitude(90.0);
  CheckNear(sun->GetElevation(), sun->GetDeclination(), 1e-9, "at the pole");
  RELIEVO_CHECK(sun->GetDayLength() == 24.0);
  sun->SetLatitude(-90.0);
  RELIEVO_CHECK(sun->GetDayLength() == 0.0);
}
}

RELIEVO_TEST_CASE(testSolarPosition)
{
  relievoTest::Session session;
  std::cout.precision(10);
  TestMeeus();
  TestSPA();
  TestSeasons();
  TestEquationOfTime();
  TestGeometry();
  return session.Result();
}
}
