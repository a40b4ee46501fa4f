// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Texture coordinates for meshes that have none, so that maps have a place on them.
 */
#ifndef TextureCoordinates_h
#define TextureCoordinates_h

#include <optional>
#include <string>

class vtkActor;

namespace scene
{
enum class Mapping;
class ReadContext;

/// Gives the meshes of the actor, which are of the file `path`, texture coordinates where they have
/// polygons and none; `up`: the axis that points up. If nothing is chosen, as a box, and that is
/// noted.
void AddTextureCoordinates(vtkActor* actor, const std::optional<Mapping>& chosen, int up,
  const std::string& path, ReadContext& context);
}

#endif
