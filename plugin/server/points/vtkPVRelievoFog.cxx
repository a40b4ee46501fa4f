// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoFog.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRelievoClamped.h"
#include "vtkRelievoFogStage.h"

vtkStandardNewMacro(vtkPVRelievoFog);

namespace
{
constexpr double Huge = 1e30;
}

//------------------------------------------------------------------------------
vtkRelievoPointValues* vtkPVRelievoFog::GetValues()
{
  return this->Fog;
}

//------------------------------------------------------------------------------
void vtkPVRelievoFog::Prepare(
  vtkPVView* view, vtkRelievoFogStage* stage, vtkMultiProcessController* controller)
{
  std::vector<vtkRelievoFogSpheres*> wanted;
  for (vtkPVRelievoPoints* each : FindIn(view))
  {
    if (auto* fog = vtkPVRelievoFog::SafeDownCast(each))
    {
      wanted.push_back(fog->Fog);
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
    for (vtkRelievoFogSpheres* fog : wanted)
    {
      stage->AddPoints(fog);
    }
  }
  stage->SetController(controller);
}

//------------------------------------------------------------------------------
void vtkPVRelievoFog::SetRadius(double radius)
{
  this->Fog->SetRadius(vtkPVRelievoClamped(this, "FogRadius", radius, 0.0, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoFog::SetColor(double red, double green, double blue)
{
  this->Fog->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkPVRelievoFog::SetDensity(double density)
{
  this->Fog->SetDensity(vtkPVRelievoClamped(this, "FogDensity", density, 0.0, Huge));
}
