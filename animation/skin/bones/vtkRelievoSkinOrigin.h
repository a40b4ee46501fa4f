// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Meshes far from the origin, where floats have few digits: points and bones relative to a middle.
 */
#ifndef vtkRelievoSkinOrigin_h
#define vtkRelievoSkinOrigin_h

#include "vtkRelievoSkinBounds.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <vector>

class vtkPolyData;

namespace relievo
{
/// A box around all points of a mesh, including those of no cell.
SkinBox GetBox(vtkPolyData* mesh);

/// The middle of a box whose distance from the origin exceeds `sizes` times its size (up to 16
/// times, floats lose at most four bits), rounded to float; the origin for other boxes.
glm::dvec3 GetFarOrigin(const SkinBox& box, double sizes = 16.);

/// Converts matrices to positions relative to `rest` before the movement and to `moved` after it.
std::vector<glm::dmat4> GetMatricesAbout(
  const std::vector<glm::dmat4>& matrices, const glm::dvec3& rest, const glm::dvec3& moved);
}

#endif
