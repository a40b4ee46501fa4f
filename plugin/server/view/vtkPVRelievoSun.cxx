// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoSun.h"

#include "vtkLightCollection.h"
#include "vtkLightKit.h"
#include "vtkRelievoParameter.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace
{
// Directions and shares of the fill: most comes from the side opposite the sun, for surfaces facing
// away from it, the rest from both sides of it, for surfaces that face the sun in shadow; together
// they reach vertical walls of every direction. They are low, so that shadows on the ground stay
// dark.
struct FillPlace
{
  double Azimuth; // relative to the sun's
  double Elevation;
  double Part;
};
constexpr FillPlace FillPlaces[vtkPVRelievoSun::NumberOfFills] = { { 150.0, 20.0, 0.7 },
  { 45.0, 20.0, 0.3 }, { -60.0, 25.0, 0.3 } };

void ToWorld(double azimuth, double elevation, int upAxis, double direction[3])
{
  constexpr double Degree = 3.14159265358979323846 / 180.0;
  const double level = std::cos(Degree * elevation);
  const double east = level * std::sin(Degree * azimuth);
  const double north = level * std::cos(Degree * azimuth);
  const double up = std::sin(Degree * elevation);
  const double byUpAxis[3][3] = { { up, east, north }, { east, up, -north }, { east, north, up } };
  std::copy_n(byUpAxis[upAxis], 3, direction);
}
}

//------------------------------------------------------------------------------
vtkPVRelievoSun::vtkPVRelievoSun()
{
  for (vtkLight* light : this->GetLights())
  {
    light->SetLightTypeToSceneLight();
    light->PositionalOff();
    light->SetFocalPoint(0.0, 0.0, 0.0);
  }
  this->DescribePosition();
  this->Describe();
}

//------------------------------------------------------------------------------
void vtkPVRelievoSun::DescribePosition()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  vtkRelievoParameterList& list = this->Description;
  vtkRelievoParameter& by = list.AddChoice(
    "by", this->By, [this](int placing) { this->By = placing; }, { "angles", "date_and_place" },
    "Placement of the sun: by azimuth and elevation, or by date, time and place on Earth. The "
    "values of the other method stay, without effect.");
  by.Label = "Placed By";
  by.ChoiceLabels = { "Angles", "Date and place" };
  const auto setDate = [this](const int* date) {
    std::copy_n(date, 3, this->Date);
    this->Position->SetDate(date[0], date[1], date[2]);
  };
  setDate(this->Date);
  list
    .AddDate("date", this->Date, setDate, 1900, 2100,
      "Date of the clock. A day beyond the end of the month counts on into the next.")
    .OnlyIf = "by=date_and_place";
  const auto add = [this, &list](const char* name, double& value, double least, double most,
                     const char* unit, const char* help) -> vtkRelievoParameter& {
    const auto set = [this, &value](double given) {
      value = given;
      this->Position->SetHour(this->Time);
      this->Position->SetTimeZone(this->TimeZone);
      this->Position->SetLatitude(this->Latitude);
      this->Position->SetLongitude(this->Longitude);
    };
    set(value);
    return list.AddNumber(name, value, set, least, most, unit, help);
  };
  vtkRelievoParameter& azimuth = add("azimuth", this->Azimuth, -infinity, infinity, "degrees",
    "Direction of the sun from north, clockwise seen from above: 90 is east, 180 south. North is y "
    "with z up, -z with y up, z with x up, rotated by the property North.");
  azimuth.Usual = 360.0;
  azimuth.OnlyIf = "by=angles";
  add("elevation", this->Elevation, -90.0, 90.0, "degrees",
    "Elevation of the sun above the horizon. A sun below 0 lights from beneath.")
    .OnlyIf = "by=angles";
  add(
    "time", this->Time, 0.0, 24.0, "hours", "Clock time: 15.5 is half past three in the afternoon.")
    .OnlyIf = "by=date_and_place";
  add("time_zone", this->TimeZone, -12.0, 14.0, "hours",
    "How far the clock is ahead of universal time (UTC), summer time included.")
    .OnlyIf = "by=date_and_place";
  add("latitude", this->Latitude, -90.0, 90.0, "degrees", "North is positive.").OnlyIf =
    "by=date_and_place";
  add("longitude", this->Longitude, -180.0, 180.0, "degrees", "East is positive.").OnlyIf =
    "by=date_and_place";
  vtkRelievoParameter& north = add("north", this->North, -infinity, infinity, "degrees",
    "By how much the data's north is rotated, clockwise seen from above, from the axis that is "
    "north otherwise: y with z up, -z with y up, z with x up.");
  north.Usual = 360.0;
  north.Advanced = true;
}

