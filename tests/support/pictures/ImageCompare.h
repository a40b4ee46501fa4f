// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ImageCompare.h
 * @brief Compares two pictures of 8 bits in memory. For baselines, see docs/compare.md.
 */
#ifndef relievoTestImageCompare_h
#define relievoTestImageCompare_h

#include <string>

class vtkImageData;

namespace relievoTest
{
/**
 * The largest difference of a channel, in levels of 255, between pictures of unsigned char with 3
 * or 4 components; a missing alpha counts as 255. Returns 256 if they cannot be compared: for null,
 * empty pictures, other types, and sizes that differ.
 */
int GetLargestDifference(vtkImageData* a, vtkImageData* b);

/** Whether two pictures have the same bytes. */
bool IsSame(vtkImageData* a, vtkImageData* b);

/** Writes a PNG; false on failure. */
bool WriteImage(const std::string& path, vtkImageData* image);
}

#endif
