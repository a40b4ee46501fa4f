// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shadows on the command line: in the picture, and as layers shadow_N of light N.
 */
#ifndef Shadows_h
#define Shadows_h

#include "SceneNames.h"

class vtkRelievoPass;
class vtkRenderer;

namespace scene
{
struct RenderOptions;

/// Number of lights drawn: VTK makes a headlight if there are none.
int CountLights(vtkRenderer* renderer);

/// Sets which lights cast shadows, their size and names.
void SetCastingLights(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options);

/// Sets whether volumes cast shadows and receive them.
void SetCastingVolumes(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options);

/// Sets the casters and the sizes of lights, and whether the pass waits for samples. Throws
/// UsageError if the maps exceed the limits of the window's OpenGL.
void SetShadows(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options);
}

#endif
