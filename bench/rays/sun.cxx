// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The floor of a courtyard twice as wide as high: error of hours of sun by the time step, and of
// the sky's share by the number of rays, against time. The truth uses no rays: the sky's share of
// the opening in closed form, and the sun, every few seconds, where the line to it passes the
// opening.
#include "BenchSizes.h"
#include "RelievoBench.h"
#include "Table.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>
#include <vtkRelievoSolarPosition.h>
#include <vtkRelievoSunExposure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace
{
using namespace relievoBench;

constexpr double Half = 1.0;   // of the floor's side
constexpr double Height = 1.0; // of the walls
constexpr double Latitude = 40.0;
constexpr int Day[3] = { 2026, 6, 21 };

// The middles of the floor's cells, in the order of vtkPlaneSource.
std::vector<std::array<double, 2>> GetPlaces(int side)
{
  std::vector<std::array<double, 2>> places;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      places.push_back(
        { Half * (2.0 * (x + 0.5) / side - 1.0), Half * (2.0 * (y + 0.5) / side - 1.0) });
    }
  }
  return places;
}

// The share of uniform skylight through a rectangle above, one corner of which is vertically above.
double GetCorner(double a, double b)
{
  const double x = a / Height;
  const double y = b / Height;
  const double overX = std::sqrt(1.0 + x * x);
  const double overY = std::sqrt(1.0 + y * y);
  return (x / overX * std::atan(y / overX) + y / overY * std::atan(x / overY)) / (2.0 * M_PI);
}

std::vector<double> GetSky(int side)
{
  std::vector<double> sky;
  for (const auto& at : GetPlaces(side))
  {
    double sum = 0.0;
    for (const double x : { Half - at[0], Half + at[0] })
    {
      for (const double y : { Half - at[1], Half + at[1] })
      {
        sum += GetCorner(x, y);
      }
    }
    sky.push_back(sum);
  }
  return sky;
}

std::vector<double> GetHours(int side, double seconds)
{
  const auto places = GetPlaces(side);
  std::vector<double> hours(places.size(), 0.0);
  vtkNew<vtkRelievoSolarPosition> sun;
  sun->SetLatitude(Latitude);
  sun->SetDate(Day[0], Day[1], Day[2]);
  const auto steps = static_cast<int>(86400.0 / seconds);
  for (int step = 0; step < steps; ++step)
  {
    sun->SetHour(24.0 * (step + 0.5) / steps);
    double d[3]; // east, north, up
    sun->GetDirection(d);
    for (std::size_t i = 0; i < places.size() && d[2] > 0.0; ++i)
    {
      const bool seen = std::abs(places[i][0] + d[0] / d[2] * Height) < Half &&
        std::abs(places[i][1] + d[1] / d[2] * Height) < Half;
      hours[i] += seen ? 24.0 / steps : 0.0;
    }
  }
  return hours;
}

void SetPlate(vtkPlaneSource* plate, const double corner[3], const double first[3],
  const double second[3], int side)
{
  plate->SetOrigin(corner[0], corner[1], corner[2]);
  plate->SetPoint1(first[0], first[1], first[2]);
  plate->SetPoint2(second[0], second[1], second[2]);
  plate->SetResolution(side, side);
}

class Courtyard
{
public:
  explicit Courtyard(int side)
  {
    const double corners[4][3] = { { -Half, -Half, 0.0 }, { Half, -Half, 0.0 }, { Half, Half, 0.0 },
      { -Half, Half, 0.0 } };
    vtkNew<vtkPlaneSource> floor;
    SetPlate(floor, corners[0], corners[1], corners[3], side);
    this->Filter->SetInputConnection(floor->GetOutputPort());
    for (int i = 0; i < 4; ++i)
    {
      const double* from = corners[i];
      const double top[3] = { from[0], from[1], Height };
      vtkNew<vtkPlaneSource> wall;
      SetPlate(wall, from, corners[(i + 1) % 4], top, 1);
      this->Filter->AddInputConnection(1, wall->GetOutputPort());
    }
    this->Filter->SetUpAxis(2);
    this->Filter->SetLatitude(Latitude);
    this->Filter->SetFirstDay(Day[0], Day[1], Day[2]);
    this->Filter->SetLastDay(Day[0], Day[1], Day[2]);
  }

  // A row: the best time of some rounds, summed over all cores, and the array's error.
  void Measure(const std::string& what, double amount, const char* array,
    const std::vector<double>& truth, int rounds, Table& table)
  {
    double best = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round)
    {
      this->Filter->Modified();
      const std::clock_t begin = std::clock();
      this->Filter->Update();
      best = std::min(best, 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    vtkDataArray* found = this->Filter->GetOutput()->GetCellData()->GetArray(array);
    double sum = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
      const double error = std::abs(found->GetTuple1(static_cast<vtkIdType>(i)) - truth[i]);
      sum += error * error;
      most = std::max(most, error);
    }
    const double rms = std::sqrt(sum / static_cast<double>(truth.size()));
    table.AddRow(
      { what, "rays in double", Number(amount), Number(rms), Number(most), Number(best, 3) });
    std::cout << what << ", " << Number(amount) << ": rms " << Number(rms) << ", at most "
              << Number(most) << ", " << Number(best, 3) << " ms of a core" << std::endl;
  }

  vtkNew<vtkRelievoSunExposure> Filter;
};
}

//------------------------------------------------------------------------------
int relievoBench::BenchSun(const std::string& outDir, const SunSizes& sizes)
{
  if (!MakeFolder(outDir))
  {
    return 1;
  }
  Table table({ "of", "method", "step minutes or rays", "rms", "most", "core milliseconds" });
  Courtyard courtyard(sizes.Side);
  const std::vector<double> hours = GetHours(sizes.Side, sizes.TruthStep);
  for (const double step : sizes.Steps)
  {
    courtyard.Filter->SetStep(step);
    courtyard.Measure("hours of sun", step, "sun_hours", hours, sizes.Rounds, table);
  }
  // A single sun position while rays into the sky are timed.
  courtyard.Filter->SetStep(240.0);
  const std::vector<double> sky = GetSky(sizes.Side);
  for (const int samples : sizes.Samples)
  {
    courtyard.Filter->SetSkySamples(samples);
    courtyard.Measure("share of the sky", samples, "sky_view", sky, sizes.Rounds, table);
  }
  return table.WriteCsv(outDir + "/sun.csv") ? 0 : 1;
}

//------------------------------------------------------------------------------
int RelievoBenchSun(const std::string& outDir)
{
  return relievoBench::BenchSun(outDir, relievoBench::SunSizes());
}
