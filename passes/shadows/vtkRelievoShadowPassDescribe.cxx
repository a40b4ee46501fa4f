// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The pass's parameters, and what it needs and makes.
#include "vtkRelievoShadowInternals.h"

#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "shadows";
  description.Help = "Shadows of lights (suns, spots and points) and of lamps from data.";
  description.Slot = vtkRelievoStageDescription::LIGHT_MAPS;
  description.Writes = { "shadow maps", "visibility", "lamp shadows" };
  description.OnByDefault = true;
  description.AddFlag(
    "visible", this->Visible, [this](bool on) { this->SetVisible(on); },
    "Whether shadows are seen in the picture.");
  description.AddChoice(
    "method", this->Method, [this](int method) { this->SetMethod(method); },
    { "map", "forward", "warped", "exact" }, "How shadows are computed.");
  description.AddWhole(
    "map_size", this->MapSize, [this](int size) { this->SetMapSize(size); }, 16, 16384, "texels",
    "Width and height of each light's map.");
  description.AddWhole(
    "filter_radius", this->FilterRadius, [this](int radius) { this->SetFilterRadius(radius); }, 0,
    16, "texels", "How soft the edges of shadows are.");
  description.AddNumber(
    "bias", this->Bias, [this](double bias) { this->SetBias(bias); }, 0.0, 100.0, "texels",
    "Distance by which receivers are moved towards the light before the comparison.");
  description.AddNumber(
    "strength", this->Strength, [this](double strength) { this->SetStrength(strength); }, 0.0, 1.0,
    "", "Fraction of a blocked light that is removed.");
  description.AddFlag(
    "colored_shadows", this->ColoredShadows, [this](bool on) { this->SetColoredShadows(on); },
    "Exact shadows: translucent surfaces cast, and colour the light that passes them.");
  description.AddNumber(
    "tolerance", this->Tolerance, [this](double share) { this->SetTolerance(share); }, 0.0, 1.0, "",
    "Share of wrong pixels that method and map size are chosen for; 0: as they are set.");
  description.AddNumber(
    "time_budget", this->TimeBudget, [this](double time) { this->SetTimeBudget(time); }, 0.0,
    3600000.0, "ms", "Time of a frame that method and map size are chosen for; 0: any.");
  description.AddWhole(
    "lamp_map_size", this->LampMapSize, [this](int size) { this->SetLampMapSize(size); }, 16, 16384,
    "texels", "Width and height of each map of a lamp from data; a lamp has up to six.");
  this->DescribeSoft(description);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  // The visibility is for layers, and lamps are lit by their own stage, whether shadows of lights
  // are seen or not.
  declaration.Offers.clear();
  if (this->Visible)
  {
    declaration.Offers.emplace_back("shadow maps");
  }
  declaration.Words = this->Visible ? "" : "shadows are off";
  this->DeclareSoft(context, declaration);
}

//------------------------------------------------------------------------------
void vtkRelievoShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Visible: " << this->Visible << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MapSize: " << this->MapSize << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "LampMapSize: " << this->LampMapSize << "\n";
  os << indent << "FilterRadius: " << this->FilterRadius << "\n";
  os << indent << "Bias: " << this->Bias << "\n";
  os << indent << "Strength: " << this->Strength << "\n";
  os << indent << "ColoredShadows: " << this->ColoredShadows << "\n";
  os << indent << "SoftSamples: " << this->SoftSamples << "\n";
  os << indent << "SoftAtOnce: " << this->SoftAtOnce << "\n";
  os << indent << "SunAngle: " << this->SunAngle << "\n";
  os << indent << "LampRadius: " << this->LampRadius << "\n";
  os << indent << "Casting lights: " << this->GetNumberOfCastingLights() << "\n";
  os << indent << "Maps: " << this->GetNumberOfMaps() << "\n";
}