//------------------------------------------------------------------------------
void vtkPVRelievoSun::Describe()
{
  vtkRelievoParameterList& list = this->Description;
  list.AddNumber(
    "fill", this->Fill, [this](double share) { this->Fill = share; }, 0.0, 1.0, "",
    "Fill light without shadows, from opposite the sun and from beside it, so that shaded sides "
    "show their form.");
  list.AddChoice(
    "up_axis", this->UpAxis, [this](int axis) { this->UpAxis = axis; }, { "x", "y", "z" },
    "The axis of the data that points up.");
  vtkRelievoParameter& intensity = list.AddNumber(
    "intensity", this->Intensity, [this](double factor) { this->Intensity = factor; }, 0.0, 1000.0,
    "", "Brightness of the sun; 1 lights a white surface that faces it fully.");
  intensity.Usual = 4.0;
  intensity.Advanced = true;
  list
    .AddColor(
      "color", this->Color, [this](const double* color) { std::copy_n(color, 3, this->Color); },
      "The sun's colour.")
    .Advanced = true;
  list
    .AddNumber(
      "kit_share", this->KitShare, [this](double share) { this->KitShare = share; }, 0.0, 1.0, "",
      "Share of the light kit's intensity that remains while the sun is on.")
    .Advanced = true;
}

//------------------------------------------------------------------------------
std::vector<vtkLight*> vtkPVRelievoSun::GetLights()
{
  std::vector<vtkLight*> lights{ this->Light };
  lights.insert(lights.end(), std::begin(this->Fills), std::end(this->Fills));
  return lights;
}

//------------------------------------------------------------------------------
void vtkPVRelievoSun::GetAngles(double angles[2])
{
  angles[0] = this->By == DATE_AND_PLACE ? this->Position->GetAzimuth() : this->Azimuth;
  angles[1] = this->By == DATE_AND_PLACE ? this->Position->GetElevation() : this->Elevation;
}

//------------------------------------------------------------------------------
bool vtkPVRelievoSun::IsNight()
{
  return this->By == DATE_AND_PLACE && this->Position->GetElevation() <= 0.0;
}

//------------------------------------------------------------------------------
void vtkPVRelievoSun::GetDirection(double direction[3])
{
  double angles[2];
  this->GetAngles(angles);
  ToWorld(angles[0] + this->North, angles[1], this->UpAxis, direction);
}

//------------------------------------------------------------------------------
void vtkPVRelievoSun::Point(vtkLight* light, double azimuth, double elevation)
{
  double direction[3];
  ToWorld(azimuth, elevation, this->UpAxis, direction);
  light->SetPosition(direction);
}

//------------------------------------------------------------------------------
void vtkPVRelievoSun::PlaceLast(vtkRenderer* renderer, const std::vector<vtkLight*>& wanted)
{
  // Rounding of a sum of lights depends on their order, which must not depend on the order of
  // adding.
  vtkLightCollection* lights = renderer->GetLights();
  const int others = lights->GetNumberOfItems() - static_cast<int>(wanted.size());
  int there = 0;
  for (vtkLight* light : this->GetLights())
  {
    there += lights->IsItemPresent(light) != 0 ? 1 : 0;
  }
  bool right = there == static_cast<int>(wanted.size());
  for (std::size_t i = 0; right && i < wanted.size(); ++i)
  {
    right = lights->GetItemAsObject(others + static_cast<int>(i)) == wanted[i];
  }
  if (right)
  {
    return;
  }
  for (vtkLight* light : this->GetLights())
  {
    renderer->RemoveLight(light);
  }
  for (vtkLight* light : wanted)
  {
    renderer->AddLight(light);
  }
}

//------------------------------------------------------------------------------
void vtkPVRelievoSun::Place(vtkRenderer* renderer, vtkLightKit* kit)
{
  if (kit->GetKeyLightIntensity() != this->DimmedIntensity)
  {
    this->KitIntensity = kit->GetKeyLightIntensity(); // changed by the user since
  }
  std::vector<vtkLight*> wanted;
  if (this->On)
  {
    wanted.push_back(this->Light);
  }
  if (this->On && this->Fill > 0.0)
  {
    wanted = this->GetLights();
  }
  this->PlaceLast(renderer, wanted);
  if (!this->On)
  {
    if (this->DimmedIntensity >= 0.0)
    {
      kit->SetKeyLightIntensity(this->KitIntensity);
      this->DimmedIntensity = -1.0;
    }
    return;
  }
  double angles[2];
  this->GetAngles(angles);
  const double azimuth = angles[0] + this->North;
  this->Point(this->Light, azimuth, angles[1]);
  // Dimmed, not switched off: without any light VTK draws surfaces unlit.
  this->Light->SetIntensity(this->IsNight() ? 0.0 : this->Intensity);
  this->Light->SetColor(this->Color);
  for (int i = 0; i < NumberOfFills; ++i)
  {
    this->Point(this->Fills[i], azimuth + FillPlaces[i].Azimuth, FillPlaces[i].Elevation);
    this->Fills[i]->SetIntensity(this->Fill * FillPlaces[i].Part);
  }
  this->DimmedIntensity = this->KitIntensity * this->KitShare;
  kit->SetKeyLightIntensity(this->DimmedIntensity);
}
