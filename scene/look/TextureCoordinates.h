// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Texture coordinates for meshes that have none, to place maps on them.
 */
#ifndef TextureCoordinates_h
#define TextureCoordinates_h

#include <string>

class vtkActor;

namespace scene
{
struct RenderOptions;

/// Gives texture coordinates to the actor's meshes (of the file `path`) that have polygons but no
/// coordinates. If the options set no method, uses a box, and notes it.
void AddTextureCoordinates(vtkActor* actor, const RenderOptions& options, const std::string& path);
}

#endif
