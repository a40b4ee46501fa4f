// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A function of VTK whose values are found faster than by VTK, which passes its nodes one by one.
#ifndef vtkRelievoOpacityCurve_h
#define vtkRelievoOpacityCurve_h

#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"

#include <glm/vec2.hpp>

#include <vector>

class vtkRelievoOpacityCurve
{
public:
  void Set(vtkPiecewiseFunction* function);
  explicit operator bool() const { return this->Function != nullptr; }
  double Get(double x) const;

private:
  vtkSmartPointer<vtkPiecewiseFunction> Function;
  std::vector<glm::dvec2> Nodes; // empty: between nodes, or outside, it is not linear
};

#endif
