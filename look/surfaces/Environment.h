// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light from all directions, from an image file: for reflections, ambient light, and as a skybox.
 */
#ifndef Environment_h
#define Environment_h

#include "LookNames.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkRelievoEnvironment;
class vtkRelievoMaterial;
class vtkRenderer;

namespace reading
{
class ReadContext;
}

namespace look
{
struct SurfaceChoice;

/// The chosen environment with its irradiance, and with levels for a rough mirror; nullptr if there
/// is none. `up`: the axis that points up. Whole numbers are sRGB, floats linear. Throws WorkError
/// naming the file.
vtkSmartPointer<vtkRelievoEnvironment> ReadEnvironment(
  const SurfaceChoice& surface, int up, ReadContext& context);

/// Adds the skybox behind the renderer's picture.
void ShowSky(vtkRenderer* renderer, vtkRelievoEnvironment* environment);

/// The rows of --environment, --reflectivity and --skybox.
void AddEnvironmentOptions(OptionRows& rows, SurfaceChoice& surface);
}

#endif
