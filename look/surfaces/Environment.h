// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The light from all around, from an image file: for surfaces to mirror and be lit by, and as sky.
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
class ReadContext;
struct SurfaceChoice;

/// The environment that is chosen, with its irradiance, and levels if the mirror is rough; nullptr
/// if there is none. `up`: the axis that points up. Whole numbers are sRGB, floats linear. Throws
/// WorkError with the file's name.
vtkSmartPointer<vtkRelievoEnvironment> ReadEnvironment(
  const SurfaceChoice& surface, int up, ReadContext& context);

/// Puts the sky behind the renderer's picture.
void ShowSky(vtkRenderer* renderer, vtkRelievoEnvironment* environment);
}

#endif
