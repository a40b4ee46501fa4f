// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoMarkers.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVRelievoClamped.h"
#include "vtkPVRelievoSelection.h"
#include "vtkRelievoMarkersStage.h"

vtkStandardNewMacro(vtkPVRelievoMarkers);

namespace
{
constexpr double Huge = 1e30;
}

//------------------------------------------------------------------------------
vtkPVRelievoMarkers::vtkPVRelievoMarkers()
{
  this->Markers->SetUp(0.0, 0.0, 1.0);
}

//------------------------------------------------------------------------------
vtkRelievoPointValues* vtkPVRelievoMarkers::GetValues()
{
  return this->Markers;
}

//------------------------------------------------------------------------------
void vtkPVRelievoMarkers::Prepare(vtkPVView* view, vtkPVRelievoSelection& selection,
  vtkRelievoMarkersStage* stage, vtkMultiProcessController* controller)
{
  std::vector<vtkRelievoMarkers*> wanted;
  for (vtkPVRelievoPoints* each : FindIn(view))
  {
    if (auto* markers = vtkPVRelievoMarkers::SafeDownCast(each))
    {
      wanted.push_back(markers->Markers);
    }
  }
  const std::vector<vtkRelievoMarkers*> selected = selection.FindIn(view);
  wanted.insert(wanted.end(), selected.begin(), selected.end());
  bool same = stage->GetNumberOfPointSets() == static_cast<int>(wanted.size());
  for (std::size_t i = 0; same && i < wanted.size(); ++i)
  {
    same = stage->GetPoints(static_cast<int>(i)) == wanted[i];
  }
  if (!same)
  {
    stage->RemoveAllPoints();
    for (vtkRelievoMarkers* markers : wanted)
    {
      stage->AddPoints(markers);
    }
  }
  stage->SetController(controller);
}

//------------------------------------------------------------------------------
void vtkPVRelievoMarkers::SetShape(int shape)
{
  const int first = vtkRelievoMarkers::RING;
  const int last = vtkRelievoMarkers::SHADOW;
  this->Markers->SetShape(vtkPVRelievoClamped(this, "MarkerShape", shape, first, last));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMarkers::SetRadius(double radius)
{
  this->Markers->SetRadius(vtkPVRelievoClamped(this, "MarkerRadius", radius, 0.0, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMarkers::SetWidth(double width)
{
  this->Markers->SetWidth(vtkPVRelievoClamped(this, "MarkerWidth", width, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMarkers::SetReach(double reach)
{
  this->Markers->SetReach(vtkPVRelievoClamped(this, "MarkerReach", reach, 0.0, Huge));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMarkers::SetOpacity(double opacity)
{
  this->Markers->SetOpacity(vtkPVRelievoClamped(this, "MarkerOpacity", opacity, 0.0, 1.0));
}

//------------------------------------------------------------------------------
void vtkPVRelievoMarkers::SetColor(double red, double green, double blue)
{
  this->Markers->SetColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkPVRelievoMarkers::SetUp(double x, double y, double z)
{
  if (x != 0.0 || y != 0.0 || z != 0.0)
  {
    this->Markers->SetUp(x, y, z);
  }
  else if (vtkPVRelievoReports())
  {
    vtkWarningMacro("MarkerUp: got 0 0 0, expected a direction; it stays as it was.");
  }
}
