// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files of images that surfaces take: maps and environments.
 */
#ifndef Images_h
#define Images_h

#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <string>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkRelievoAllowedFolders;

namespace scene
{
class ReadContext;

/// Throws UsageError if the path, which came with `option`, has no extension of an image that is
/// read, WorkError if it cannot be opened.
void CheckImage(const std::string& option, const std::string& path);

/// Throws WorkError with the path unless it may be read, which a file names.
void CheckAllowed(const std::string& path, const vtkRelievoAllowedFolders& allowed);

/// The image, row 0 lowest, its numbers as they are in the file. Throws WorkError with the path.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& path, ReadContext& context);

/// A smooth texture of the image's colours.
vtkSmartPointer<vtkTexture> MakeTexture(vtkImageData* image);

/// The opacity below which a surface with this image as its texture is left out: half for cut-outs,
/// which VTK has translucent where they are smooth; 0 for others, and for what is translucent as a
/// whole.
double FindCutoff(vtkImageData* image, vtkActor* actor);

/// The file that ReadImage has an image from; "" for any other image.
std::string GetImageFile(vtkImageData* image);
}

#endif
