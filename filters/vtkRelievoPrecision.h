// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkRelievoPrecision.h
 * @brief Whether coordinates need double.
 */
#ifndef vtkRelievoPrecision_h
#define vtkRelievoPrecision_h

class vtkImageData;

namespace relievo
{
/**
 * Whether float would move points of an image of this whole extent by more than a thousandth of a
 * cell's shortest side. All pieces of the image give the same answer.
 */
bool NeedsDouble(vtkImageData* image, const int wholeExtent[6]);
}

#endif
