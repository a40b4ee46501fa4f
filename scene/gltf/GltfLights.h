// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lights and the camera of a glTF file.
 */
#ifndef GltfLights_h
#define GltfLights_h

#include "GltfBuffer.h"
#include "GltfShape.h"
#include "SceneNames.h"

#include <glm/vec3.hpp>

#include <set>
#include <string>
#include <vector>

class vtkRenderer;

namespace scene
{
/// Adds a node for each light that is on. `center`: where lights that do not fall off with the
/// square of the distance keep their brightness. `isPBR`: whether a surface is. Returns the nodes.
std::vector<std::size_t> AddLights(GltfBuffer& buffer, vtkRenderer* renderer,
  const glm::dvec3& center, bool isPBR, std::set<std::string>& notes);

/// Where the active camera is, looking along -z.
GltfPlace GetCameraPlace(vtkRenderer* renderer);

/// Adds the active camera, and returns its node.
std::size_t AddCamera(GltfBuffer& buffer, vtkRenderer* renderer);
}

#endif
