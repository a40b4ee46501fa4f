// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * --baseline: a frame for later comparisons.
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

/// The scene's frame as a baseline (vtkRelievoBaseline). Objects have the names of their files. The
/// field data also has `words`: options of `relievo render` that draw other files the same way.
/// Throws WorkError.
vtkSmartPointer<vtkImageData> MakeBaseline(
  DressedScene& dressed, const RenderOptions& options, const Settings& settings);
}

#endif
