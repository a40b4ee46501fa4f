// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Texture coordinates for meshes that have none, to place maps on them.
 */
#ifndef TextureCoordinates_h
#define TextureCoordinates_h

#include "LookNames.h"

#include <optional>
#include <string>

class vtkActor;

namespace reading
{
class ReadContext;
}

namespace look
{
enum class Mapping;

/// Gives texture coordinates to the actor's meshes (of the file `path`) that have polygons but no
/// coordinates; `up`: the axis that points up. If no method is chosen, uses a box, and notes it.
void AddTextureCoordinates(vtkActor* actor, const std::optional<Mapping>& chosen, int up,
  const std::string& path, ReadContext& context);
}

#endif
