// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A frame to compare others with: --baseline.
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

/// The frame of the scene as it is shown, which vtkRelievoBaseline describes. Objects have the
/// names of their files; the field data holds `words` as well, the options of `relievo render` that
/// show other files in the same way. Throws WorkError.
vtkSmartPointer<vtkImageData> MakeBaseline(
  DressedScene& dressed, const RenderOptions& options, const Settings& settings);
}

#endif
