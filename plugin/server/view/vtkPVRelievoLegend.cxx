// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoLegend.h"

#include "vtkColorTransferFunction.h"
#include "vtkPVRenderView.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRelievoColormaps.h"
#include "vtkRelievoDisplayStage.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Left = 0.87; // share of the picture, like those below
constexpr double Bottom = 0.05;
constexpr double Width = 0.11;
constexpr double Height = 0.4;
constexpr double Dark = 0.08; // background of texts, on which white is readable over any picture
constexpr double Opacity = 0.75;
constexpr int Labels = 3;
constexpr int Lines = 38; // lines of text in the picture's height
constexpr int LeastFont = 8;
constexpr int Pad = 4; // pixels
}

//------------------------------------------------------------------------------
vtkPVRelievoLegend::vtkPVRelievoLegend()
{
  this->Bar->SetLookupTable(this->Colors);
  this->Bar->SetNumberOfLabels(Labels);
  this->Bar->SetLabelFormat("%.4g");
  this->Bar->SetPosition(Left, Bottom);
  this->Bar->SetWidth(Width);
  this->Bar->SetHeight(Height);
  this->Bar->UnconstrainedFontSizeOn();
  this->Bar->SetTextPad(Pad);
  this->Bar->SetVerticalTitleSeparation(Pad);
  for (vtkTextProperty* text :
    { this->Bar->GetTitleTextProperty(), this->Bar->GetLabelTextProperty() })
  {
    text->SetColor(1.0, 1.0, 1.0);
    text->SetBackgroundColor(Dark, Dark, Dark);
    text->SetBackgroundOpacity(Opacity);
    text->BoldOff();
    text->ItalicOff();
    text->ShadowOff();
  }
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
  const bool given = stage->GetRange()[0] < stage->GetRange()[1];
  const double* range = given ? stage->GetRange() : stage->GetShownRange();
  const bool known = given || (isDrawnHere && stage->GetReasonCode() == "ran");
  if (!known || !stage->HasScale() || !std::isfinite(range[0]))
  {
    this->Leave(view);
    return;
  }
  const bool reversed = stage->GetShownReversed();
  this->Colors->RemoveAllPoints();
  vtkRelievoColormaps::Fill(
    this->Colors, stage->GetShownColormap(), range[reversed ? 1 : 0], range[reversed ? 0 : 1]);
  this->Bar->SetTitle(stage->GetLayer().c_str());
  for (vtkTextProperty* text :
    { this->Bar->GetTitleTextProperty(), this->Bar->GetLabelTextProperty() })
  {
    text->SetFontSize(std::max(LeastFont, renderer->GetSize()[1] / Lines));
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
