// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Handles the part of a grid that a pipeline request asks for.
#ifndef vtkRelievoVoxelPieces_h
#define vtkRelievoVoxelPieces_h

#include <array>

class vtkAlgorithm;
class vtkImageData;
class vtkInformation;

namespace vtkRelievoVoxelPieces
{
// Updates a whole output for the time requested last.
void UpdateWhole(vtkAlgorithm* producer, int port);

// Sets the whole extent. A request for the whole previous extent becomes one for the new extent.
void SetWhole(vtkInformation* output, const std::array<int, 6>& extent);

// Crops the image to the cells in the update extent.
void Crop(vtkImageData* image, vtkInformation* output);

// The extent of an input for the piece of an output, without ghosts; each cell is in one piece.
std::array<int, 6> Of(vtkInformation* input, vtkInformation* output);
}

#endif
