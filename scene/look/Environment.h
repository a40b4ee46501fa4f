// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light from all directions, from an image file: for reflections, ambient light, and as a skybox.
 */
#ifndef Environment_h
#define Environment_h

#include "vtkSmartPointer.h"

#include <string>

class vtkRelievoEnvironment;
class vtkRelievoMaterial;
class vtkRenderer;

namespace scene
{
class Progress;
struct RenderOptions;

/// Throws UsageError or WorkError for a file that is no environment, or cannot be opened.
void CheckEnvironment(const RenderOptions& options);

/// The options' environment with its irradiance, and with levels for a rough mirror; nullptr if
/// there is none. Whole numbers are sRGB, floats linear. Throws WorkError naming the file.
vtkSmartPointer<vtkRelievoEnvironment> ReadEnvironment(
  const RenderOptions& options, Progress& progress);

/// Adds the skybox behind the renderer's picture.
void ShowSky(vtkRenderer* renderer, vtkRelievoEnvironment* environment);
}

#endif
