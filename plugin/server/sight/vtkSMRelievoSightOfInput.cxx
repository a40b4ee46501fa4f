// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMRelievoSightOfInput.h"

#include "vtkBoundingBox.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkSMOutputPort.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <cmath>

namespace
{
// Above the terrain, that of a person's eyes and a little more, as viewsheds are usually computed.
constexpr double ObserverHeight = 2.0;
}

vtkStandardNewMacro(vtkSMRelievoSightOfInput);

//------------------------------------------------------------------------------
void vtkSMRelievoSightOfInput::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType initializationTimeStamp)
{
  vtkSMOutputPort* input = vtkSMPropertyHelper(proxy, "Input", true).GetAsOutputPort();
  const vtkBoundingBox box(input ? input->GetDataInformation()->GetBounds() : nullptr);
  if (!box.IsValid())
  {
    return;
  }
  double place[3];
  box.GetCenter(place);
  const auto set = [&](const char* name) {
    vtkSMProperty* property = proxy->GetProperty(name);
    if (property && property->GetMTime() <= initializationTimeStamp)
    {
      vtkSMPropertyHelper(property).Set(place, 3);
    }
  };
  set("FocalPoint");
  const double angle = vtkSMPropertyHelper(proxy, "ViewAngle", true).GetAsDouble();
  const double radius = 0.5 * box.GetDiagonalLength();
  const double away = radius / std::sin(0.5 * vtkMath::RadiansFromDegrees(angle));
  place[2] += std::isfinite(away) && away > 0.0 ? away : 1.0;
  set("Position");
  place[2] = ObserverHeight;
  set("Observers");
  proxy->UpdateVTKObjects();
}
