// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoSunExposure.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRelievoAbort.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoSkyModel.h"
#include "vtkRelievoSkyPatches.h"
#include "vtkRelievoSkySamples.h"
#include "vtkRelievoSkyTurn.h"
#include "vtkRelievoSolarPosition.h"
#include "vtkRelievoSurfacePlaces.h"
#include "vtkRelievoThreads.h"
#include "vtkRelievoWeather.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <locale>
#include <sstream>

vtkStandardNewMacro(vtkRelievoSunExposure);

namespace
{
constexpr double HoursOfDay = 24.0;
constexpr int FirstYear = 1, LastYear = 9999;
constexpr int MostDays = 366 * 200;

using Vector = vtkRelievoSurfacePlaces::Vector;

// Days since 1970-01-01 in the Gregorian calendar, in whole cycles of 400 years from March on.
long CountDays(const int date[3])
{
  const long month = (date[1] + 9) % 12;
  const long year = date[0] - (date[1] < 3 ? 1 : 0);
  const long cycle = (year >= 0 ? year : year - 399) / 400;
  const long inCycle = year - 400 * cycle;
  const long day = (153 * month + 2) / 5 + date[2] - 1;
  return 146097 * cycle + 365 * inCycle + inCycle / 4 - inCycle / 100 + day - 719468;
}

// The date of so many days since 1970-01-01.
std::array<int, 3> GetDate(long days)
{
  const long shifted = days + 719468;
  const long cycle = (shifted >= 0 ? shifted : shifted - 146096) / 146097;
  const long inCycle = shifted - 146097 * cycle;
  const long year = (inCycle - inCycle / 1460 + inCycle / 36524 - inCycle / 146096) / 365;
  const long day = inCycle - (365 * year + year / 4 - year / 100);
  const long month = (5 * day + 2) / 153;
  return { static_cast<int>(year + 400 * cycle + (month < 10 ? 0 : 1)),
    static_cast<int>(month < 10 ? month + 3 : month - 9),
    static_cast<int>(day - (153 * month + 2) / 5 + 1) };
}

// The sun of a place by the clock, whose hours are counted from the first midnight.
class SunClock
{
public:
  SunClock(const int first[3], double latitude, double longitude, double timeZone)
  {
    this->Sun->SetLatitude(latitude);
    this->Sun->SetLongitude(longitude);
    this->Sun->SetTimeZone(timeZone);
    this->Sun->SetDate(first[0], first[1], first[2]);
  }

  // East, north, up.
  Vector GetDirection(double hour) const
  {
    Vector local;
    this->Sun->SetHour(hour);
    this->Sun->GetDirection(local.data());
    return local;
  }

  // The parts of an interval in which the sun is above a height, whose sine is given. In each half
  // of the interval it crosses the height at most once.
  std::vector<std::array<double, 2>> GetParts(double begin, double end, double sine) const
  {
    const auto isUp = [this, sine](double hour) { return this->GetDirection(hour)[2] > sine; };
    const auto findHorizon = [&isUp](double before, double after) {
      const bool rises = isUp(after);
      for (int i = 0; i < 32; ++i) // to a microsecond
      {
        const double middle = 0.5 * (before + after);
        (isUp(middle) == rises ? after : before) = middle;
      }
      return after;
    };
    std::vector<std::array<double, 2>> parts;
    const double times[] = { begin, 0.5 * (begin + end), end };
    for (int half = 0; half < 2; ++half)
    {
      const double from = times[half];
      const double to = times[half + 1];
      const bool up[2] = { isUp(from), isUp(to) };
      if (up[0] && !parts.empty())
      {
        parts.back()[1] = up[1] ? to : findHorizon(from, to);
      }
      else if (up[0] || up[1])
      {
        parts.push_back(
          { up[0] ? from : findHorizon(from, to), up[1] ? to : findHorizon(from, to) });
      }
    }
    return parts;
  }

private:
  vtkNew<vtkRelievoSolarPosition> Sun;
};

// East, north and up in the world, in columns.
glm::dmat3 GetWorld(int upAxis)
{
  return upAxis == 0 ? glm::dmat3(0, 1, 0, 0, 0, 1, 1, 0, 0)
    : upAxis == 1    ? glm::dmat3(1, 0, 0, 0, 0, -1, 0, 1, 0)
                     : glm::dmat3(1.0);
}

// Finds the positions with free sight in a direction: those that face it, by rays.
class Openings
{
public:
  Openings(vtkRelievoRayScene* scene, const vtkRelievoSurfacePlaces& places)
    : Scene(scene)
    , All(places)
  {
  }

