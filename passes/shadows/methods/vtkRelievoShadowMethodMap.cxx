// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoShadowMethodMap.h"

#include "vtkRelievoShadowMaps.h"

namespace
{
// Least squares, in logarithms, of docs/charts/shadows.csv: bunny, motorBike and buildings, all
// lights and sizes, 600 x 600 pixels. Each value there is within 2.5 times (testShadowEstimate).
constexpr vtkRelievoShadowErrorLaw MapLaw = { 1.92e-4, 0.91 };
}

//------------------------------------------------------------------------------
vtkRelievoShadowEstimate vtkRelievoShadowMethodMap::Estimate(
  const vtkRelievoShadowDemand& demand) const
{
  vtkRelievoShadowEstimate estimate;
  estimate.Bytes = vtkRelievoShadowMaps::GetBytes(demand.MapSize, demand.Maps);
  estimate.DrawCalls = demand.Maps * demand.Props;
  estimate.WrongShare = MapLaw.GetShare(demand.MapSize);
  return estimate;
}
