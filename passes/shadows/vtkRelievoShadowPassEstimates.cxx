// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the pass says that shadows will cost and err.
#include "vtkRelievoShadowInternals.h"

#include "vtkRelievoShadowMethodExact.h"

#include <algorithm>

namespace
{
bool IsPossible(int method, const vtkRelievoShadowDemand& demand)
{
  return method >= vtkRelievoShadowPass::METHOD_MAP &&
    method <= vtkRelievoShadowPass::METHOD_EXACT &&
    std::min({ demand.MapSize - 1, demand.Maps, demand.Lights, demand.Props, demand.Width,
      demand.Height }) >= 0;
}
}

//------------------------------------------------------------------------------
vtkIdType vtkRelievoShadowPass::EstimateBytes(
  int method, int size, int maps, int lights, int width, int height)
{
  vtkRelievoShadowDemand demand;
  demand.MapSize = size;
  demand.Maps = maps;
  demand.Lights = lights;
  demand.Width = width;
  demand.Height = height;
  if (!IsPossible(method, demand))
  {
    vtkErrorMacro("EstimateBytes was given method "
      << method << ", size " << size << ", " << maps << " maps, " << lights << " lights, " << width
      << " x " << height
      << " pixels; give it a method from 0 (map) to 3 (exact), a size from 1 on, "
      << "and no negative numbers.");
    return -1;
  }
  return vtkRelievoShadowMethod::Make(method)->Estimate(demand).Bytes;
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::EstimateDrawCalls(int method, int maps, int props)
{
  vtkRelievoShadowDemand demand;
  demand.Maps = maps;
  demand.Props = props;
  if (!IsPossible(method, demand))
  {
    vtkErrorMacro("EstimateDrawCalls was given method "
      << method << ", " << maps << " maps and " << props << " props; give it a method from 0 (map) "
      << "to 3 (exact), and no negative numbers.");
    return -1;
  }
  return vtkRelievoShadowMethod::Make(method)->Estimate(demand).DrawCalls;
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPass::EstimateWrongShare(int method, int size)
{
  vtkRelievoShadowDemand demand;
  demand.MapSize = size;
  if (!IsPossible(method, demand))
  {
    vtkErrorMacro("EstimateWrongShare was given method "
      << method << " and size " << size << "; give it a method from 0 (map) to 3 (exact), and a "
      << "size from 1 on.");
    return -1.0;
  }
  return vtkRelievoShadowMethod::Make(method)->Estimate(demand).WrongShare;
}

//------------------------------------------------------------------------------
double vtkRelievoShadowPass::GetExpectedWrongShare() const
{
  if (this->Internal->Planned && this->Internal->Plan.Chosen.Method == this->Internal->MethodMade)
  {
    return this->Internal->Plan.Chosen.WrongShare;
  }
  vtkRelievoShadowDemand demand;
  demand.MapSize = this->Internal->Work.Maps.GetSize();
  demand.Farness = vtkRelievoShadowMethodExact::GetFarness(this->Internal->Work);
  return this->Internal->Method->Estimate(demand).WrongShare;
}

//------------------------------------------------------------------------------
std::map<std::string, vtkVariant> vtkRelievoShadowPass::GetFacts()
{
  const Internals& in = *this->Internal;
  const vtkRelievoShadowWork& lamps = in.Lamps.Work;
  const bool ran = this->GetReasonCode() == "ran" && !in.Lights.GetCasting().empty();
  return { { "expected_wrong_share",
             ran ? vtkVariant(this->GetExpectedWrongShare()) : vtkVariant() },
    { "soft_samples", vtkVariant(ran ? in.Samples : 1) },
    { "soft_gathered", vtkVariant(ran ? in.Gathered : 1) },
    { "shadow_plan", in.Planned ? vtkVariant(in.Plan.Words) : vtkVariant() },
    { "expected_frame_ms", in.Planned ? vtkVariant(in.Plan.Milliseconds) : vtkVariant() },
    { "frame_ms", in.Planned && in.Took >= 0.0 ? vtkVariant(in.Took) : vtkVariant() },
    { "lamp_maps", vtkVariant(lamps.Cache.GetNumberOfMaps()) },
    { "lamp_maps_drawn", vtkVariant(lamps.MapsDrawn) },
    { "lamp_maps_bytes", vtkVariant(static_cast<long long>(lamps.Maps.GetBytes())) } };
}
