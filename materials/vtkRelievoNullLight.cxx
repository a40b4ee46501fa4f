// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoNullLight.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

//------------------------------------------------------------------------------
vtkRelievoNullLight::vtkRelievoNullLight()
{
  this->Light->SetLightTypeToHeadlight();
  this->Light->SetIntensity(0.0);
}

//------------------------------------------------------------------------------
vtkRelievoNullLight::~vtkRelievoNullLight() = default;

//------------------------------------------------------------------------------
void vtkRelievoNullLight::Place(vtkRenderer* renderer, bool wanted)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    wanted = wanted && (light == this->Light || !light->GetSwitch());
  }
  const bool there = lights->IsItemPresent(this->Light) != 0;
  if (wanted && !there)
  {
    renderer->AddLight(this->Light);
  }
  else if (!wanted && there)
  {
    renderer->RemoveLight(this->Light);
  }
}
