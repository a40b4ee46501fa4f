// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoLamps.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRelievoClamped.h"
#include "vtkRelievoLampsStage.h"

vtkStandardNewMacro(vtkPVRelievoLamps);

namespace
{
constexpr double Huge = 1e30;
}

//------------------------------------------------------------------------------
vtkRelievoPointValues* vtkPVRelievoLamps::GetValues()
{
  return this->Lamps;
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::Prepare(
  vtkPVView* view, vtkRelievoLampsStage* stage, vtkMultiProcessController* controller)
{
  std::vector<vtkRelievoLamps*> wanted;
  for (vtkPVRelievoPoints* each : FindIn(view))
  {
    if (auto* lamps = vtkPVRelievoLamps::SafeDownCast(each))
    {
      wanted.push_back(lamps->Lamps);
    }
  }
  bool same = stage->GetNumberOfPointSets() == static_cast<int>(wanted.size());
  for (std::size_t i = 0; same && i < wanted.size(); ++i)
  {
    same = stage->GetPoints(static_cast<int>(i)) == wanted[i];
  }
  if (!same)
  {
    stage->RemoveAllPoints();
    for (vtkRelievoLamps* lamps : wanted)
    {
      stage->AddPoints(lamps);
    }
  }
  stage->SetController(controller);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetRadius(double radius)
{
  this->Lamps->SetRadius(vtkPVRelievoClamped(this, "LampRadius", radius, 0.0, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetColor(double red, double green, double blue)
{
  this->Lamps->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetIntensity(double intensity)
{
  this->Lamps->SetIntensity(vtkPVRelievoClamped(this, "LampIntensity", intensity, -Huge, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetFalloff(int falloff)
{
  this->Lamps->SetFalloff(vtkPVRelievoClamped<int>(
    this, "LampFalloff", falloff, vtkRelievoLamps::LINEAR, vtkRelievoLamps::VTK));
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetCasts(int choice)
{
  this->Lamps->SetCasts(
    vtkPVRelievoClamped<int>(this, "LampCasts", choice, 0, 2) + vtkRelievoLamps::CASTS_IF_LARGE);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLamps::SetAttenuation(double constant, double linear, double quadratic)
{
  this->Lamps->SetAttenuationValues(constant, linear, quadratic);
}
