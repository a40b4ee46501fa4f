// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Frames for comparisons: those of --baseline, and their pictures.
 */
#ifndef Baseline_h
#define Baseline_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace scene
{
class DressedScene;
class Settings;
struct RenderOptions;

/// The scene's frame as a baseline, portable or not (vtkRelievoBaseline). Objects have the names of
/// their files. The field data also has `words`: options of `relievo render` that draw other files
/// the same way. Throws WorkError.
vtkSmartPointer<vtkImageData> MakeBaseline(
  DressedScene& dressed, const RenderOptions& options, const Settings& settings, bool portable);

/// The picture of a frame or of an image file, 8 bits, without alpha; null if it has only layers.
vtkSmartPointer<vtkImageData> MakePicture(vtkImageData* frame);
}

#endif
