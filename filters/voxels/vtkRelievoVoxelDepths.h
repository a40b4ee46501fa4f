// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Orthographic depth images, as captures write them, as what columns of cells cross.
#ifndef vtkRelievoVoxelDepths_h
#define vtkRelievoVoxelDepths_h

#include "vtkRelievoVoxelColumns.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkImageData;

namespace vtkRelievoVoxelDepths
{
// The data, or what is in its blocks, if they are images.
void Add(vtkDataObject* data, std::vector<vtkImageData*>& images);

// A matrix of an image's field data, by rows. False if it has none of 16 finite numbers.
bool GetMatrix(vtkImageData* image, const char* name, double matrix[16]);

// Each image looks along an axis; each axis that one looks along needs one from each side. A column
// takes the texel whose centre is nearest to its own; beyond an image, and where a texel is not
// finite, there is nothing. Returns what is wrong, or an empty text.
std::string Read(const std::vector<vtkImageData*>& images, const vtkRelievoVoxelGrid& grid,
  std::vector<vtkRelievoVoxelViews>& views);
}

#endif
