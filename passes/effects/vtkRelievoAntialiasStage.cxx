// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoAntialiasStage.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkRelievoFrameContext.h"
#include "vtkRelievoFramePlan.h"
#include "vtkRelievoSampleLattice.h"

#include <string>

vtkStandardNewMacro(vtkRelievoAntialiasStage);

namespace
{
// ParaView's servers composite the ranks' pictures behind their own passes.
bool IsPartOfPicture(const vtkRelievoFrameContext& context)
{
  vtkMultiProcessController* all = vtkMultiProcessController::GetGlobalController();
  return context.Nested && all && all->GetNumberOfProcesses() > 1;
}
}

//------------------------------------------------------------------------------
vtkRelievoAntialiasStage::vtkRelievoAntialiasStage() = default;

//------------------------------------------------------------------------------
vtkRelievoAntialiasStage::~vtkRelievoAntialiasStage() = default;

//------------------------------------------------------------------------------
void vtkRelievoAntialiasStage::Describe(vtkRelievoStageDescription& description)
{
  description.Name = "antialias";
  description.Label = "Smooth Edges";
  description.Help = "Smooths edges: the picture is the mean of samples spread over each pixel.";
  description.Slot = vtkRelievoStageDescription::COMPOSITE;
  description.Order = 100; // after all stages that change a sample
  description.Reads = { vtkRelievoResources::Color };
  description.Writes = { vtkRelievoResources::Color };
  description.AddWhole(
    "samples", this->Samples, [this](int samples) { this->SetSamples(samples); }, 1, 256, "samples",
    "Samples per pixel. While nothing changes, each frame adds one.");
}

//------------------------------------------------------------------------------
void vtkRelievoAntialiasStage::Declare(
  const vtkRelievoFrameContext& context, vtkRelievoDeclaration& declaration) const
{
  if (this->Samples == 1)
  {
    declaration.Reason = "one sample per pixel (Samples) smooths nothing";
  }
  else if (!context.Picture || !context.ReadBack.empty())
  {
    declaration.Reason = "layers are asked for, and layers have one sample, at each pixel's centre";
  }
  else if (IsPartOfPicture(context))
  {
    declaration.Reason = "several processes draw the picture together, and compare one depth per "
                         "pixel";
  }
  else
  {
    declaration.Samples = this->Samples;
    declaration.OffsetsSamples = true;
    declaration.AnyRaster = true;
    return;
  }
  declaration.Runs = false;
  declaration.ReasonCode = "idle";
}

//------------------------------------------------------------------------------
void vtkRelievoAntialiasStage::Execute(vtkRelievoFrameContext& context)
{
  this->Explain("ran",
    context.MeanLattice ? "smooths edges, " + context.MeanWords
                        : "smooths edges, " + std::to_string(context.Sample + 1) + " of " +
        std::to_string(context.Samples) + " samples" +
        (context.Obstacle.empty() ? "" : ", one by one: " + context.Obstacle));
}

//------------------------------------------------------------------------------
void vtkRelievoAntialiasStage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Samples: " << this->Samples << "\n";
}
