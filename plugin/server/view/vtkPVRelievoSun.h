// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sun of a view: where it stands, the light that it is, what fills the sides that it does not
// reach, and the light kit dimmed for it.
#ifndef vtkPVRelievoSun_h
#define vtkPVRelievoSun_h

#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRelievoParameterList.h"
#include "vtkRelievoSolarPosition.h"

#include <vector>

class vtkLightKit;
class vtkRenderer;

class vtkPVRelievoSun
{
public:
  vtkPVRelievoSun();
  vtkPVRelievoSun(const vtkPVRelievoSun&) = delete;
  void operator=(const vtkPVRelievoSun&) = delete;

  bool On = false;
  bool ByDateAndPlace = false; // by Position, else by Azimuth and Elevation
  vtkNew<vtkRelievoSolarPosition> Position;

  // The other settings.
  const vtkRelievoParameterList& GetDescription() const { return this->Description; }

  static constexpr int NumberOfFills = 3;
  vtkNew<vtkLight> Light;
  vtkNew<vtkLight> Fills[NumberOfFills];

  // Azimuth and elevation, however it is placed.
  void GetAngles(double angles[2]);

  // By date and place it is below the horizon: it gives no light, and its fill is what is left.
  bool IsNight();

  // Towards the sun in the world, of unit length.
  void GetDirection(double direction[3]);

  // Before each picture: lights and kit as the settings say. Off, the kit is given back.
  void Place(vtkRenderer* renderer, vtkLightKit* kit);

private:
  void Describe();
  void DescribePosition();

  // The sun's own and its fills.
  std::vector<vtkLight*> GetLights();

  void Point(vtkLight* light, double azimuth, double elevation);

  // Of the sun's lights the wanted ones are the renderer's last, in that order.
  void PlaceLast(vtkRenderer* renderer, const std::vector<vtkLight*>& wanted);

  vtkRelievoParameterList Description;
  double Azimuth = 150.0;
  double Elevation = 45.0;
  double Time = 15.0;
  double TimeZone = 0.0;
  double Latitude = 48.0;
  double Longitude = 0.0;
  double North = 0.0; // degrees by which the data's north is turned, clockwise seen from above
  int UpAxis = 2;
  double Intensity = 0.7;
  double Color[3] = { 1.0, 1.0, 1.0 };
  double KitShare = 0.3;
  double Fill = 0.3;
  double KitIntensity = -1.0;    // the user's, of the kit's key light
  double DimmedIntensity = -1.0; // what it was set to because of the sun
};

#endif
