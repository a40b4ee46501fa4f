// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The box of a prop, or of the part of it that a process has.
#ifndef vtkRelievoBox_h
#define vtkRelievoBox_h

#include "vtkRelievoFormulas.h"   // for GLM
#include "vtkRelievoRaysModule.h" // for the export macro

#include <array>
#include <vector>

struct VTKRELIEVORAYS_EXPORT vtkRelievoBox
{
  glm::dvec3 Min;
  glm::dvec3 Max;
  int Number = 0;     // of the prop in its renderer
  bool Loose = false; // its mapper may draw beyond the box

  std::array<glm::dvec3, 8> GetCorners() const;

  // Adds a box to boxes in the order of their props' numbers. The processes' parts of one prop make
  // the box that the whole prop has: what follows from boxes does not depend on how many share it.
  static void Join(const vtkRelievoBox& box, std::vector<vtkRelievoBox>& boxes);
};

#endif
