// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the pass draws before the picture: the maps of the renderer's lights, and of lamps.
#include "vtkRelievoShadowInternals.h"

#include "vtkRelievoFrameContext.h"

#include <iomanip>
#include <sstream>

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::CollectLights(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Lights.Collect(context.Renderer, vtkRelievoShadowMaps::GetMostFaces());
  if (in.Schedule.Exchange.IsOn())
  {
    in.Lights.KeepOnly(in.Schedule.Exchange.FindCommon(in.Lights.GetNumbers()));
  }
  in.Samples = context.Samples;
  in.Gathered = context.Sample + 1;
  if (context.Samples > 1)
  {
    in.Lights.Move(in.Sizes, context.Sample, context.Samples);
  }
  for (const vtkRelievoShadowLight& light : in.Lights.GetAll())
  {
    if (light.Broken && in.Said.insert(std::to_string(light.Number) + light.NoShadow).second)
    {
      vtkWarningMacro(<< in.Lights.GetName(light) << " casts no shadow: " << light.NoShadow << ".");
    }
  }
}

//------------------------------------------------------------------------------
int vtkRelievoShadowPass::GetSizeHere(int size)
{
  const int largest = vtkRelievoShadowMaps::GetLargestSize();
  if (size > largest && this->Internal->Said.insert("size" + std::to_string(size)).second)
  {
    vtkWarningMacro("Shadow maps of "
      << size << " x " << size << " texels were asked for, this OpenGL makes at most " << largest
      << " x " << largest << ": these are used.");
  }
  return std::min(size, largest);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::DrawLights(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  vtkRelievoShadowWork& work = in.Work;
  const int mapDraws = in.Schedule.Draw(work, context.Renderer);
  this->NumberOfMapsDrawn = work.MapsDrawn;
  work.Maps.Bind(true);
  in.Strengths.Set(work, this->Visible ? this->Strength : 0.0);
  context.Provide("shadow maps", &in.Strengths);
  in.Told.clear();
  const int methodDraws = in.Method->Draw(work, context.Renderer);
  in.Told.clear();
  this->DrawCalls += mapDraws + methodDraws; // mappers that draw by themselves counted theirs
  if (!in.Method->GetFault().empty())
  {
    this->SayOnce("Shadows are looked up in the maps alone: " + in.Method->GetFault());
  }
}

//------------------------------------------------------------------------------
// Returns what was done, in words.
std::string vtkRelievoShadowPass::DrawLamps(vtkRelievoFrameContext& context)
{
  Internals& in = *this->Internal;
  in.Lamps.Work.Bias = this->Bias;
  const std::string fault = in.Lamps.Draw(
    context, this->GetSizeHere(this->LampMapSize), this->FilterRadius, this->Strength);
  if (!fault.empty())
  {
    this->SayOnce("No shadows of lamps: " + fault);
    in.Lamps.Release(context.Window);
    return "no shadows of lamps: " + fault;
  }
  this->DrawCalls += in.Lamps.GetDrawCalls();
  context.Provide("lamp shadows", &in.Lamps);
  return in.Lamps.GetReport();
}

//------------------------------------------------------------------------------
std::string vtkRelievoShadowPass::DescribeMaps() const
{
  const Internals& in = *this->Internal;
  const auto& casting = in.Lights.GetCasting();
  std::ostringstream out;
  out << casting.size() << (casting.size() == 1 ? " light casts" : " lights cast");
  for (const vtkRelievoShadowLight& light : casting)
  {
    out << (&light == casting.data() ? " (" : ", ") << in.Lights.GetName(light);
  }
  out << "), " << in.Work.Cache.GetNumberOfMaps()
      << (in.Work.Cache.GetNumberOfMaps() == 1 ? " map of " : " maps of ") << in.Work.Maps.GetSize()
      << " x " << in.Work.Maps.GetSize() << " texels, " << this->NumberOfMapsDrawn
      << " drawn anew, expected share of wrong pixels " << std::setprecision(2)
      << 100.0 * this->GetExpectedWrongShare() << " %" << std::setprecision(6)
      << (in.Planned ? ", " + in.Plan.Words : std::string()) << in.Method->GetReport()
      << in.Work.Others.GetReport() << this->DescribeSamples() << in.Schedule.Exchange.GetReport()
      << in.Lights.GetReport();
  return out.str();
}
