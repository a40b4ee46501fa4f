// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoWeather.h"

#include "vtkDataArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>
#include <system_error>

namespace
{
constexpr int HoursOfDay = 24;
constexpr int DaysOfYear = 365;
constexpr int DaysBefore[] = { 0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334 };

std::vector<std::string> Split(const std::string& line)
{
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');)
  {
    fields.push_back(field);
  }
  return fields;
}

// A number, whatever the user's decimal point; NaN for other texts.
double ToNumber(const std::string& text)
{
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double number = 0.0;
  return in >> number && (in >> std::ws).eof() ? number : std::nan("");
}
}

//------------------------------------------------------------------------------
std::string vtkRelievoWeather::Read(const std::string& file)
{
  constexpr std::size_t timeZone = 8, direct = 14, diffuse = 15; // fields, from 0
  constexpr double missing = 9999.0;
  constexpr std::uintmax_t most = 64U << 20U; // forty times a year of hours
  std::error_code trouble;
  // Reading a pipe would block, and a device may not end.
  const bool isFile = std::filesystem::is_regular_file(file, trouble);
  if (isFile ? std::filesystem::file_size(file, trouble) > most
             : std::filesystem::exists(file, trouble))
  {
    return file + ": expected a file of at most 64 MiB, not a folder, a pipe or a device";
  }
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line))
  {
    return file + ": cannot be read, expected a weather file of EnergyPlus (EPW)";
  }
  const std::string mark = "\xEF\xBB\xBF"; // of UTF-8
  if (line.compare(0, mark.size(), mark) == 0)
  {
    line.erase(0, mark.size());
  }
  const std::vector<std::string> location = Split(line);
  const double zone = location.size() > timeZone ? ToNumber(location[timeZone]) : std::nan("");
  if (!(std::abs(zone) <= 14.0) || location[0] != "LOCATION")
  {
    return file +
      ": is not a weather file of EnergyPlus (EPW), whose first line is LOCATION with "
      "the time zone as its ninth field";
  }
  *this = vtkRelievoWeather();
  this->OfYear = true;
  this->TimeZone = zone;
  const std::size_t hours = HoursOfDay * DaysOfYear;
  this->Direct.assign(hours, std::nan(""));
  this->Diffuse.assign(hours, std::nan(""));
  for (int number = 2; std::getline(in, line); ++number)
  {
    const std::vector<std::string> fields = Split(line);
    if (fields.size() <= diffuse || std::isnan(ToNumber(fields[0])))
    {
      continue; // another line of the header
    }
    const double month = ToNumber(fields[1]);
    const double day = ToNumber(fields[2]);
    const double hour = ToNumber(fields[3]);
    const double sun = ToNumber(fields[direct]);
    const double sky = ToNumber(fields[diffuse]);
    if (month == 2.0 && day == 29.0)
    {
      continue; // 28 February stands for it
    }
    const bool isTime = month >= 1.0 && month <= 12.0 && day >= 1.0 && day <= 31.0 && hour >= 1.0 &&
      hour <= HoursOfDay;
    const std::size_t index = isTime
      ? static_cast<std::size_t>(
          (DaysBefore[static_cast<int>(month) - 1] + static_cast<int>(day) - 1) * HoursOfDay +
          static_cast<int>(hour) - 1)
      : hours;
    if (index >= hours || !(sun >= 0.0 && sun < missing && sky >= 0.0 && sky < missing))
    {
      return file + ": line " + std::to_string(number) +
        ": expected month, day, hour, and direct and diffuse radiation from 0 to 9998 Wh/m2";
    }
    if (!std::isnan(this->Diffuse[index]))
    {
      return file + ": line " + std::to_string(number) +
        ": has an hour again; expected one record for each hour of one year";
    }
    this->Direct[index] = sun;
    this->Diffuse[index] = sky;
  }
  for (std::size_t i = 0; i < hours; ++i)
  {
    if (std::isnan(this->Diffuse[i]))
    {
      const auto day = static_cast<int>(i / HoursOfDay);
      return file + ": has no hour " + std::to_string(i % HoursOfDay + 1) + " of day " +
        std::to_string(day + 1) + ", expected all hours of a year";
    }
  }
  return "";
}

//------------------------------------------------------------------------------
std::string vtkRelievoWeather::Take(vtkTable* table, long days)
{
  const auto get = [table](const char* name) {
    return vtkDataArray::SafeDownCast(table->GetColumnByName(name));
  };
  vtkDataArray* dni = get("dni");
  vtkDataArray* dhi = get("dhi");
  vtkDataArray* ghi = get("ghi");
  const vtkIdType rows = table->GetNumberOfRows();
  if (!dhi || (!dni && !ghi))
  {
    return "weather: expected the array dhi, and dni or ghi";
  }
  if (rows == 0 || rows % days != 0)
  {
    return "weather: got " + std::to_string(rows) + " values for " + std::to_string(days) +
      " days, expected as many for each day";
  }
  *this = vtkRelievoWeather();
  this->PerDay = static_cast<int>(rows / days);
  this->Level = !dni;
  for (vtkIdType i = 0; i < rows; ++i)
  {
    const double values[] = { (dni ? dni : ghi)->GetTuple1(i), dhi->GetTuple1(i) };
    for (const double value : values)
    {
      if (!(value >= 0.0 && std::isfinite(value)))
      {
        std::ostringstream text;
        text << "weather: got " << value << " W/m2 in row " << i << ", expected 0 or more";
        return text.str();
      }
    }
    this->Direct.push_back(dni ? values[0] : std::max(0.0, values[0] - values[1]));
    this->Diffuse.push_back(values[1]);
  }
  return "";
}

//------------------------------------------------------------------------------
std::size_t vtkRelievoWeather::GetIndex(long day, const int date[3], int interval) const
{
  if (this->OfYear)
  {
    const bool leap = date[1] == 2 && date[2] == 29;
    day = DaysBefore[date[1] - 1] + date[2] - (leap ? 2 : 1);
  }
  return static_cast<std::size_t>(day) * static_cast<std::size_t>(this->PerDay) +
    static_cast<std::size_t>(interval);
}
