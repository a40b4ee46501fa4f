// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Markers around the points of what is selected in a view: those of each of ParaView's
// representations of a selection that is visible.
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

  // How they look: values that are the same for all points.
  vtkNew<vtkRelievoMarkers> Look;

  // One set for each representation of a selection in the view, visible or not, so that all
  // processes have as many; none while it is off.
  std::vector<vtkRelievoMarkers*> FindIn(vtkPVView* view);

private:
  std::vector<vtkSmartPointer<vtkRelievoMarkers>> Sets;
};

#endif