  // For each position from which the direction (which may differ per position) is free, calls
  // `found` with the cosine to its normal.
  template <typename Direction, typename Found>
  bool Find(const Direction& direction, const Found& found)
  {
    this->Facing.clear();
    this->Origins->SetNumberOfComponents(3);
    this->Directions->SetNumberOfComponents(3);
    this->Origins->Reset();
    this->Directions->Reset();
    for (std::size_t i = 0; i < this->All.At.size(); ++i)
    {
      const Vector towards = direction(i);
      if (vtkMath::Dot(towards.data(), this->All.Normals[i].data()) > 0.0)
      {
        this->Facing.push_back(i);
        this->Origins->InsertNextTuple(this->All.At[i].data());
        this->Directions->InsertNextTuple(towards.data());
      }
    }
    if (this->Facing.empty())
    {
      return true;
    }
    if (!this->Scene->FindAny(this->Origins, this->Directions, this->Hit))
    {
      return false;
    }
    for (std::size_t k = 0; k < this->Facing.size(); ++k)
    {
      const auto ray = static_cast<vtkIdType>(k);
      if (this->Hit->GetValue(ray) == 0)
      {
        const std::size_t i = this->Facing[k];
        found(i, vtkMath::Dot(this->Directions->GetPointer(3 * ray), this->All.Normals[i].data()));
      }
    }
    return true;
  }

private:
  vtkRelievoRayScene* Scene;
  const vtkRelievoSurfacePlaces& All;
  std::vector<std::size_t> Facing;
  vtkNew<vtkDoubleArray> Origins;
  vtkNew<vtkDoubleArray> Directions;
  vtkNew<vtkUnsignedCharArray> Hit;
};

void AddArray(vtkFieldData* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::transform(values.begin(), values.end(), array->GetPointer(0),
    [](double value) { return static_cast<float>(value); });
  data->AddArray(array);
}
}

