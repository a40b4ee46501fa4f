// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads crossings of columns of cells from orthographic depth images, as captures write them.
#ifndef vtkRelievoVoxelDepths_h
#define vtkRelievoVoxelDepths_h

#include "vtkRelievoVoxelColumns.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkImageData;

namespace vtkRelievoVoxelDepths
{
// Adds the data, or a composite's blocks, if they are images.
void Add(vtkDataObject* data, std::vector<vtkImageData*>& images);

// A matrix of an image's field data, by rows. False without 16 finite numbers.
bool GetMatrix(vtkImageData* image, const char* name, double matrix[16]);

// Each image looks along an axis; each viewed axis needs an image from each side. A column uses the
// texel whose centre is nearest to its own; it is empty outside an image and where a texel is not
// finite. Returns the error, or an empty text.
std::string Read(const std::vector<vtkImageData*>& images, const vtkRelievoVoxelGrid& grid,
  std::vector<vtkRelievoVoxelViews>& views);
}

#endif
