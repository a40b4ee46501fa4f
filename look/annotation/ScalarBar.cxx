// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScalarBar.h"

#include "vtkRelievoAnnotation.h"
#include "vtkRelievoColorBar.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

namespace look
{
//------------------------------------------------------------------------------
void AddScalarBar(vtkRenderer* renderer, vtkColorTransferFunction* map, int steps,
  const ColoredValues& values, const BarChoice& choice, const PrintChoice& print)
{
  vtkNew<vtkRelievoColorBar> bar;
  bar->SetLookupTable(map);
  bar->SetTitle(choice.Title.value_or(values.Name));
  bar->SetUnit(choice.Unit);
  bar->SetPlace(choice.Place);
  bar->SetSteps(steps);
  bar->SetTextSize(print.GetTextSize());
  const double* shown = map->GetRange();
  bar->SetBelowBox(values.Range[0] < shown[0]);
  bar->SetAboveBox(values.Range[1] > shown[1]);
  bar->SetNanBox(values.HasNan);
  // Other backgrounds are painted for --transparent; the ink must not follow them.
  bar->SetInk(vtkRelievoAnnotation::GetInk(renderer)[0] < 0.5 ? vtkRelievoColorBar::INK_BLACK
                                                              : vtkRelievoColorBar::INK_WHITE);
  renderer->AddViewProp(bar);
}
}
