// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoBlockInput.h
 * @brief What vtkRelievoSmoothBlocks needs to know of its input.
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
/**
 * Whether these can be labels of the image's cells or points; if not, with words for the message.
 */
bool CheckBlockLabels(
  vtkImageData* image, vtkDataArray* labels, bool onPoints, std::string& problem);

/** Marks of blocks that are air whatever their label, where they have one of the bits. */
struct HiddenBlocks
{
  vtkSmartPointer<vtkUnsignedCharArray> Marks; // null: none
  unsigned char Bits = 0;
};

HiddenBlocks FindHiddenBlocks(vtkImageData* image, bool onPoints);

/** Blocks, numbered from 1, that belong to this piece of the whole extent. */
std::array<int, 6> FindOwnedBlocks(
  vtkImageData* image, bool onPoints, const BlockBox& box, const int whole[6]);

/** Where blocks are in space. */
void SetBlockGeometry(vtkImageData* image, bool onPoints, BlockSettings& settings);

/** A box of blocks with more layers, within the blocks that there are. */
std::array<int, 6> GrowBlocks(
  const std::array<int, 6>& box, int by, const std::array<int, 3>& size);
}

#endif
