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
#include "vtkRelievoPolygonCut.h"
#include "vtkRelievoRayScene.h"
#include "vtkRelievoSkySamples.h"
#include "vtkRelievoSkyTurn.h"
#include "vtkRelievoSolarPosition.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkRelievoSunExposure);

namespace
{
constexpr double BeforeSurface = 1e-7; // of the mesh's size
constexpr double HoursOfDay = 24.0;
constexpr int MostDays = 366 * 200;

using Vector = std::array<double, 3>;

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

// The positions at which the mesh is evaluated, in front of it, and their normals.
class Places
{
public:
  std::vector<Vector> At;
  std::vector<Vector> Normals; // 0 where there is no surface

  // Polygons and strips: the area-weighted middle of their triangles, moved along the normal onto
  // the triangle behind it. If there is none (in a U, between the legs): the middle of the largest
  // triangle.
  void TakeCells(vtkPolyData* mesh, double before)
  {
    const auto count = static_cast<std::size_t>(mesh->GetNumberOfCells());
    const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
    this->Normals.assign(count, Vector{});
    std::vector<Vector> middles(count, Vector{});
    std::vector<double> areas(count);
    const auto forEach = [&](const auto& take) {
      vtkRelievoPolygonCut::ForEachTriangle(
        mesh,
        [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell) {
          take(static_cast<std::size_t>(first + cell), Triangle(mesh, a, b, c));
        },
        vtkRelievoPolygonCut::Rule::ByOutline);
    };
    forEach([&](std::size_t at, const Triangle& triangle) {
      vtkMath::Add(this->Normals[at].data(), triangle.Cross.data(), this->Normals[at].data());
    });
    for (Vector& normal : this->Normals)
    {
      vtkMath::Normalize(normal.data());
    }
    forEach([&](std::size_t at, const Triangle& triangle) {
      const double area = vtkMath::Dot(triangle.Cross.data(), this->Normals[at].data());
      areas[at] += area;
      for (std::size_t i = 0; i < 3; ++i)
      {
        middles[at][i] += area * triangle.Middle[i];
      }
    });
    for (std::size_t at = 0; at < count; ++at)
    {
      if (areas[at] > 0.0)
      {
        vtkMath::MultiplyScalar(middles[at].data(), 1.0 / areas[at]);
      }
    }
    std::vector<Vector> places = middles;
    std::vector<double> largest(count); // infinity: the middle lies over a triangle
    forEach([&](std::size_t at, const Triangle& triangle) {
      const double area = vtkMath::Dot(triangle.Cross.data(), this->Normals[at].data());
      const bool over = triangle.IsBelow(middles[at], this->Normals[at]);
      if (over ? std::isfinite(largest[at]) : area > largest[at])
      {
        largest[at] = over ? vtkMath::Inf() : area;
        places[at] = over ? triangle.Project(middles[at], this->Normals[at]) : triangle.Middle;
      }
    });
    for (const Vector& place : places)
    {
      this->Add(place, before);
    }
  }

  // A point has its own normal, or the mean of the surrounding triangles' normals weighted by their
  // angles at the point (G. Thürmer, C. A. Wüthrich 1998), which does not depend on how faces are
  // cut.
  void TakePoints(vtkPolyData* mesh, double before)
  {
    this->Normals.assign(static_cast<std::size_t>(mesh->GetNumberOfPoints()), Vector{});
    vtkDataArray* own = mesh->GetPointData()->GetNormals();
    if (!own)
    {
      vtkRelievoPolygonCut::ForEachTriangle(
        mesh,
        [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType) {
          Vector unit = Triangle(mesh, a, b, c).Cross;
          vtkMath::Normalize(unit.data());
          for (const auto& [point, next, last] :
            { std::array<vtkIdType, 3>{ a, b, c }, { b, c, a }, { c, a, b } })
          {
            const double angle = GetAngle(mesh, point, next, last);
            Vector& sum = this->Normals[static_cast<std::size_t>(point)];
            for (std::size_t i = 0; i < 3; ++i)
            {
              sum[i] += angle * unit[i];
            }
          }
        },
        vtkRelievoPolygonCut::Rule::ByOutline);
    }
    for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
    {
      Vector& normal = this->Normals[static_cast<std::size_t>(point)];
      if (own)
      {
        own->GetTuple(point, normal.data());
      }
      vtkMath::Normalize(normal.data());
      Vector place;
      mesh->GetPoint(point, place.data());
      this->Add(place, before);
    }
  }

