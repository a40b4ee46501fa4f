// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockInput.h
 * @brief Checks and reads the input of vtkRelievoSmoothBlocks.
 */
#ifndef vtkRelievoBlockInput_h
#define vtkRelievoBlockInput_h

#include "vtkRelievoBlockSurface.h"

#include <string>

class vtkDataArray;
class vtkImageData;
class vtkUnsignedCharArray;

namespace relievo
{
/** Whether the array can be labels of the image's cells or points; if not, `problem` says why. */
bool CheckBlockLabels(
  vtkImageData* image, vtkDataArray* labels, bool onPoints, std::string& problem);

/** Blocks that count as air whatever their label: those whose mark has one of the bits. */
struct HiddenBlocks
{
  vtkSmartPointer<vtkUnsignedCharArray> Marks; // null: none
  unsigned char Bits = 0;
};

HiddenBlocks FindHiddenBlocks(vtkImageData* image, bool onPoints);

/** The blocks, numbered from 1, that belong to this piece of the whole extent. */
std::array<int, 6> FindOwnedBlocks(
  vtkImageData* image, bool onPoints, const BlockBox& box, const int whole[6]);

/** Sets where the blocks are in space. */
void SetBlockGeometry(vtkImageData* image, bool onPoints, BlockSettings& settings);

/** A box of blocks with more layers added, clipped to the existing blocks. */
std::array<int, 6> GrowBlocks(
  const std::array<int, 6>& box, int by, const std::array<int, 3>& size);
}

#endif