//------------------------------------------------------------------------------
vtkRelievoSunExposure::vtkRelievoSunExposure()
{
  vtkRelievoParameterList& list = this->Parameters;
  list.AddDate(
    "first_day", this->FirstDay, [this](const int* day) { this->SetFirstDay(day); }, FirstYear,
    LastYear, "The first day, from midnight of the clock.");
  list.AddDate(
    "last_day", this->LastDay, [this](const int* day) { this->SetLastDay(day); }, FirstYear,
    LastYear, "The last day, which counts as well.");
  list.AddNumber(
    "latitude", this->Latitude, [this](double degrees) { this->SetLatitude(degrees); }, -90.0, 90.0,
    "degrees", "North is positive.");
  list.AddNumber(
    "longitude", this->Longitude, [this](double degrees) { this->SetLongitude(degrees); }, -180.0,
    180.0, "degrees", "East is positive.");
  list.AddNumber(
    "step", this->Step, [this](double minutes) { this->SetStep(minutes); }, 0.1, 240.0, "minutes",
    "Time step between positions of the sun.");
  list.AddWhole(
    "day_step", this->DayStep, [this](int days) { this->SetDayStep(days); }, 1, 366, "days",
    "Only every so many days are computed, each counted as many times; 7 suffices for a year.");
  list.AddChoice(
    "up_axis", this->UpAxis, [this](int axis) { this->SetUpAxis(axis); }, { "x", "y", "z" },
    "The axis that points up; north is z, -z or y, respectively.");
  list
    .AddFlag(
      "points", this->Points, [this](bool on) { this->SetPoints(on); },
      "Evaluates points instead of cells.")
    .Label = "Of Points";
  list.AddWhole(
    "sky_samples", this->SkySamples, [this](int rays) { this->SetSkySamples(rays); }, 0, 65536, "",
    "Rays per place for the array sky_view, the visible share of the sky; 0: none.");
  list.AddNumber(
    "begin_hour", this->BeginHour, [this](double hour) { this->SetBeginHour(hour); }, 0.0, 24.0,
    "hours", "Only the light of the sun and the sky after this time of day counts.");
  list.AddNumber(
    "end_hour", this->EndHour, [this](double hour) { this->SetEndHour(hour); }, 0.0, 24.0, "hours",
    "Only the light of the sun and the sky before this time of day counts.");
  list.AddNumber(
    "minimum_elevation", this->MinimumElevation,
    [this](double degrees) { this->SetMinimumElevation(degrees); }, 0.0, 90.0, "degrees",
    "Times with a lower sun do not count, neither for its light nor for the light of the sky.");
  list.AddText(
    "time_zone", [this] { return this->TimeZone; },
    [this](const std::string& hours) { this->SetTimeZone(hours.c_str()); },
    "Hours by which the clock is ahead of UTC, -12 to 14; empty: with irradiance those of the "
    "weather file, otherwise local mean time.");
  list
    .AddNumber(
      "north", this->North, [this](double degrees) { this->SetNorth(degrees); }, -360.0, 360.0,
      "degrees", "Turns north, clockwise from above.")
    .Usual = 180.0;
  list.AddChoice(
    "irradiance", this->Irradiance, [this](int sky) { this->SetIrradiance(sky); },
    { "off", "isotropic", "perez" },
    "Model of the sky whose irradiation is computed, in kWh/m2: uniform, or that of Perez et al. "
    "(1990).");
  const auto lit = [](vtkRelievoParameter& parameter) { parameter.OnlyIf = "irradiance!=off"; };
  lit(list.AddNumber(
    "tolerance", this->Tolerance, [this](double percent) { this->SetTolerance(percent); }, 0.1,
    20.0, "percent",
    "Tolerable error of the irradiation; the sky is divided, down to 0.3 degrees, to reach it."));
  lit(list.AddNumber(
    "albedo", this->Albedo, [this](double share) { this->SetAlbedo(share); }, 0.0, 1.0, "",
    "Share of light that the ground reflects."));
  lit(list.AddNumber(
    "turbidity", this->Turbidity, [this](double turbidity) { this->SetTurbidity(turbidity); }, 1.0,
    10.0, "", "Turbidity of the clear sky by Linke: 2 in clear, 3 in usual, 5 in hazy air."));
  lit(list.AddNumber(
    "altitude", this->Altitude, [this](double metres) { this->SetAltitude(metres); }, -500.0,
    9000.0, "metres", "Height above the sea, for the clear sky."));
  lit(list.AddText(
    "weather_file", [this] { return this->WeatherFile; },
    [this](const std::string& file) { this->SetWeatherFile(file.c_str()); },
    "A weather file of EnergyPlus (EPW), whose hourly data replace the clear sky."));
}

//------------------------------------------------------------------------------
vtkRelievoSunExposure::~vtkRelievoSunExposure() = default;

