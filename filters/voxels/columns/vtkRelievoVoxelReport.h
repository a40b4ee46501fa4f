// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The report of a voxel shell on its last update.
#ifndef vtkRelievoVoxelReport_h
#define vtkRelievoVoxelReport_h

#include "vtkRelievoVoxelColumns.h"

#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkFieldData;

struct vtkRelievoVoxelReport
{
  vtkIdType Inside = 0;
  vtkIdType Triangles = 0; // number of triangles processed
  bool Closed = false;
  std::array<vtkIdType, 3> Open{};
  std::array<vtkIdType, 3> Columns{};
  std::string Words;

  // Counts the columns of an axis.
  void Count(int axis, const vtkRelievoVoxelParity& parity, const vtkRelievoVoxelGrid& grid);

  // Makes the text from the numbers, for parity along an axis or for views; `invalid` triangles
  // were left out.
  void Describe(bool parity, int axis, const std::vector<vtkRelievoVoxelViews>& views,
    const vtkRelievoVoxelGrid& grid, bool fromImages, vtkIdType invalid);

  void AddTo(vtkFieldData* fields) const;
};

#endif
