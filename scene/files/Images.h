// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files of images that surfaces take: maps and environments.
 */
#ifndef Images_h
#define Images_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;

namespace scene
{
class Progress;

/// Throws UsageError if the path, which came with `option`, has none of the extensions, WorkError
/// if it cannot be opened.
void CheckImage(
  const std::string& option, const std::string& path, const std::vector<std::string>& extensions);

/// The image, row 0 lowest, its numbers as they are in the file. Throws WorkError with the path.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& path, Progress& progress);

/// The file that ReadImage has an image from; "" for any other image.
std::string GetImageFile(vtkImageData* image);
}

#endif
