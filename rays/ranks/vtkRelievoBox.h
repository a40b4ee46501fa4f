// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The box of a prop, or of a process's part of it.
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
  int Number = 0;     // index of the prop in its renderer
  bool Loose = false; // its mapper may draw outside the box

  std::array<glm::dvec3, 8> GetCorners() const;

  // Adds a box to boxes ordered by their props' numbers. The boxes of one prop are merged across
  // processes, so that results do not depend on the number of processes.
  static void Join(const vtkRelievoBox& box, std::vector<vtkRelievoBox>& boxes);
};

#endif
