// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fits a grid to a box.
#ifndef vtkRelievoVoxelFit_h
#define vtkRelievoVoxelFit_h

#include "vtkRelievoVoxelGrid.h"

#include <string>

struct vtkRelievoVoxelFit
{
  std::array<int, 3> Dimensions{ { 0, 0, 0 } }; // first choice, if all are above 0
  double CellSize = 0.;                         // second choice
  int Resolution = 100;                         // cells along the longest side
  int Padding = 0;                              // cells added on each side

  // The number of cells along each axis, which may exceed an int.
  std::array<double, 3> Count(const double box[6]) const;

  // Why no grid can fill the box: lengths that are not finite, or more cells along an axis than an
  // extent can count. Empty if one can.
  std::string FindProblem(const double box[6]) const;

  // The grid, centred on a box without such a problem.
  vtkRelievoVoxelGrid Fit(const double box[6]) const;

private:
  bool IsByDimensions() const;
  double GetCubeSize(const double box[6]) const;
};

#endif
