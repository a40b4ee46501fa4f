// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads image files for surfaces: maps and environments.
 */
#ifndef Images_h
#define Images_h

#include "ReadingNames.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <string>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkRelievoAllowedFolders;

namespace reading
{
class ReadContext;

/// Throws UsageError unless the path, given with `option`, has the extension of a readable image,
/// and WorkError if it cannot be opened.
void CheckImage(const std::string& option, const std::string& path);

/// Throws WorkError naming the path unless a file may refer to it and it can be read.
void CheckAllowed(const std::string& path, const vtkRelievoAllowedFolders& allowed);

/// Reads an image, row 0 lowest, with the file's own numbers. Throws WorkError naming the path.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& path, ReadContext& context);

/// An interpolated texture of the image's colours.
vtkSmartPointer<vtkTexture> MakeTexture(vtkImageData* image);

/// The opacity below which a surface with this texture is cut out: one half for cut-outs, which VTK
/// would treat as translucent where their edges are smooth; 0 for other textures, and for textures
/// that are translucent as a whole.
double FindCutoff(vtkImageData* image, vtkActor* actor);

/// The file from which ReadImage read the image; "" for any other image.
std::string GetImageFile(vtkImageData* image);
}

#endif