  // No place outside of the range faces the light.
  void Keep(const std::array<std::size_t, 2>& range)
  {
    for (std::size_t i = 0; i < this->Normals.size(); ++i)
    {
      if (i < range[0] || i >= range[1])
      {
        this->Normals[i] = Vector{};
      }
    }
  }

private:
  struct Triangle
  {
    Vector Corners[3];
    Vector Cross; // as long as twice its area
    Vector Middle;

    Triangle(vtkPolyData* mesh, vtkIdType a, vtkIdType b, vtkIdType c)
    {
      mesh->GetPoint(a, this->Corners[0].data());
      mesh->GetPoint(b, this->Corners[1].data());
      mesh->GetPoint(c, this->Corners[2].data());
      const Vector ab = From(this->Corners[0], this->Corners[1]);
      const Vector ac = From(this->Corners[0], this->Corners[2]);
      vtkMath::Cross(ab.data(), ac.data(), this->Cross.data());
      for (std::size_t i = 0; i < 3; ++i)
      {
        this->Middle[i] = this->Corners[0][i] + (ab[i] + ac[i]) / 3.0;
      }
    }

    // Whether a line along a normal through a position hits the triangle.
    bool IsBelow(const Vector& place, const Vector& normal) const
    {
      bool below = vtkMath::Dot(this->Cross.data(), normal.data()) > 0.0;
      for (std::size_t i = 0; i < 3 && below; ++i)
      {
        const Vector side = From(this->Corners[i], this->Corners[(i + 1) % 3]);
        const Vector to = From(this->Corners[i], place);
        Vector cross;
        vtkMath::Cross(side.data(), to.data(), cross.data());
        below = vtkMath::Dot(cross.data(), normal.data()) >= 0.0;
      }
      return below;
    }

    // The position of that hit.
    Vector Project(const Vector& place, const Vector& normal) const
    {
      const Vector to = From(place, this->Corners[0]);
      const double along = vtkMath::Dot(to.data(), this->Cross.data()) /
        vtkMath::Dot(normal.data(), this->Cross.data());
      Vector projected = place;
      for (std::size_t i = 0; i < 3; ++i)
      {
        projected[i] += along * normal[i];
      }
      return projected;
    }

    static Vector From(const Vector& a, const Vector& b)
    {
      return { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    }
  };

  // The angle at a point between two others.
  static double GetAngle(vtkPolyData* mesh, vtkIdType at, vtkIdType a, vtkIdType b)
  {
    Vector middle;
    Vector sides[2];
    mesh->GetPoint(at, middle.data());
    mesh->GetPoint(a, sides[0].data());
    mesh->GetPoint(b, sides[1].data());
    vtkMath::Subtract(sides[0].data(), middle.data(), sides[0].data());
    vtkMath::Subtract(sides[1].data(), middle.data(), sides[1].data());
    return vtkMath::AngleBetweenVectors(sides[0].data(), sides[1].data());
  }

  void Add(Vector place, double before)
  {
    const Vector& normal = this->Normals[this->At.size()];
    for (std::size_t i = 0; i < 3; ++i)
    {
      place[i] += before * normal[i];
    }
    this->At.push_back(place);
  }
};

// Finds the positions with free sight in a direction: those that face it, by rays.
class Openings
{
public:
  Openings(vtkRelievoRayScene* scene, const Places& places)
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
  const Places& All;
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
  Places places;
  const double before = BeforeSurface * mesh->GetLength();
  this->Points ? places.TakePoints(mesh, before) : places.TakeCells(mesh, before);
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
