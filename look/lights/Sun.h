// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Position of the sun: by angles, or by date, time and place.
 */
#ifndef Sun_h
#define Sun_h

#include "LookNames.h"

#include <array>
#include <string>

namespace look
{
struct SunAngles
{
  double Azimuth;   ///< degrees from north, clockwise seen from above
  double Elevation; ///< degrees above the horizon

  /// Whether the sun is below the horizon.
  bool IsNight() const { return this->Elevation <= 0.0; }
};

struct SunTime
{
  int Year = 2026, Month = 6, Day = 21;
  double Hour = 15.0;    ///< clock time
  double TimeZone = 0.0; ///< offset of the clock from UTC, hours
  double Latitude = 48.0, Longitude = 0.0;
};

/// Computed by vtkRelievoSolarPosition.
SunAngles GetSunAngles(const SunTime& time);

/// The direction towards the sun. North is z, -z or y where x, y or z points up.
std::array<double, 3> GetSunDirection(const SunAngles& angles, int upAxis);
SunAngles GetSunAngles(const std::array<double, 3>& direction, int upAxis);

///@{
/// "2026-06-21T15:30+02:00,LATITUDE,LONGITUDE": ISO 8601 with minutes or seconds; UTC without an
/// offset. IsSunTime is false for plain numbers. ParseSunTime throws UsageError for invalid words.
bool IsSunTime(const std::string& numbers);
SunTime ParseSunTime(const std::string& option, const std::string& numbers);
std::string WriteSunTime(const SunTime& time);
///@}
}

#endif
