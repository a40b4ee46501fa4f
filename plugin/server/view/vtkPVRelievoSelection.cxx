// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVRelievoSelection.h"

#include "vtkPVRelievoAccess.h"
#include "vtkPVRelievoPoints.h"
#include "vtkPVView.h"
#include "vtkRelievoParameter.h"

//------------------------------------------------------------------------------
std::vector<vtkRelievoMarkers*> vtkPVRelievoSelection::FindIn(vtkPVView* view)
{
  std::vector<vtkRelievoMarkers*> found;
  const int count = this->On ? view->GetNumberOfRepresentations() : 0;
  for (int i = 0; i < count; ++i)
  {
    auto* selection = vtkSelectionRepresentation::SafeDownCast(view->GetRepresentation(i));
    if (!selection)
    {
      continue;
    }
    if (found.size() == this->Sets.size())
    {
      this->Sets.push_back(vtkSmartPointer<vtkRelievoMarkers>::New());
    }
    vtkRelievoMarkers* markers = this->Sets[found.size()];
    for (const vtkRelievoParameter& value : this->Look->GetDescription().Parameters)
    {
      markers->SetParameter(value.Name, value.Format());
    }
    vtkGeometryRepresentation* surface = vtkPVRelievoAccess::Selection::Surface(selection);
    vtkPVRelievoPoints::TakeInput(surface && surface->GetVisibility() ? surface : nullptr, markers);
    found.push_back(markers);
  }
  this->Sets.resize(found.size());
  return found;
}
