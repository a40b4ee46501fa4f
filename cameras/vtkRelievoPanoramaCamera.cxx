// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoPanoramaCamera.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoCubeFaces.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRelievoPanoramaCamera);

//------------------------------------------------------------------------------
std::vector<vtkRelievoSensorWords> vtkRelievoPanoramaCamera::GetWords()
{
  vtkRelievoSensorWords whole = { "equirectangular", "equirectangular[:H,V]", { 0, 2 },
    ": degrees above 0, H at most 360 and V at most 180" };
  whole.IsGood = [](const std::vector<double>& n) {
    return n[0] > 0.0 && n[0] <= 360.0 && n[1] > 0.0 && n[1] <= 180.0;
  };
  whole.Make = [](const std::vector<double>& n,
                 const vtkRelievoSensorView&) -> vtkRelievoCameraModel* {
    auto* made = vtkRelievoPanoramaCamera::New();
    made->SetFieldOfView(n.empty() ? 360.0 : n[0], n.empty() ? 180.0 : n[1]);
    return made;
  };
  vtkRelievoSensorWords cube = { "cube", "cube", { 0 }, " alone" };
  cube.CheckSize = [](int columns, int rows) {
    const std::string wide = std::to_string(relievo::CubeFaces * rows);
    return columns == relievo::CubeFaces * rows
      ? ""
      : "a cube's six faces lie side by side: got a picture of " + std::to_string(columns) + "x" +
        std::to_string(rows) + ", expected one six times as wide as high, such as " + wide + "x" +
        std::to_string(rows);
  };
  cube.Make = [](
                const std::vector<double>&, const vtkRelievoSensorView&) -> vtkRelievoCameraModel* {
    auto* made = vtkRelievoPanoramaCamera::New();
    made->SetLayout(CUBE);
    return made;
  };
  return { whole, cube };
}

//------------------------------------------------------------------------------
void vtkRelievoPanoramaCamera::SetFieldOfView(double horizontal, double vertical)
{
  if (!(horizontal > 0.0 && horizontal <= 360.0 && vertical > 0.0 && vertical <= 180.0))
  {
    vtkErrorMacro("The field of view is " << horizontal << " x " << vertical
                                          << " degrees, expected above 0, at most 360 x 180.");
    return;
  }
  this->FieldOfView[0] = horizontal;
  this->FieldOfView[1] = vertical;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkRelievoPanoramaCamera::GetCameraRay(
  double u, double v, double origin[3], double direction[3])
{
  const double columns = this->Size[0];
  const double rows = this->Size[1];
  const bool inside = u >= -0.5 && u <= columns - 0.5 && v >= -0.5 && v <= rows - 0.5;
  if (!inside || (this->Layout == CUBE && this->Size[0] != relievo::CubeFaces * this->Size[1]))
  {
    Nowhere(origin, 3);
    return Nowhere(direction, 3);
  }
  std::fill_n(origin, 3, 0.0);
  if (this->Layout == CUBE)
  {
    const int face = std::min(relievo::CubeFaces - 1, static_cast<int>((u + 0.5) / rows));
    const double a = 2.0 * ((u + 0.5) / rows - face) - 1.0;
    const double b = 2.0 * (v + 0.5) / rows - 1.0;
    for (int i = 0; i < 3; ++i)
    {
      direction[i] = a * relievo::CubeAxes[face][0][i] + b * relievo::CubeAxes[face][1][i] +
        relievo::CubeAxes[face][2][i];
    }
    vtkMath::Normalize(direction);
    return true;
  }
  const double azimuth =
    vtkMath::RadiansFromDegrees(((u + 0.5) / columns - 0.5) * this->FieldOfView[0]);
  const double elevation =
    vtkMath::RadiansFromDegrees((0.5 - (v + 0.5) / rows) * this->FieldOfView[1]);
  direction[0] = std::cos(elevation) * std::sin(azimuth);
  direction[1] = -std::sin(elevation);
  direction[2] = std::cos(elevation) * std::cos(azimuth);
  return true;
}

//------------------------------------------------------------------------------
bool vtkRelievoPanoramaCamera::ProjectCameraPoint(const double point[3], double pixel[2])
{
  const double columns = this->Size[0];
  const double rows = this->Size[1];
  const double distance = vtkMath::Norm(point);
  if (!(std::isfinite(distance) && distance > 0.0) ||
    (this->Layout == CUBE && this->Size[0] != relievo::CubeFaces * this->Size[1]))
  {
    return Nowhere(pixel, 2);
  }
  if (this->Layout == CUBE)
  {
    int face = 0;
    for (int i = 1; i < relievo::CubeFaces; ++i)
    {
      if (vtkMath::Dot(relievo::CubeAxes[i][2], point) >
        vtkMath::Dot(relievo::CubeAxes[face][2], point))
      {
        face = i;
      }
    }
    const double ahead = vtkMath::Dot(relievo::CubeAxes[face][2], point);
    pixel[0] =
      (face + 0.5 + 0.5 * vtkMath::Dot(relievo::CubeAxes[face][0], point) / ahead) * rows - 0.5;
    pixel[1] = (0.5 + 0.5 * vtkMath::Dot(relievo::CubeAxes[face][1], point) / ahead) * rows - 0.5;
    return true;
  }
  const double azimuth = vtkMath::DegreesFromRadians(std::atan2(point[0], point[2]));
  const double elevation =
    vtkMath::DegreesFromRadians(std::atan2(-point[1], std::hypot(point[0], point[2])));
  pixel[0] = (azimuth / this->FieldOfView[0] + 0.5) * columns - 0.5;
  pixel[1] = (0.5 - elevation / this->FieldOfView[1]) * rows - 0.5;
  return true;
}

//------------------------------------------------------------------------------
double vtkRelievoPanoramaCamera::GetColumnsOfTurn()
{
  return this->Layout == CUBE ? 0.0 : 360.0 / this->FieldOfView[0] * this->Size[0];
}

//------------------------------------------------------------------------------
double vtkRelievoPanoramaCamera::GetDepth(const double origin[3], const double point[3])
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(origin, point));
}

//------------------------------------------------------------------------------
void vtkRelievoPanoramaCamera::Copy(vtkRelievoCameraModel* other)
{
  this->Superclass::Copy(other);
  if (auto* same = vtkRelievoPanoramaCamera::SafeDownCast(other))
  {
    this->Layout = same->Layout;
    std::copy_n(same->FieldOfView, 2, this->FieldOfView);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoPanoramaCamera::AddTo(vtkFieldData* fields)
{
  this->Superclass::AddTo(fields);
  AddText(fields, "lens", this->Layout == CUBE ? "cube" : "equirectangular");
  if (this->Layout == EQUIRECTANGULAR)
  {
    AddNumbers(fields, "field_of_view", this->FieldOfView, 2);
  }
}

//------------------------------------------------------------------------------
void vtkRelievoPanoramaCamera::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layout: " << (this->Layout == CUBE ? "cube" : "equirectangular") << "\n";
  os << indent << "FieldOfView: " << this->FieldOfView[0] << " x " << this->FieldOfView[1] << "\n";
}
