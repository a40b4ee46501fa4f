// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoSolarPosition
 * @brief The position of the sun by date, time and place.
 *
 * The low-accuracy formulas of J. Meeus, Astronomical Algorithms, 2nd edition 1998, chapters 12
 * (sidereal time), 13 (horizontal coordinates) and 25 (the sun): to within 0.01 degrees from 1900
 * to 2100, for the centre of the sun. Refraction, which lifts it by 0.6 degrees at the horizon and
 * 0.02 at an elevation of 45, and the difference between dynamical and universal time (0.0008
 * degrees) are left out.
 */
#ifndef vtkRelievoSolarPosition_h
#define vtkRelievoSolarPosition_h

#include "vtkObject.h"
#include "vtkRelievoFiltersModule.h" // for the export macro

class VTKRELIEVOFILTERS_EXPORT vtkRelievoSolarPosition : public vtkObject
{
public:
  static vtkRelievoSolarPosition* New();
  vtkTypeMacro(vtkRelievoSolarPosition, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Year, month (1 to 12) and day (from 1) of the Gregorian calendar. Days beyond the end of the
   * month continue into the next: 30 February is 1 or 2 March. Default 2026, 6, 21.
   */
  vtkSetVector3Macro(Date, int);
  vtkGetVector3Macro(Date, int);
  ///@}

  ///@{
  /**
   * Clock time in hours: 15.5 is half past three in the afternoon. Values below 0 and above 24 fall
   * on adjacent days. Default 12.
   */
  vtkSetMacro(Hour, double);
  vtkGetMacro(Hour, double);
  ///@}

  ///@{
  /** Hours by which the clock is ahead of universal time (UTC), summer time included. Default 0. */
  vtkSetMacro(TimeZone, double);
  vtkGetMacro(TimeZone, double);
  ///@}

  ///@{
  /** Degrees; north is positive, -90 to 90. Default 48. */
  vtkSetClampMacro(Latitude, double, -90.0, 90.0);
  vtkGetMacro(Latitude, double);
  ///@}

  ///@{
  /** Degrees; east is positive. Default 0. */
  vtkSetMacro(Longitude, double);
  vtkGetMacro(Longitude, double);
  ///@}

  /** Whether the Gregorian calendar has this day. */
  static bool IsDay(int year, int month, int day);

  /** Degrees from north, clockwise seen from above, 0 to 360: 90 is east, 180 south. */
  double GetAzimuth();

  /** Degrees above the horizon, -90 to 90; below 0 it is night. */
  double GetElevation();

  /** The unit vector towards the sun: east, north, up. */
  void GetDirection(double direction[3]);

  ///@{
  /** Degrees: the sun's apparent longitude in the ecliptic, 0 to 360, and declination. */
  double GetEclipticLongitude();
  double GetDeclination();
  ///@}

  /** Minutes by which a sundial is ahead of mean time: -14 in February, 16 in November. */
  double GetEquationOfTime();

  /**
   * The clock time, in hours, at which the sun is highest. SetHour(GetNoon() + h - 12) sets true
   * solar time h.
   */
  double GetNoon();

  /** Hours during which the sun's centre is above a flat horizon on the date, 0 to 24. */
  double GetDayLength();

protected:
  vtkRelievoSolarPosition() = default;
  ~vtkRelievoSolarPosition() override = default;

  int Date[3] = { 2026, 6, 21 };
  double Hour = 12.0;
  double TimeZone = 0.0;
  double Latitude = 48.0;
  double Longitude = 0.0;

private:
  vtkRelievoSolarPosition(const vtkRelievoSolarPosition&) = delete;
  void operator=(const vtkRelievoSolarPosition&) = delete;

  double GetDays(double hour);
};

#endif
