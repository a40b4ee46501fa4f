// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The settings of vtkPVRelievoView.
#include "vtkPVRelievoView.h"

#include "vtkPVRelievoEnvironment.h"
#include "vtkPVRelievoSelection.h"
#include "vtkPVRelievoSun.h"
#include "vtkPVRelievoWithin.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShadowPass.h"

#include <cmath>
#include <string>

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadows(bool on)
{
  this->GetFrame()->SetShadows(on);
}

//------------------------------------------------------------------------------
bool vtkPVRelievoView::GetShadows()
{
  return this->GetFrame()->GetShadows();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowMethod(int method)
{
  const int least = vtkRelievoShadowPass::METHOD_MAP;
  const int most = vtkRelievoShadowPass::METHOD_EXACT;
  this->GetFrame()->GetShadowPass()->SetMethod(
    vtkPVRelievoWithin(this, "ShadowMethod", method, least, most));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowMapSize(int size)
{
  this->GetFrame()->GetShadowPass()->SetMapSize(
    vtkPVRelievoWithin(this, "ShadowMapSize", size, 16, 16384));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowLampMapSize(int size)
{
  this->GetFrame()->GetShadowPass()->SetLampMapSize(
    vtkPVRelievoWithin(this, "ShadowLampMapSize", size, 16, 16384));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowTolerance(double share)
{
  this->GetFrame()->GetShadowPass()->SetTolerance(
    vtkPVRelievoWithin(this, "ShadowTolerance", share, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowTimeBudget(double milliseconds)
{
  this->GetFrame()->GetShadowPass()->SetTimeBudget(
    vtkPVRelievoWithin(this, "ShadowTimeBudget", milliseconds, 0.0, 3600000.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowFilterRadius(int radius)
{
  this->GetFrame()->GetShadowPass()->SetFilterRadius(
    vtkPVRelievoWithin(this, "ShadowFilterRadius", radius, 0, 16));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowBias(double bias)
{
  this->GetFrame()->GetShadowPass()->SetBias(
    vtkPVRelievoWithin(this, "ShadowBias", bias, 0.0, 100.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowStrength(double strength)
{
  this->GetFrame()->GetShadowPass()->SetStrength(
    vtkPVRelievoWithin(this, "ShadowStrength", strength, 0.0, 1.0));
}

//------------------------------------------------------------------------------
int vtkPVRelievoView::GetSamplesLeft()
{
  return this->IsInPlace() ? this->GetFrame()->GetSamplesLeft() : 0;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetLightKitCasts(int casts)
{
  const int least = KIT_CASTS_NOTHING;
  const int most = KIT_CASTS_ALL;
  this->LightKitCasts = vtkPVRelievoWithin(this, "LightKitCasts", casts, least, most);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSun(bool on)
{
  this->GetSunlight().On = on;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunBy(int placing)
{
  this->GetSunlight().ByDateAndPlace = vtkPVRelievoWithin(this, "SunBy", placing, 0, 1) != 0;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunAzimuth(double degrees)
{
  // 370 is as good as 10; what has no direction is not.
  this->GetSunlight().Azimuth =
    std::isfinite(degrees) ? degrees : vtkPVRelievoWithin(this, "SunAzimuth", degrees, 0.0, 360.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunElevation(double degrees)
{
  this->GetSunlight().Elevation = vtkPVRelievoWithin(this, "SunElevation", degrees, -90.0, 90.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunDate(int year, int month, int day)
{
  this->GetSunlight().Position->SetDate(vtkPVRelievoWithin(this, "SunDate", year, 1900, 2100),
    vtkPVRelievoWithin(this, "SunDate", month, 1, 12),
    vtkPVRelievoWithin(this, "SunDate", day, 1, 31));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunTime(double hour)
{
  this->GetSunlight().Position->SetHour(vtkPVRelievoWithin(this, "SunTime", hour, 0.0, 24.0));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunTimeZone(double hours)
{
  this->GetSunlight().Position->SetTimeZone(
    vtkPVRelievoWithin(this, "SunTimeZone", hours, -12.0, 14.0));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunLatitude(double degrees)
{
  this->GetSunlight().Position->SetLatitude(
    vtkPVRelievoWithin(this, "SunLatitude", degrees, -90.0, 90.0));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunLongitude(double degrees)
{
  this->GetSunlight().Position->SetLongitude(
    vtkPVRelievoWithin(this, "SunLongitude", degrees, -180.0, 180.0));
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunNorth(double degrees)
{
  // 370 is as good as 10; what has no direction is not.
  this->GetSunlight().North =
    std::isfinite(degrees) ? degrees : vtkPVRelievoWithin(this, "SunNorth", degrees, 0.0, 360.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunUpAxis(int axis)
{
  this->GetSunlight().UpAxis = vtkPVRelievoWithin(this, "SunUpAxis", axis, 0, 2);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunIntensity(double intensity)
{
  this->GetSunlight().Intensity = vtkPVRelievoWithin(this, "SunIntensity", intensity, 0.0, 1000.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunColor(double red, double green, double blue)
{
  this->GetSunlight().Color[0] = vtkPVRelievoWithin(this, "SunColor", red, 0.0, 1.0);
  this->GetSunlight().Color[1] = vtkPVRelievoWithin(this, "SunColor", green, 0.0, 1.0);
  this->GetSunlight().Color[2] = vtkPVRelievoWithin(this, "SunColor", blue, 0.0, 1.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunKitShare(double share)
{
  this->GetSunlight().KitShare = vtkPVRelievoWithin(this, "SunKitShare", share, 0.0, 1.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunFill(double intensity)
{
  this->GetSunlight().Fill = vtkPVRelievoWithin(this, "SunFill", intensity, 0.0, 1.0);
  this->Modified();
}

//------------------------------------------------------------------------------
double* vtkPVRelievoView::GetSunAngles()
{
  this->GetSunlight().GetAngles(this->SunAngles);
  return this->SunAngles;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetEnvironment(const char* file)
{
  this->GetSurroundings().SetFile(file);
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetEnvironmentRotation(double degrees)
{
  // As with the sun's azimuth, 370 is as good as 10.
  this->GetSurroundings().Environment->SetRotation(std::isfinite(degrees)
      ? degrees
      : vtkPVRelievoWithin(this, "EnvironmentRotation", degrees, 0.0, 360.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetEnvironmentIntensity(double factor)
{
  this->GetSurroundings().Environment->SetIntensity(
    vtkPVRelievoWithin(this, "EnvironmentIntensity", factor, 0.0, 1000.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetEnvironmentUp(int axis)
{
  this->GetSurroundings().Environment->SetUpAxis(
    vtkPVRelievoWithin(this, "EnvironmentUp", axis, 0, 2));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetEnvironmentGammaCorrect(bool on)
{
  this->GetSurroundings().Environment->SetGammaCorrect(on);
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSkybox(bool on)
{
  this->GetSurroundings().Sky = on;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetMarkSelection(bool on)
{
  this->GetSelection().On = on;
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetMarkSelectionShape(int shape)
{
  const int first = vtkRelievoMarkers::RING;
  const int last = vtkRelievoMarkers::DISC;
  this->GetSelection().Look->SetShape(
    vtkPVRelievoWithin(this, "MarkSelectionShape", shape, first, last));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetMarkSelectionRadius(double radius)
{
  this->GetSelection().Look->SetRadius(
    vtkPVRelievoWithin(this, "MarkSelectionRadius", radius, 0.0, 1e30));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetMarkSelectionWidth(double width)
{
  this->GetSelection().Look->SetWidth(
    vtkPVRelievoWithin(this, "MarkSelectionWidth", width, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetMarkSelectionOpacity(double opacity)
{
  this->GetSelection().Look->SetOpacity(
    vtkPVRelievoWithin(this, "MarkSelectionOpacity", opacity, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetMarkSelectionColor(double red, double green, double blue)
{
  this->GetSelection().Look->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetDisplayLayer(const char* name)
{
  // The panel's word for the picture itself.
  const bool picture = !name || !*name || std::string(name) == "None";
  this->GetFrame()->SetDisplayLayer(picture ? nullptr : name);
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetDisplayRange(double first, double last)
{
  this->GetFrame()->SetDisplayRange(first, last);
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetDisplayGrey(bool on)
{
  this->GetFrame()->SetDisplayGrey(on);
}
