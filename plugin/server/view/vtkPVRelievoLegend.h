// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The legend of the layer shown as a view's picture; it replaces the data's scalar bars, whose
// colours are hidden.
#ifndef vtkPVRelievoLegend_h
#define vtkPVRelievoLegend_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkPVRenderView;
class vtkProp;
class vtkRelievoDisplayStage;
class vtkRelievoLayerLegend;

class vtkPVRelievoLegend
{
public:
  vtkPVRelievoLegend();
  ~vtkPVRelievoLegend();

  bool On = true;

  /** Before annotations are drawn, and after the layer, whose values are known then. */
  void Place(vtkPVRenderView* view, vtkRelievoDisplayStage* stage, bool isDrawnHere);

  /** After annotations are drawn: makes the data's scalar bars visible again. */
  void ShowOthers();

  /** Removes the legend from the view. */
  void Leave(vtkPVRenderView* view);

private:
  vtkNew<vtkRelievoLayerLegend> Bar;
  std::vector<vtkWeakPointer<vtkProp>> Hidden;
};

#endif
