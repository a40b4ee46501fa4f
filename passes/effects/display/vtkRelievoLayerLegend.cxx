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

#include <algorithm>
#include <cctype>
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
std::string vtkRelievoLayerLegend::NameLayer(const std::string& layer)
{
  using Catalogue = vtkRelievoLayerCatalogue;
  const bool ofLight = Catalogue::GetIsOfLight(layer);
  if (!ofLight && !Catalogue::GetIsLayer(layer))
  {
    return layer;
  }
  if (layer == "range") // a range of values is another thing
  {
    return "Distance";
  }
  std::string words = layer;
  std::replace(words.begin(), words.end(), '_', ' ');
  if (ofLight)
  {
    return (Catalogue::GetLight(layer) < 0 ? "Shadow of " : "Shadow of light ") +
      words.substr(Catalogue::GetOfLight().Name.size());
  }
  const std::string american = "color";
  const std::size_t at = words.find(american);
  if (at != std::string::npos)
  {
    words.replace(at, american.size(), "colour");
  }
  words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
  return words;
}

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
  this->SetTitle(NameLayer(layer));
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
