// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The settings of vtkPVRelievoView. ParaView's domains guide its panel but let scripts and state
// files through: what is out of range is brought into it here, with a message.
#include "vtkPVRelievoView.h"

#include "vtkProcessModule.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoShadowPass.h"

#include <cmath>
#include <string>

namespace
{
// The nearest value within the range (not a number: the least), with a message if it is another.
template <typename T>
T Within(vtkObject* self, const char* property, T value, T least, T most)
{
  const T taken = value >= least ? (value <= most ? value : most) : least;
  auto* process = vtkProcessModule::GetProcessModule();
  // Of several processes that draw together, the first speaks.
  if (taken != value && (!process || process->GetPartitionId() == 0))
  {
    vtkWarningWithObjectMacro(self,
      "Relievo" << property << " was given " << value << ", expected " << least << " to " << most
                << ": " << taken << " is taken.");
  }
  return taken;
}
}

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
  const int most = vtkRelievoShadowPass::METHOD_WARPED;
  this->GetFrame()->GetShadowPass()->SetMethod(Within(this, "ShadowMethod", method, least, most));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowMapSize(int size)
{
  this->GetFrame()->GetShadowPass()->SetMapSize(Within(this, "ShadowMapSize", size, 16, 16384));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowFilterRadius(int radius)
{
  this->GetFrame()->GetShadowPass()->SetFilterRadius(
    Within(this, "ShadowFilterRadius", radius, 0, 16));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowBias(double bias)
{
  this->GetFrame()->GetShadowPass()->SetBias(Within(this, "ShadowBias", bias, 0.0, 100.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetShadowStrength(double strength)
{
  this->GetFrame()->GetShadowPass()->SetStrength(
    Within(this, "ShadowStrength", strength, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetLightKitCasts(int casts)
{
  const int least = KIT_CASTS_NOTHING;
  const int most = KIT_CASTS_ALL;
  this->LightKitCasts = Within(this, "LightKitCasts", casts, least, most);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunAzimuth(double degrees)
{
  // 370 is as good as 10; what has no direction is not.
  this->SunAzimuth =
    std::isfinite(degrees) ? degrees : Within(this, "SunAzimuth", degrees, 0.0, 360.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunElevation(double degrees)
{
  this->SunElevation = Within(this, "SunElevation", degrees, -90.0, 90.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunIntensity(double intensity)
{
  this->SunIntensity = Within(this, "SunIntensity", intensity, 0.0, 1000.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunColor(double red, double green, double blue)
{
  this->SunColor[0] = Within(this, "SunColor", red, 0.0, 1.0);
  this->SunColor[1] = Within(this, "SunColor", green, 0.0, 1.0);
  this->SunColor[2] = Within(this, "SunColor", blue, 0.0, 1.0);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunUpAxis(int axis)
{
  this->SunUpAxis = Within(this, "SunUpAxis", axis, 0, 2);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPVRelievoView::SetSunKitShare(double share)
{
  this->SunKitShare = Within(this, "SunKitShare", share, 0.0, 1.0);
  this->Modified();
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
