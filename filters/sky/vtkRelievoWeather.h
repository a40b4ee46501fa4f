// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sunlight as measured, in equal intervals: of a typical year, from an EPW file, or of given days,
// from arrays.
#ifndef vtkRelievoWeather_h
#define vtkRelievoWeather_h

#include "vtkRelievoFiltersModule.h" // for the export macro

#include <cstddef>
#include <string>
#include <vector>

class vtkTable;

class VTKRELIEVOFILTERS_EXPORT vtkRelievoWeather
{
public:
  // Reads the hours of a weather file of EnergyPlus (EPW). Returns an error, or "".
  std::string Read(const std::string& file);

  // Takes the columns `dhi` (diffuse, on level ground), and `dni` (direct, on a plane that faces
  // the sun) or `ghi` (both, on level ground), in W/m2: a whole number of rows for each day.
  // Returns an error, or "".
  std::string Take(vtkTable* table, long days);

  bool IsEmpty() const { return this->Diffuse.empty(); }

  // Hours of an interval, and the intervals of a day.
  double GetPeriod() const { return 24.0 / this->PerDay; }
  int GetPerDay() const { return this->PerDay; }

  // Of a file: hours ahead of UTC.
  bool HasTimeZone() const { return this->OfYear; }
  double GetTimeZone() const { return this->TimeZone; }

  // The index of an interval of a day, which has a number from 0 on and a date.
  std::size_t GetIndex(long day, const int date[3], int interval) const;

  // Whether the sun's part is on level ground, not on a plane that faces the sun.
  bool IsLevel() const { return this->Level; }

  std::vector<double> Direct;
  std::vector<double> Diffuse;

private:
  int PerDay = 24;
  bool OfYear = false;
  bool Level = false;
  double TimeZone = 0.0;
};

#endif
