// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sun of a view: its position, its light, its fill lights, and the dimming of the light kit.
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

  enum Placing
  {
    ANGLES = 0,
    DATE_AND_PLACE = 1
  };

  bool On = false;
  int By = ANGLES; // the kind of placement
  vtkNew<vtkRelievoSolarPosition> Position;

  // The other settings.
  const vtkRelievoParameterList& GetDescription() const { return this->Description; }

  static constexpr int NumberOfFills = 3;
  vtkNew<vtkLight> Light;
  vtkNew<vtkLight> Fills[NumberOfFills];

  // Azimuth and elevation, for either kind of placement.
  void GetAngles(double angles[2]);

  // Whether a sun by date and place is below the horizon: it gives no light, only its fill remains.
  bool IsNight();

  // Unit direction towards the sun in the world.
  void GetDirection(double direction[3]);

  // Before each picture: applies the settings to the lights and the kit. Switched off, restores the
  // kit.
  void Place(vtkRenderer* renderer, vtkLightKit* kit);

private:
  void Describe();
  void DescribePosition();

  // The sun's own light and its fill lights.
  std::vector<vtkLight*> GetLights();

  void Point(vtkLight* light, double azimuth, double elevation);

  // Moves the wanted lights of the sun to the end of the renderer's list, in this order.
  void PlaceLast(vtkRenderer* renderer, const std::vector<vtkLight*>& wanted);

  vtkRelievoParameterList Description;
  int Date[3] = { 2026, 6, 21 };
  double Azimuth = 150.0;
  double Elevation = 45.0;
  double Time = 15.0;
  double TimeZone = 0.0;
  double Latitude = 48.0;
  double Longitude = 0.0;
  double North = 0.0; // clockwise rotation of the data's north seen from above, degrees
  int UpAxis = 2;
  double Intensity = 0.7;
  double Color[3] = { 1.0, 1.0, 1.0 };
  double KitShare = 0.3;
  double Fill = 0.3;
  double KitIntensity = -1.0;    // the user's key light intensity
  double DimmedIntensity = -1.0; // the intensity set because of the sun
};

#endif
