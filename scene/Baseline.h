// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Frames for comparisons: those of --baseline, and their pictures.
 */
#ifndef Baseline_h
#define Baseline_h

#include "SceneNames.h"
#include "Settings.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>

namespace scene
{
class StyledScene;
struct RenderOptions;

/// The scene's frame as a baseline, portable or not (vtkRelievoBaseline). Objects have the names of
/// their files. The field data also has `words`: options of `relievo render` that draw other files
/// the same way. Throws WorkError.
vtkSmartPointer<vtkImageData> MakeBaseline(
  const StyledScene& styled, const RenderOptions& options, const Settings& settings, bool portable);

/// The options in a baseline, without files; none if it records none. `path` names the baseline in
/// errors. Throws WorkError for options that cannot be parsed.
std::optional<Settings> GetRecorded(vtkImageData* baseline, const std::string& path);

/// The picture of a frame or of an image file, 8 bits, without alpha; null if it has only layers.
vtkSmartPointer<vtkImageData> MakePicture(vtkImageData* frame);
}

#endif
