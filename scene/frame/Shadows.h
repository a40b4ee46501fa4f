// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shadows as the command line asks for them: in the picture, and as layers shadow_N of light N.
 */
#ifndef Shadows_h
#define Shadows_h

class vtkRelievoPass;
class vtkRenderer;

namespace scene
{
struct RenderOptions;
enum class Shadows;

/// Lights that the renderer will draw with: VTK makes a headlight where there are none.
int CountLights(vtkRenderer* renderer);

/// Which lights and props cast, and how large lights are.
void SetCasters(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options);

/// Sets the pass as asked, lights too. Throws UsageError if the maps are larger than the window's
/// OpenGL makes.
void SetShadows(vtkRelievoPass* pass, vtkRenderer* renderer, const RenderOptions& options);
}

#endif
