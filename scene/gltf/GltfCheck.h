// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Compares a renderer's layers with those of a glTF file of its scene.
 */
#ifndef GltfCheck_h
#define GltfCheck_h

#include "SceneNames.h"

#include <glm/mat4x4.hpp>

#include <set>
#include <string>
#include <vector>

class vtkActor;
class vtkRenderer;

namespace scene
{
/// Draws the file's surfaces from the renderer's camera, and compares opaque surfaces. In the file,
/// surfaces that are not PBR in the scene must be unlit, so that both have their colours as drawn.
/// `toFile` takes the scene's coordinates to the file's. `actors`: the actor of each primitive of
/// the file. `partial`: actors that the file has in part only, or not at all, which are not
/// compared. Returns the difference, a part of a sentence, or nothing.
std::string FindDifference(vtkRenderer* renderer, const std::string& file, const glm::dmat4& toFile,
  const std::vector<vtkActor*>& actors, const std::set<vtkActor*>& partial);
}

#endif