//------------------------------------------------------------------------------
void vtkRelievoSunExposure::SetTimeZone(RELIEVO_TEXT hours)
{
  const std::string text = hours;
  if (text != this->TimeZone)
  {
    this->TimeZone = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSunExposure::SetWeatherFile(RELIEVO_TEXT file)
{
  const std::string text = file;
  if (text != this->WeatherFile)
  {
    this->WeatherFile = text;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoSunExposure::SetWeather(vtkTable* table)
{
  if (table != this->Weather)
  {
    this->Weather = table;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTable* vtkRelievoSunExposure::GetWeather()
{
  return this->Weather;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkRelievoSunExposure::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Weather ? std::max(own, this->Weather->GetMTime()) : own;
}

//------------------------------------------------------------------------------
std::string vtkRelievoSunExposure::CheckWeatherFile() const
{
  return this->WeatherFile.empty() ? "" : vtkRelievoWeather().Read(this->WeatherFile);
}

//------------------------------------------------------------------------------
std::string vtkRelievoSunExposure::CheckDays(const int first[3], const int last[3])
{
  for (const int* day : { first, last })
  {
    if (!vtkRelievoSolarPosition::IsDay(day[0], day[1], day[2]))
    {
      return "got the day " + std::to_string(day[0]) + "-" + std::to_string(day[1]) + "-" +
        std::to_string(day[2]) + ", expected year, month and day of the calendar";
    }
  }
  const long after = CountDays(last) - CountDays(first);
  return after >= 0 && after < MostDays ? ""
                                        : "got a last day " + std::to_string(after) +
      " days after the first, expected 0 to " + std::to_string(MostDays - 1);
}

//------------------------------------------------------------------------------
struct vtkRelievoSunExposure::Sun
{
  glm::dvec3 Local; // east, north, up of the turned north
  Vector Direction; // in the world
  double Hours;
  double Extraterrestrial;
  relievo::Sunlight Light;
};

//------------------------------------------------------------------------------
// The sun in the middle of each step by day, or of the part of a step in which the sun is up.
// Returns an error, or "".
std::string vtkRelievoSunExposure::GetSuns(std::vector<Sun>& suns) const
{
  const std::string message = CheckDays(this->FirstDay, this->LastDay);
  if (!message.empty())
  {
    return message;
  }
  std::ostringstream text;
  if (!(this->BeginHour < this->EndHour))
  {
    text << "got the hours " << this->BeginHour << " to " << this->EndHour
         << ", expected an end after the beginning";
    return text.str();
  }
  const long firstDay = CountDays(this->FirstDay);
  const long days = CountDays(this->LastDay) - firstDay + 1;
  vtkRelievoWeather weather;
  if (this->Irradiance != 0)
  {
    const std::string error = this->Weather ? weather.Take(this->Weather, days)
      : this->WeatherFile.empty()           ? ""
                                            : weather.Read(this->WeatherFile);
    if (!error.empty())
    {
      return error;
    }
  }
  double timeZone = weather.HasTimeZone() ? weather.GetTimeZone() : this->Longitude / 15.0;
  if (!this->TimeZone.empty())
  {
    std::istringstream in(this->TimeZone);
    in.imbue(std::locale::classic());
    if (!(in >> timeZone) || !(in >> std::ws).eof() || !(timeZone >= -12.0 && timeZone <= 14.0))
    {
      return "got the time zone '" + this->TimeZone + "', expected hours from -12 to 14";
    }
  }
  const SunClock clock(this->FirstDay, this->Latitude, this->Longitude, timeZone);
  const double least = this->MinimumElevation > 0.0
    ? std::sin(vtkMath::RadiansFromDegrees(this->MinimumElevation))
    : 0.0;
  const double turn = vtkMath::RadiansFromDegrees(this->North);
  const glm::dmat3 world = GetWorld(this->UpAxis);
  const double length = this->Step / 60.0;
  const auto countSteps = [length](double hours) {
    return static_cast<int>(std::ceil(hours / length - 1e-9));
  };
  const auto addParts = [&](double begin, double end, double counted, Sun sun) {
    for (const auto& [from, to] : clock.GetParts(begin, end, least))
    {
      const Vector local = clock.GetDirection(0.5 * (from + to));
      sun.Local = this->North == 0.0
        ? glm::dvec3(local[0], local[1], local[2])
        : glm::dvec3(local[0] * std::cos(turn) + local[1] * std::sin(turn),
            local[1] * std::cos(turn) - local[0] * std::sin(turn), local[2]);
      const glm::dvec3 direction = world * sun.Local;
      sun.Direction = { direction.x, direction.y, direction.z };
      sun.Hours = counted * (to - from);
      if (weather.IsEmpty())
      {
        sun.Light =
          relievo::GetClearSky(sun.Local.z, sun.Extraterrestrial, this->Altitude, this->Turbidity);
      }
      suns.push_back(sun);
    }
  };
  for (long day = 0; day < days; day += this->DayStep)
  {
    const long span = std::min<long>(this->DayStep, days - day);
    const auto counted = static_cast<double>(span);
    const long middle = day + (span - 1) / 2;
    const double midnight = HoursOfDay * static_cast<double>(middle);
    const double first = midnight + this->BeginHour;
    const double last = midnight + this->EndHour;
    const std::array<int, 3> date = GetDate(firstDay + middle);
    const int newYear[3] = { date[0], 1, 1 };
    Sun sun{};
    sun.Extraterrestrial = relievo::GetExtraterrestrial(
      static_cast<int>(CountDays(date.data()) - CountDays(newYear)) + 1);
    if (weather.IsEmpty())
    {
      const int steps = countSteps(this->EndHour - this->BeginHour);
      for (int step = 0; step < steps; ++step)
      {
        const double begin = first + step * length;
        addParts(begin, std::min(last, begin + length), counted, sun);
      }
      continue;
    }
    // The intervals of the weather, whose clock may differ; each has whole steps.
    const double ahead = weather.HasTimeZone() ? weather.GetTimeZone() - timeZone : 0.0;
    const double period = weather.GetPeriod();
    const auto end = static_cast<int>(std::ceil((HoursOfDay + ahead) / period - 1e-9));
    for (auto i = static_cast<int>(std::floor(ahead / period + 1e-9)); i < end; ++i)
    {
      const double from = midnight + std::max(0.0, i * period - ahead);
      const double to = midnight + std::min(HoursOfDay, (i + 1) * period - ahead);
      const int steps = std::max(1, countSteps(to - from));
      const double step = (to - from) / steps;
      double light = 0.0; // hours by day, and these hours times the sine of the sun's height
      double level = 0.0;
      for (int k = 0; k < steps; ++k)
      {
        for (const auto& [a, b] : clock.GetParts(from + k * step, from + (k + 1) * step, 0.0))
        {
          light += b - a;
          level += (b - a) * clock.GetDirection(0.5 * (a + b))[2];
        }
      }
      if (!(light > 0.0))
      {
        continue;
      }
      const int perDay = weather.GetPerDay();
      const int later = (i - (i < 0 ? perDay - 1 : 0)) / perDay; // days, rounded down
      const std::array<int, 3> its = GetDate(firstDay + middle + later);
      const std::size_t index = weather.GetIndex(middle + later, its.data(), i - later * perDay);
      sun.Light.Direct = std::min(sun.Extraterrestrial,
        weather.Direct[index] * (to - from) / (weather.IsLevel() ? level : light));
      sun.Light.Diffuse = weather.Diffuse[index] * (to - from) / light;
      for (int k = 0; k < steps; ++k)
      {
        const double begin = std::max(first, from + k * step);
        const double stop = std::min(last, from + (k + 1) * step);
        if (begin < stop)
        {
          addParts(begin, stop, counted, sun);
        }
      }
    }
  }
  return "";
}

//------------------------------------------------------------------------------
// Reports progress; false if the filter was stopped.
bool vtkRelievoSunExposure::Advance(double done)
{
  this->UpdateProgress(done);
  return !relievo::IsStopped(this);
}

//------------------------------------------------------------------------------
// Hours of sun by a ray from each place to each position of the sun, `share` of all work.
bool vtkRelievoSunExposure::FindHours(const vtkRelievoSurfacePlaces& places,
  vtkRelievoRayScene* scene, const std::vector<Sun>& suns, double share, vtkDataSetAttributes* data)
{
  Openings openings(scene, places);
  std::vector<double> hours(places.At.size());
  std::vector<double> insolation(places.At.size());
  double done = 0.0;
  for (const Sun& sun : suns)
  {
    if (!openings.Find([&sun](std::size_t) { return sun.Direction; },
          [&](std::size_t place, double cosine) {
            hours[place] += sun.Hours;
            insolation[place] += sun.Hours * cosine;
          }))
    {
      vtkErrorMacro("The rays to the sun were not followed; see the errors before.");
      return false;
    }
    done += share / static_cast<double>(suns.size());
    if (!this->Advance(done))
    {
      return false;
    }
  }
  AddArray(data, "sun_hours", hours);
  data->SetActiveScalars("sun_hours");
  AddArray(data, "insolation", insolation);
  return true;
}

//------------------------------------------------------------------------------
// Irradiation, and hours of sun, by one set of rays from each place, `share` of all work.
bool vtkRelievoSunExposure::FindIrradiation(const vtkRelievoSurfacePlaces& places,
  vtkRelievoRayScene* scene, const std::vector<Sun>& suns, double share, vtkPolyData* output,
  vtkDataSetAttributes* data)
{
  constexpr double kilo = 1000.0;
  const glm::dmat3 world = GetWorld(this->UpAxis);
  const double lowest = std::cos(vtkMath::RadiansFromDegrees(85.0)); // in the model of Perez
  vtkRelievoSkyPatches sky(world);
  double uniform = 0.0;
  double horizon = 0.0;
  double open = 0.0;
  for (const Sun& sun : suns)
  {
    const double sine = sun.Local.z;
    const double direct = sun.Light.Direct * sun.Hours / kilo;
    const double diffuse = sun.Light.Diffuse * sun.Hours / kilo;
    const relievo::DiffuseShares shares = this->Irradiance == 2
      ? relievo::GetPerezShares(sine, sun.Extraterrestrial, sun.Light)
      : relievo::DiffuseShares();
    // With the direct light at most that outside of the atmosphere.
    const double height = std::max(sine, lowest);
    const double around = std::min(diffuse * shares.Sun / height,
      std::max(0.0, sun.Extraterrestrial - sun.Light.Direct) * sun.Hours / kilo);
    const double even = diffuse - around * height;
    sky.AddSun(sun.Local, direct, around, sun.Hours);
    uniform += even;
    horizon += diffuse * shares.Horizon;
    open += (direct + around) * sine + even;
  }
  sky.AddSky(uniform, horizon);
  sky.Finish();

  const vtkRelievoConeSight sight(scene->GetTree());
  const std::size_t count = places.At.size();
  std::vector<vtkRelievoSkyPatches::Sums> sums(count);
  constexpr std::size_t block = 64; // places that share a receiver's memory
  constexpr std::size_t batch = 16 * block;
  for (std::size_t first = 0; first < count; first += batch)
  {
    const std::size_t end = std::min(count, first + batch);
    vtkRelievoForAll(static_cast<vtkIdType>((end - first + block - 1) / block), [&](vtkIdType i) {
      vtkRelievoSkyPatches::Receiver receiver(
        sky, scene->GetTree(), sight, this->Tolerance / 100.0);
      const std::size_t from = first + static_cast<std::size_t>(i) * block;
      for (std::size_t place = from; place < std::min(end, from + block); ++place)
      {
        const glm::dvec3 normal = glm::make_vec3(places.Normals[place].data());
        if (normal != glm::dvec3(0.0))
        {
          sums[place] = receiver.Receive(glm::make_vec3(places.At[place].data()), normal);
        }
      }
    });
    if (!this->Advance(share * static_cast<double>(end) / static_cast<double>(count)))
    {
      return false;
    }
  }

  using Sums = vtkRelievoSkyPatches::Sums;
  const auto add = [&](const char* name, const auto& get) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      values[i] = get(sums[i], i);
    }
    AddArray(data, name, values);
  };
  const auto reflected = [&](std::size_t i) {
    const glm::dvec3 normal = glm::make_vec3(places.Normals[i].data());
    return normal == glm::dvec3(0.0)
      ? 0.0
      : 0.5 * this->Albedo * open * (1.0 - glm::dot(normal, world[2]));
  };
  add("irradiation",
    [&](const Sums& each, std::size_t i) { return each.Direct + each.Diffuse + reflected(i); });
  data->SetActiveScalars("irradiation");
  add("direct_irradiation", [](const Sums& each, std::size_t) { return each.Direct; });
  add("diffuse_irradiation", [](const Sums& each, std::size_t) { return each.Diffuse; });
  add("reflected_irradiation", [&](const Sums&, std::size_t i) { return reflected(i); });
  add("irradiation_bound", [](const Sums& each, std::size_t) { return each.Bound; });
  add("sun_hours", [](const Sums& each, std::size_t) { return each.Hours; });
  add("sun_hours_bound", [](const Sums& each, std::size_t) { return each.HoursBound; });
  add("insolation", [](const Sums& each, std::size_t) { return each.Insolation; });
  AddField(output, "open_irradiation", open);
  return true;
}

//------------------------------------------------------------------------------
// The share of a uniform sky's light, after `share` of all work.
bool vtkRelievoSunExposure::FindSky(const vtkRelievoSurfacePlaces& places,
  vtkRelievoRayScene* scene, double share, vtkDataSetAttributes* data)
{
  Openings openings(scene, places);
  std::vector<double> sky(places.At.size());
  double done = share;
  for (const vtkRelievoSkySamples::Point& point :
    vtkRelievoSkySamples::Get(this->SkySamples, false))
  {
    const glm::dvec3 sample =
      relievo::f64::relievoSkyDirection(point.X + 0.5 / this->SkySamples, point.Y, true);
    if (!openings.Find(
          [&](std::size_t place) {
            const glm::dvec3 direction = vtkRelievoSkyTurn(sample, places.Normals[place].data());
            return direction[this->UpAxis] > 0.0 ? Vector{ direction.x, direction.y, direction.z }
                                                 : Vector{};
          },
          [&](std::size_t place, double) { sky[place] += 1.0 / this->SkySamples; }))
    {
      vtkErrorMacro("The rays to the sky were not followed; see the errors before.");
      return false;
    }
    done += (1.0 - share) / this->SkySamples;
    if (!this->Advance(done))
    {
      return false;
    }
  }
  AddArray(data, "sky_view", sky);
  return true;
}

//------------------------------------------------------------------------------
int vtkRelievoSunExposure::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  relievo::Begin(outputs);
  std::vector<Sun> suns;
  const std::string error = this->GetSuns(suns);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 1; // status 0 would make the executive print an internal error
  }
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const vtkSmartPointer<vtkRelievoRayScene> scene = this->MakeScene(inputs);
  if (!scene)
  {
    return 1;
  }
  vtkRelievoSurfacePlaces places;
  this->Points ? places.TakePoints(mesh) : places.TakeCells(mesh);
  places.Keep(this->GetShare(places.At.size()));

  output->ShallowCopy(mesh);
  vtkDataSetAttributes* data =
    output->GetAttributes(this->Points ? vtkDataObject::POINT : vtkDataObject::CELL);
  const auto steps = static_cast<double>(suns.size());
  const double share = this->SkySamples > 0 ? steps / (steps + this->SkySamples) : 1.0;
  const bool isDone =
    (this->Irradiance == 0 ? this->FindHours(places, scene, suns, share, data)
                           : this->FindIrradiation(places, scene, suns, share, output, data)) &&
    (this->SkySamples == 0 || this->FindSky(places, scene, share, data));
  if (!isDone)
  {
    relievo::Discard(outputs);
    return 1;
  }
  double possible = 0.0;
  for (const Sun& sun : suns)
  {
    possible += sun.Hours;
  }
  AddField(output, "possible_hours", possible);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRelievoSunExposure::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Parameters.Print(os, indent);
  os << indent << "FirstDay: " << this->FirstDay[0] << "-" << this->FirstDay[1] << "-"
     << this->FirstDay[2] << "\n";
  os << indent << "LastDay: " << this->LastDay[0] << "-" << this->LastDay[1] << "-"
     << this->LastDay[2] << "\n";
}
