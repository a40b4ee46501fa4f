// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoLayerLegend.h"

#include "vtkRelievoColormaps.h"
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoFramePass.h"
#include "vtkRelievoLayerCatalogue.h"

#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <cmath>
#include <string>

vtkStandardNewMacro(vtkRelievoLayerLegend);

//------------------------------------------------------------------------------
vtkRelievoLayerLegend::vtkRelievoLayerLegend()
{
  this->SetLookupTable(this->Colors);
  this->BackdropOn();
}

//------------------------------------------------------------------------------
vtkRelievoLayerLegend::~vtkRelievoLayerLegend() = default;

//------------------------------------------------------------------------------
bool vtkRelievoLayerLegend::Follow(vtkRelievoDisplayStage* stage, bool isDrawnHere)
{
  this->IsGiven = true;
  return this->Take(stage, isDrawnHere);
}

//------------------------------------------------------------------------------
bool vtkRelievoLayerLegend::Take(vtkRelievoDisplayStage* stage, bool isDrawnHere)
{
  if (!stage || stage->GetLayer().empty())
  {
    return false;
  }
  const bool given = stage->GetRange()[0] < stage->GetRange()[1];
  const double* range = given ? stage->GetRange() : stage->GetShownRange();
  const bool known = given || (isDrawnHere && stage->GetReasonCode() == "ran");
  if (!known || !stage->HasScale() || !std::isfinite(range[0]))
  {
    return false;
  }
  const bool reversed = stage->GetShownReversed();
  this->Colors->RemoveAllPoints();
  vtkRelievoColormaps::Fill(
    this->Colors, stage->GetShownColormap(), range[reversed ? 1 : 0], range[reversed ? 0 : 1]);
  const std::string layer = stage->GetLayer();
  this->SetTitle(vtkRelievoLayerCatalogue::GetTitle(layer));
  const bool isOfLight = vtkRelievoLayerCatalogue::GetIsOfLight(layer) && !given;
  this->SetEnds(isOfLight ? "in shadow" : "", isOfLight ? "lit" : "");
  return true;
}

//------------------------------------------------------------------------------
int vtkRelievoLayerLegend::RenderOverlay(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  if (this->IsGiven || !renderer)
  {
    return this->Superclass::RenderOverlay(viewport);
  }
  // The stage draws the layer over the renderer's texts; only then are its values known.
  renderer->RemoveObserver(this->Last);
  this->Last =
    renderer->AddObserver(vtkCommand::EndEvent, this, &vtkRelievoLayerLegend::RenderAfterFrame);
  return 0;
}

//------------------------------------------------------------------------------
void vtkRelievoLayerLegend::RenderAfterFrame(vtkObject* caller, unsigned long, void*)
{
  auto* renderer = vtkRenderer::SafeDownCast(caller);
  renderer->RemoveObserver(this->Last);
  this->Last = 0;
  auto* frame = vtkRelievoFramePass::SafeDownCast(renderer->GetPass());
  if (frame && this->Take(vtkRelievoDisplayStage::SafeDownCast(frame->GetStage("display")), true))
  {
    this->Superclass::RenderOverlay(renderer);
  }
}
