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
#include "vtkRelievoSkySamples.h"
#include "vtkRelievoSkyTurn.h"
#include "vtkRelievoSolarPosition.h"
#include "vtkRelievoSurfacePlaces.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

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
    LastYear, "The first day, from midnight of local mean time.");
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
  Vector Direction;
  double Hours;
};

//------------------------------------------------------------------------------
// The sun in the middle of each step by day, or of the part of a step in which the sun is up, in
// world coordinates.
std::vector<vtkRelievoSunExposure::Sun> vtkRelievoSunExposure::GetSuns() const
{
  vtkNew<vtkRelievoSolarPosition> sun;
  sun->SetLatitude(this->Latitude);
  sun->SetLongitude(this->Longitude);
  sun->SetTimeZone(this->Longitude / 15.0);
  sun->SetDate(this->FirstDay[0], this->FirstDay[1], this->FirstDay[2]);
  const double length = this->Step / 60.0;
  const auto steps = static_cast<int>(std::ceil(HoursOfDay / length - 1e-9));
  const auto getDirection = [&sun](double hour) {
    Vector local; // east, north, up
    sun->SetHour(hour);
    sun->GetDirection(local.data());
    return local;
  };
  const auto isUp = [&getDirection](double hour) { return getDirection(hour)[2] > 0.0; };
  // The time of sunrise or sunset between two times.
  const auto findHorizon = [&isUp](double before, double after) {
    const bool rises = isUp(after);
    for (int i = 0; i < 32; ++i) // to a microsecond
    {
      const double middle = 0.5 * (before + after);
      (isUp(middle) == rises ? after : before) = middle;
    }
    return after;
  };
  const long days = CountDays(this->LastDay) - CountDays(this->FirstDay) + 1;
  std::vector<Sun> suns;
  for (long day = 0; day < days; day += this->DayStep)
  {
    const long counted = std::min<long>(this->DayStep, days - day);
    const double middle = static_cast<double>(day + (counted - 1) / 2);
    for (int step = 0; step < steps; ++step)
    {
      const double begin = HoursOfDay * middle + step * length;
      const double end = std::min(HoursOfDay * (middle + 1.0), begin + length);
      // In each half of a step the sun crosses the horizon at most once.
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
      for (const auto& [from, to] : parts)
      {
        const Vector local = getDirection(0.5 * (from + to));
        const Vector direction = this->UpAxis == 0 ? Vector{ local[2], local[0], local[1] }
          : this->UpAxis == 1                      ? Vector{ local[0], local[2], -local[1] }
                                                   : Vector{ local[0], local[1], local[2] };
        suns.push_back({ direction, static_cast<double>(counted) * (to - from) });
      }
    }
  }
  return suns;
}

//------------------------------------------------------------------------------
int vtkRelievoSunExposure::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  relievo::Begin(outputs);
  const std::string error = CheckDays(this->FirstDay, this->LastDay);
  if (!error.empty())
  {
    vtkErrorMacro(<< error);
    return 1; // status 0 would make the executive print an internal error
  }
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const vtkSmartPointer<vtkRelievoRayScene> scene = MakeScene(inputs);
  vtkRelievoSurfacePlaces places;
  this->Points ? places.TakePoints(mesh) : places.TakeCells(mesh);
  places.Keep(this->GetShare(places.At.size()));

  Openings openings(scene, places);
  std::vector<double> hours(places.At.size());
  std::vector<double> insolation(places.At.size());
  std::vector<double> sky(places.At.size());
  const std::vector<Sun> suns = this->GetSuns();
  const auto points = vtkRelievoSkySamples::Get(this->SkySamples, false);
  const std::size_t all = suns.size() + static_cast<std::size_t>(this->SkySamples);
  double possible = 0.0;
  for (std::size_t i = 0; i < all; ++i)
  {
    bool good = true;
    if (i < suns.size())
    {
      const Sun& sun = suns[i];
      possible += sun.Hours;
      good = openings.Find([&sun](std::size_t) { return sun.Direction; },
        [&](std::size_t place, double cosine) {
          hours[place] += sun.Hours;
          insolation[place] += sun.Hours * cosine;
        });
    }
    else
    {
      const vtkRelievoSkySamples::Point& point = points[i - suns.size()];
      const glm::dvec3 sample =
        relievo::f64::relievoSkyDirection(point.X + 0.5 / this->SkySamples, point.Y, true);
      good = openings.Find(
        [&](std::size_t place) {
          const glm::dvec3 direction = vtkRelievoSkyTurn(sample, places.Normals[place].data());
          return direction[this->UpAxis] > 0.0 ? Vector{ direction.x, direction.y, direction.z }
                                               : Vector{};
        },
        [&](std::size_t place, double) { sky[place] += 1.0 / this->SkySamples; });
    }
    if (!good)
    {
      vtkErrorMacro("The rays to the sun were not followed; see the errors before.");
      return 1;
    }
    this->UpdateProgress(static_cast<double>(i + 1) / static_cast<double>(all));
    if (relievo::IsStopped(this))
    {
      relievo::Discard(outputs);
      return 1;
    }
  }
  output->ShallowCopy(mesh);
  vtkDataSetAttributes* data =
    output->GetAttributes(this->Points ? vtkDataObject::POINT : vtkDataObject::CELL);
  AddArray(data, "sun_hours", hours);
  data->SetActiveScalars("sun_hours");
  AddArray(data, "insolation", insolation);
  if (this->SkySamples > 0)
  {
    AddArray(data, "sky_view", sky);
  }
  vtkNew<vtkDoubleArray> open;
  open->SetName("possible_hours");
  open->InsertNextValue(possible);
  output->GetFieldData()->AddArray(open);
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
