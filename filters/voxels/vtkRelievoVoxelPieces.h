// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which part of a grid a request of the pipeline is about.
#ifndef vtkRelievoVoxelPieces_h
#define vtkRelievoVoxelPieces_h

#include <array>

class vtkAlgorithm;
class vtkImageData;
class vtkInformation;

namespace vtkRelievoVoxelPieces
{
// Updates all of an output, for the time that was asked for last.
void UpdateWhole(vtkAlgorithm* producer, int port);

// Sets the whole extent. Who asked for all of the one before is asking for all of this.
void SetWhole(vtkInformation* output, const std::array<int, 6>& extent);

// Leaves the cells in the update extent.
void Crop(vtkImageData* image, vtkInformation* output);

// The extent of an input that is the piece of an output, without ghosts; each cell is in one piece.
std::array<int, 6> Of(vtkInformation* input, vtkInformation* output);
}

#endif
