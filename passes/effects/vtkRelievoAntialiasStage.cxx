// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoAntialiasStage.h"

#include "vtkObjectFactory.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"

#include <string>

vtkStandardNewMacro(vtkRelievoAntialiasStage);

//------------------------------------------------------------------------------
vtkRelievoAntialiasStage::vtkRelievoAntialiasStage() = default;

//------------------------------------------------------------------------------
vtkRelievoAntialiasStage::~vtkRelievoAntialiasStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoAntialiasStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "antialias";
  description.Help = "Smooths edges: the picture is the mean of samples spread over each pixel.";
  description.Slot = vtkRelievoStageDescription::COMPOSITE;
  description.Order = 100; // behind all that changes what one sample shows
  description.Reads = { "color" };
  description.Writes = { "color" };
  description.AddWhole(
    "samples", this->Samples, [this](int samples) { this->SetSamples(samples); }, 1, 256, "samples",
    "Samples of each pixel, one more in each frame in which nothing changes.");
}

//------------------------------------------------------------------------------
void vtkRelievoAntialiasStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  declaration.Runs = this->Samples > 1 && context.Picture && context.ReadBack.empty();
  if (!declaration.Runs)
  {
    declaration.ReasonCode = "idle";
    declaration.Reason = this->Samples > 1
      ? "layers are asked for, which have one sample, at the centre of each pixel"
      : "one sample of each pixel (Samples) smooths nothing";
  }
  declaration.Samples = this->Samples;
  declaration.OffsetsSamples = true;
}

//------------------------------------------------------------------------------
void vtkRelievoAntialiasStage::Execute(vtkRelievoFrameContext& context)
{
  this->Explain("ran",
    "smooths edges, " + std::to_string(context.Sample + 1) + " of " +
      std::to_string(context.Samples) + " samples");
}

//------------------------------------------------------------------------------
void vtkRelievoAntialiasStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Samples: " << this->Samples << "\n";
}
