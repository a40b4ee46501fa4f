// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoMatrix.h"

#include "vtkMatrix4x4.h"

#include <glm/geometric.hpp>

#include <algorithm>

//------------------------------------------------------------------------------
glm::dmat4 vtkRelievoToGlm(vtkMatrix4x4* matrix)
{
  glm::dmat4 out(1.0);
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      out[column][row] = matrix->GetElement(row, column);
    }
  }
  return out;
}

//------------------------------------------------------------------------------
bool vtkRelievoIsProjective(vtkMatrix4x4* matrix)
{
  return matrix->GetElement(3, 0) != 0.0 || matrix->GetElement(3, 1) != 0.0 ||
    matrix->GetElement(3, 2) != 0.0 || matrix->GetElement(3, 3) != 1.0;
}

//------------------------------------------------------------------------------
double vtkRelievoGetScale(const glm::dmat4& matrix)
{
  const glm::dmat3 axes(matrix);
  return std::max({ glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]) });
}
