// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Texture coordinates for meshes that have none, so that maps have a place on them.
 */
#ifndef TextureCoordinates_h
#define TextureCoordinates_h

#include <string>

class vtkActor;

namespace scene
{
struct RenderOptions;

/// Gives the meshes of the actor, which are of the file `path`, texture coordinates where they have
/// polygons and none. If the options do not say how, as a box, and that is noted.
void AddTextureCoordinates(vtkActor* actor, const RenderOptions& options, const std::string& path);
}

#endif
