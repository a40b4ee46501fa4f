// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The legend of the layer that a view shows as its picture, in the place of the scalar bars of the
// data, whose colours are not seen.
#ifndef vtkPVRelievoLegend_h
#define vtkPVRelievoLegend_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkColorTransferFunction;
class vtkPVRenderView;
class vtkProp;
class vtkRelievoDisplayStage;
class vtkScalarBarActor;

class vtkPVRelievoLegend
{
public:
  vtkPVRelievoLegend();
  ~vtkPVRelievoLegend();

  bool On = true;

  /** Before annotations are drawn, and after the layer: its values are known then. */
  void Place(vtkPVRenderView* view, vtkRelievoDisplayStage* stage, bool isDrawnHere);

  /** After annotations are drawn: the data's scalar bars are seen again. */
  void ShowOthers();

  /** Takes the legend out of the view. */
  void Leave(vtkPVRenderView* view);

private:
  vtkNew<vtkScalarBarActor> Bar;
  vtkNew<vtkColorTransferFunction> Colors;
  std::vector<vtkWeakPointer<vtkProp>> Hidden;
};

#endif
