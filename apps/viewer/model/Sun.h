// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The sun of the scene: from angles, or from the place and the clock, to the words of --light.
 */
#ifndef Sun_h
#define Sun_h

#include <array>
#include <string>

namespace viewer
{
struct SunAngles
{
  double Azimuth;   ///< degrees from north, clockwise seen from above
  double Elevation; ///< degrees above the horizon
};

struct SunTime
{
  int Year = 2026, Month = 6, Day = 21;
  double Hour = 15.0;    ///< of the clock
  double TimeZone = 0.0; ///< hours that the clock is ahead of UTC
  double Latitude = 48.0, Longitude = 0.0;
};

/// By vtkRelievoSolarPosition.
SunAngles GetSunAngles(const SunTime& time);

/// Towards the sun. North is z, -z or y where x, y or z points up.
std::array<double, 3> GetSunDirection(const SunAngles& angles, int upAxis);
SunAngles GetSunAngles(const std::array<double, 3>& direction, int upAxis);

///@{
/// The value of --light, and whether it is that of a sun.
std::string WriteSun(const std::array<double, 3>& direction);
bool IsSun(const std::string& light);
///@}
}

#endif
