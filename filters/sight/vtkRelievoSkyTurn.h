// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rotates a direction about z to a surface's normal.
#ifndef vtkRelievoSkyTurn_h
#define vtkRelievoSkyTurn_h

#include "vtkMath.h"
#include "vtkRelievoFormulas.h"

inline glm::dvec3 vtkRelievoSkyTurn(const glm::dvec3& direction, const double normal[3])
{
  double right[3];
  double ahead[3];
  vtkMath::Perpendiculars(normal, right, ahead, 0.0);
  glm::dvec3 turned;
  for (int i = 0; i < 3; ++i)
  {
    turned[i] = direction.x * right[i] + direction.y * ahead[i] + direction.z * normal[i];
  }
  return turned;
}

#endif
