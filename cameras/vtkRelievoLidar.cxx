// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLidar.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRelievoLidar);

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
bool vtkRelievoLidar::GetCameraRay(double u, double v, double origin[3], double direction[3])
{
  // The nearest beam, and for a spinning sensor the angle between two steps.
  const double beam = std::round(this->Spins ? v : u);
  if (!(beam >= 0.0 && beam < static_cast<double>(this->Elevations.size()) && std::isfinite(u)))
  {
    Nowhere(origin, 3);
    return Nowhere(direction, 3);
  }
  const auto i = static_cast<std::size_t>(beam);
  double azimuth = this->Azimuths[i];
  if (this->Spins)
  {
    azimuth += this->First + u * (this->Last - this->First) / this->Size[0];
  }
  azimuth = vtkMath::RadiansFromDegrees(azimuth);
  const double elevation = vtkMath::RadiansFromDegrees(this->Elevations[i]);
  std::fill_n(origin, 3, 0.0);
  direction[0] = std::cos(elevation) * std::cos(azimuth);
  direction[1] = std::cos(elevation) * std::sin(azimuth);
  direction[2] = std::sin(elevation);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoLidar::ProjectCameraPoint(const double[3], double pixel[2])
{
  return Nowhere(pixel, 2);
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
}

//------------------------------------------------------------------------------
void vtkRelievoLidar::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Beams: " << this->Elevations.size() << "\n";
  os << indent << "Spins: " << (this->Spins ? "yes" : "no") << "\n";
  os << indent << "Turn: " << this->First << " to " << this->Last << " degrees\n";
}
