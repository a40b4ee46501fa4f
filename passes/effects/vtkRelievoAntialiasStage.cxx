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
// ParaView's servers put the ranks' pictures together behind their own passes.
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
  if (this->Samples == 1)
  {
    declaration.Reason = "one sample of each pixel (Samples) smooths nothing";
  }
  else if (!context.Picture || !context.ReadBack.empty())
  {
    declaration.Reason = "layers are asked for, which have one sample, at the centre of each pixel";
  }
  else if (IsPartOfPicture(context))
  {
    declaration.Reason = "several processes draw the picture together, which compare one depth in "
                         "each pixel";
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
