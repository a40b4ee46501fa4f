// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoLegend.h"

#include "vtkPVRenderView.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRelievoDisplayStage.h"
#include "vtkRelievoLayerLegend.h"
#include "vtkRenderer.h"

namespace
{
constexpr double Share = 0.35;  // length of the bar, of the picture's height
constexpr double Middle = 0.25; // below the orientation axes of other corners
}

//------------------------------------------------------------------------------
vtkPVRelievoLegend::vtkPVRelievoLegend()
{
  this->Bar->SetShare(Share);
  this->Bar->SetMiddle(Middle);
}

//------------------------------------------------------------------------------
vtkPVRelievoLegend::~vtkPVRelievoLegend() = default;

//------------------------------------------------------------------------------
void vtkPVRelievoLegend::Place(
  vtkPVRenderView* view, vtkRelievoDisplayStage* stage, bool isDrawnHere)
{
  this->ShowOthers();
  vtkRenderer* renderer = view->GetNonCompositedRenderer();
  if (stage->GetLayer().empty() || !this->On)
  {
    this->Leave(view);
    return;
  }
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (prop->IsA("vtkScalarBarRepresentation") && prop->GetVisibility())
    {
      prop->SetVisibility(false);
      this->Hidden.emplace_back(prop);
    }
  }
  if (!this->Bar->Follow(stage, isDrawnHere))
  {
    this->Leave(view);
    return;
  }
  renderer->AddViewProp(this->Bar);
}

//------------------------------------------------------------------------------
void vtkPVRelievoLegend::ShowOthers()
{
  for (vtkProp* prop : this->Hidden)
  {
    if (prop)
    {
      prop->SetVisibility(true);
    }
  }
  this->Hidden.clear();
}

//------------------------------------------------------------------------------
void vtkPVRelievoLegend::Leave(vtkPVRenderView* view)
{
  view->GetNonCompositedRenderer()->RemoveViewProp(this->Bar);
}
