// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Meshes far from the origin, where floats have few digits: their points and bones about a middle.
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
/// Around all points of a mesh, also those of no cell.
SkinBox GetBox(vtkPolyData* mesh);

/// The middle of a box that lies farther from the origin than so many times its size (so near as
/// 16, floats lose no more than four bits), in numbers that floats have; of other boxes the origin.
glm::dvec3 GetFarOrigin(const SkinBox& box, double sizes = 16.);

/// Matrices that take points about the place `rest` to points about the place `moved`.
std::vector<glm::dmat4> GetMatricesAbout(
  const std::vector<glm::dmat4>& matrices, const glm::dvec3& rest, const glm::dvec3& moved);
}

#endif
