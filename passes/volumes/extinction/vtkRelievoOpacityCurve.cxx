// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoOpacityCurve.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkRelievoOpacityCurve::Set(vtkPiecewiseFunction* function)
{
  this->Function = function;
  bool linear = function->GetClamping() != 0;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4]; // with the place of the middle and the sharpness
    function->GetNodeValue(i, node);
    this->Nodes.emplace_back(node[0], node[1]);
    linear = linear && node[2] == 0.5 && node[3] == 0.0;
  }
  if (!linear)
  {
    this->Nodes.clear();
  }
}

//------------------------------------------------------------------------------
double vtkRelievoOpacityCurve::Get(double x) const
{
  if (this->Nodes.empty())
  {
    return this->Function->GetValue(x);
  }
  const auto after = std::lower_bound(this->Nodes.begin(), this->Nodes.end(), x,
    [](const glm::dvec2& node, double value) { return node.x < value; });
  if (after == this->Nodes.begin() || after == this->Nodes.end())
  {
    return (after == this->Nodes.end() ? this->Nodes.back() : *after).y;
  }
  const glm::dvec2& before = *(after - 1);
  return before.y + (x - before.x) / (after->x - before.x) * (after->y - before.y);
}
