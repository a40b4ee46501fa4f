// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLidar.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <functional>

vtkStandardNewMacro(vtkRelievoLidar);

namespace
{
constexpr double FullTurn = 360.0; // degrees

// Rotates a vector about an axis, by a share of the axis's length in degrees (Rodrigues).
void Rotate(const double turn[3], double share, double vector[3])
{
  double axis[3] = { turn[0], turn[1], turn[2] };
  const double angle = vtkMath::RadiansFromDegrees(share * vtkMath::Normalize(axis));
  double across[3];
  vtkMath::Cross(axis, vector, across);
  const double along = vtkMath::Dot(axis, vector) * (1.0 - std::cos(angle));
  for (int i = 0; i < 3; ++i)
  {
    vector[i] = vector[i] * std::cos(angle) + across[i] * std::sin(angle) + axis[i] * along;
  }
}
}

//------------------------------------------------------------------------------
vtkRelievoLidar::vtkRelievoLidar()
{
  constexpr int beams = 16;
  double elevations[beams];
  for (int i = 0; i < beams; ++i)
  {
    elevations[i] = 15.0 - 2.0 * i;
  }
  this->SetSpinning(beams, elevations, 1800, 180.0, -180.0);
}

//------------------------------------------------------------------------------
bool vtkRelievoLidar::CheckAngles(const char* what, int count, const double* angles)
{
  if (count < 1 ||
    !std::all_of(angles, angles + count, [](double angle) { return std::isfinite(angle); }))
  {
    vtkErrorMacro("The " << what << " of " << count
                         << " beams were given, expected 1 or more, all of them finite degrees.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::SetSpinning(
  int beams, const double* elevations, int steps, double first, double last)
{
  if (!this->CheckAngles("elevations", beams, elevations))
  {
    return;
  }
  if (steps < 1 || !std::isfinite(first + last))
  {
    vtkErrorMacro("A turn of " << steps << " steps from " << first << " to " << last
                               << " degrees, expected 1 step or more between finite angles.");
    return;
  }
  this->Elevations.assign(elevations, elevations + beams);
  this->Azimuths.assign(this->Elevations.size(), 0.0);
  this->Spins = true;
  this->First = first;
  this->Last = last;
  this->Size[0] = steps;
  this->Size[1] = beams;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::SetAzimuthOffsets(int beams, const double* offsets)
{
  if (!this->Spins || beams != static_cast<int>(this->Elevations.size()))
  {
    vtkErrorMacro(<< beams << " azimuth offsets were given, expected one for each of "
                  << (this->Spins ? this->Elevations.size() : 0) << " beams of a spinning sensor.");
    return;
  }
  if (this->CheckAngles("azimuth offsets", beams, offsets))
  {
    this->Azimuths.assign(offsets, offsets + beams);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::SetDirections(int beams, const double* azimuths, const double* elevations)
{
  if (!this->CheckAngles("azimuths", beams, azimuths) ||
    !this->CheckAngles("elevations", beams, elevations))
  {
    return;
  }
  this->Azimuths.assign(azimuths, azimuths + beams);
  this->Elevations.assign(elevations, elevations + beams);
  this->Spins = false;
  this->Size[0] = beams;
  this->Size[1] = 1;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoLidar::LookAt(const double position[3], const double target[3], const double up[3])
{
  if (!this->Superclass::LookAt(position, target, up))
  {
    return false;
  }
  // From right, down, forward to forward, left, up.
  const auto turn = [](double* right, double* down, double* forward) {
    const double left = -*right;
    const double above = -*down;
    *right = *forward;
    *down = left;
    *forward = above;
  };
  for (int i = 0; i < 3; ++i)
  {
    turn(this->Rotation + i, this->Rotation + 3 + i, this->Rotation + 6 + i);
  }
  turn(this->Translation, this->Translation + 1, this->Translation + 2);
  return true;
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::SetMotion(const double way[3], const double turn[3])
{
  for (const double* values : { way, turn })
  {
    if (!std::isfinite(values[0] + values[1] + values[2]))
    {
      vtkErrorMacro("A motion by " << values[0] << ", " << values[1] << ", " << values[2]
                                   << " in a turn, expected three finite numbers.");
      return;
    }
  }
  std::copy_n(way, 3, this->Way);
  std::copy_n(turn, 3, this->Turn);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::SetRangeLimits(double minimum, double maximum)
{
  if (!(minimum >= 0.0 && minimum < maximum))
  {
    vtkErrorMacro(
      "Range limits of " << minimum << " and " << maximum << ", expected 0 <= minimum < maximum.");
    return;
  }
  this->RangeLimits[0] = minimum;
  this->RangeLimits[1] = maximum;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::GetRangeLimits(double limits[2])
{
  std::copy_n(this->RangeLimits, 2, limits);
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::SetDivergence(double degrees, int rays)
{
  if (!(degrees >= 0.0 && degrees <= 90.0) || rays < 1 || rays > 4096)
  {
    vtkErrorMacro("A divergence of " << degrees << " degrees with " << rays
                                     << " rays, expected 0 to 90 degrees and 1 to 4096 rays.");
    return;
  }
  this->Divergence = degrees;
  this->RaysOfABeam = rays;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::SetNoise(double deviation, int seed)
{
  if (!(deviation >= 0.0 && std::isfinite(deviation)))
  {
    vtkErrorMacro("A noise of " << deviation << " world units, expected 0 or more.");
    return;
  }
  this->Noise = deviation;
  this->Seed = seed;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoLidar::HasPlaces()
{
  const std::vector<double>& e = this->Elevations;
  return this->Spins && this->First != this->Last && e.size() > 1 &&
    (std::adjacent_find(e.begin(), e.end(), std::less_equal<double>()) == e.end() ||
      std::adjacent_find(e.begin(), e.end(), std::greater_equal<double>()) == e.end());
}

//------------------------------------------------------------------------------
double vtkRelievoLidar::GetColumnsOfTurn()
{
  return this->Spins && std::abs(this->Last - this->First) == FullTurn ? this->Size[0] : 0.0;
}

//------------------------------------------------------------------------------
bool vtkRelievoLidar::IsMoving() const
{
  return this->Spins && (vtkMath::Norm(this->Way) > 0.0 || vtkMath::Norm(this->Turn) > 0.0);
}

//------------------------------------------------------------------------------
// The value of a table of beams at row v, beyond its ends that of its last two beams continued.
double vtkRelievoLidar::GetInterpolated(const std::vector<double>& values, double v) const
{
  const auto last = static_cast<double>(values.size() - 2);
  const double below = std::clamp(std::floor(v), 0.0, last);
  const auto i = static_cast<std::size_t>(below);
  return values[i] + (v - below) * (values[i + 1] - values[i]);
}

//------------------------------------------------------------------------------
bool vtkRelievoLidar::GetCameraRay(double u, double v, double origin[3], double direction[3])
{
  const double beam = this->Spins ? v : u;
  const auto beams = static_cast<double>(this->Elevations.size());
  if (!(beam >= -0.5 && beam <= beams - 0.5 && std::isfinite(u)))
  {
    Nowhere(origin, 3);
    return Nowhere(direction, 3);
  }
  double azimuth = 0.0;
  double elevation = 0.0;
  if (this->HasPlaces())
  {
    azimuth = this->GetInterpolated(this->Azimuths, beam);
    elevation = std::clamp(this->GetInterpolated(this->Elevations, beam), -90.0, 90.0);
  }
  else
  {
    const auto i = static_cast<std::size_t>(std::clamp(std::round(beam), 0.0, beams - 1.0));
    azimuth = this->Azimuths[i];
    elevation = this->Elevations[i];
  }
  if (this->Spins)
  {
    azimuth += this->First + u * (this->Last - this->First) / this->Size[0];
  }
  azimuth = vtkMath::RadiansFromDegrees(azimuth);
  elevation = vtkMath::RadiansFromDegrees(elevation);
  std::fill_n(origin, 3, 0.0);
  direction[0] = std::cos(elevation) * std::cos(azimuth);
  direction[1] = std::cos(elevation) * std::sin(azimuth);
  direction[2] = std::sin(elevation);
  if (this->IsMoving())
  {
    const double share = u / this->Size[0];
    vtkMath::Assign(this->Way, origin);
    vtkMath::MultiplyScalar(origin, share);
    Rotate(this->Turn, share, direction);
  }
  return true;
}

//------------------------------------------------------------------------------
// The row of an elevation; false beyond the poles of the interpolation.
bool vtkRelievoLidar::FindBeam(double elevation, double& v) const
{
  const std::vector<double>& e = this->Elevations;
  const bool rises = e[1] > e[0];
  std::size_t i = 0;
  while (i + 2 < e.size() && (rises ? elevation > e[i + 1] : elevation < e[i + 1]))
  {
    ++i;
  }
  v = static_cast<double>(i) + (elevation - e[i]) / (e[i + 1] - e[i]);
  return std::isfinite(v);
}

//------------------------------------------------------------------------------
// The next estimate of the column u, and of the row, of a point in the axes of column 0.
bool vtkRelievoLidar::FindColumn(const double point[3], double& u, double& v) const
{
  const double share = u / this->Size[0];
  double from[3];
  for (int i = 0; i < 3; ++i)
  {
    from[i] = point[i] - share * this->Way[i];
  }
  Rotate(this->Turn, -share, from);
  const double flat = std::hypot(from[0], from[1]);
  if (!(flat + std::abs(from[2]) > 0.0) ||
    !this->FindBeam(vtkMath::DegreesFromRadians(std::atan2(from[2], flat)), v))
  {
    return false;
  }
  const double step = (this->Last - this->First) / this->Size[0];
  const double azimuth = vtkMath::DegreesFromRadians(std::atan2(from[1], from[0])) -
    this->GetInterpolated(this->Azimuths, v) - this->First - u * step;
  u += std::remainder(azimuth, FullTurn) / step;
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoLidar::ProjectCameraPoint(const double point[3], double pixel[2])
{
  constexpr int iterations = 64;
  constexpr double close = 1e-11; // of a column, relative
  if (!this->HasPlaces())
  {
    return Nowhere(pixel, 2);
  }
  // A moving sensor sees the point after part of its turn: a fixed point of the column. Solutions
  // one turn apart are tried if the first one lies outside the picture.
  const double turn = FullTurn / std::abs(this->Last - this->First) * this->Size[0];
  const double middle = 0.5 * (this->Size[0] - 1);
  bool isFound = false;
  for (const double start : { middle, middle - turn, middle + turn })
  {
    double u = start;
    double v = 0.0;
    double before = u;
    int i = 0;
    do
    {
      before = u;
      if (!this->FindColumn(point, u, v))
      {
        return Nowhere(pixel, 2);
      }
      ++i;
    } while (i < iterations && std::abs(u - before) > close * turn && this->IsMoving());
    const bool isIn = u >= -0.5 && u <= this->Size[0] - 0.5;
    if (i < iterations && (isIn || !isFound))
    {
      pixel[0] = u;
      pixel[1] = v;
      isFound = true;
    }
    if (isIn && i < iterations)
    {
      break;
    }
  }
  return isFound || Nowhere(pixel, 2);
}

//------------------------------------------------------------------------------
double vtkRelievoLidar::GetDepth(const double origin[3], const double point[3])
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(origin, point));
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::Copy(vtkRelievoCameraModel* other)
{
  this->Superclass::Copy(other);
  if (auto* same = vtkRelievoLidar::SafeDownCast(other))
  {
    this->Elevations = same->Elevations;
    this->Azimuths = same->Azimuths;
    this->Spins = same->Spins;
    this->First = same->First;
    this->Last = same->Last;
    std::copy_n(same->Way, 3, this->Way);
    std::copy_n(same->Turn, 3, this->Turn);
    std::copy_n(same->RangeLimits, 2, this->RangeLimits);
    this->Divergence = same->Divergence;
    this->RaysOfABeam = same->RaysOfABeam;
    this->Return = same->Return;
    this->Noise = same->Noise;
    this->Seed = same->Seed;
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::AddTo(vtkFieldData* fields)
{
  this->Superclass::AddTo(fields);
  AddText(fields, "lens", "lidar");
  AddNumbers(
    fields, "elevations", this->Elevations.data(), static_cast<int>(this->Elevations.size()));
  AddNumbers(fields, "azimuths", this->Azimuths.data(), static_cast<int>(this->Azimuths.size()));
  if (this->Spins)
  {
    const double ends[2] = { this->First, this->Last };
    AddNumbers(fields, "turn", ends, 2);
  }
  if (this->IsMoving())
  {
    AddNumbers(fields, "way", this->Way, 3);
    AddNumbers(fields, "rotation", this->Turn, 3);
  }
  if (this->RangeLimits[0] > 0.0)
  {
    AddNumbers(fields, "min_range", this->RangeLimits, 1);
  }
  if (std::isfinite(this->RangeLimits[1]))
  {
    AddNumbers(fields, "max_range", this->RangeLimits + 1, 1);
  }
  if (this->Divergence > 0.0)
  {
    const double values[3] = { this->Divergence, static_cast<double>(this->RaysOfABeam),
      static_cast<double>(this->Return) };
    AddNumbers(fields, "divergence", values, 3);
  }
  if (this->Noise > 0.0)
  {
    const double values[2] = { this->Noise, static_cast<double>(this->Seed) };
    AddNumbers(fields, "noise", values, 2);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Beams: " << this->Elevations.size() << "\n";
  os << indent << "Spins: " << (this->Spins ? "yes" : "no") << "\n";
  os << indent << "Turn: " << this->First << " to " << this->Last << " degrees\n";
  os << indent << "Motion: " << this->Way[0] << ", " << this->Way[1] << ", " << this->Way[2]
     << ", rotation " << this->Turn[0] << ", " << this->Turn[1] << ", " << this->Turn[2] << "\n";
  os << indent << "RangeLimits: " << this->RangeLimits[0] << ", " << this->RangeLimits[1] << "\n";
  os << indent << "Divergence: " << this->Divergence << "\n";
  os << indent << "RaysOfABeam: " << this->RaysOfABeam << "\n";
  os << indent << "Return: " << (this->Return == FIRST ? "first" : "last") << "\n";
  os << indent << "Noise: " << this->Noise << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
