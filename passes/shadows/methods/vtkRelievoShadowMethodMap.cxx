// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowMethodMap.h"

#include "vtkRelievoShadowMaps.h"

//------------------------------------------------------------------------------
vtkRelievoShadowEstimate vtkRelievoShadowMethodMap::Estimate(
  const vtkRelievoShadowDemand& demand) const
{
  vtkRelievoShadowEstimate estimate;
  estimate.Bytes = vtkRelievoShadowMaps::GetBytes(demand.MapSize, demand.Maps);
  estimate.DrawCalls = demand.Maps * demand.Props;
  estimate.WrongShare = vtkRelievoShadowMapLaw.GetShare(demand.MapSize);
  return estimate;
}
