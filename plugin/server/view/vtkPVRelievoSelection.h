// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Markers around the points of the selection in a view, for each of ParaView's visible
// representations of a selection.
#ifndef vtkPVRelievoSelection_h
#define vtkPVRelievoSelection_h

#include "vtkNew.h"
#include "vtkRelievoMarkers.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkPVView;

class vtkPVRelievoSelection
{
public:
  bool On = false;

  // The markers' parameters, equal for all points.
  vtkNew<vtkRelievoMarkers> Look;

  // One set per representation of a selection in the view, visible or not, so that all processes
  // have equally many; none while it is off.
  std::vector<vtkRelievoMarkers*> FindIn(vtkPVView* view);

private:
  std::vector<vtkSmartPointer<vtkRelievoMarkers>> Sets;
};

#endif
