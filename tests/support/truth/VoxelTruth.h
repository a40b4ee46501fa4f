// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VoxelTruth.h
 * @brief The cells of a grid inside a body, by a formula, or by rays through triangles.
 */
#ifndef relievoTestVoxelTruth_h
#define relievoTestVoxelTruth_h

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

namespace relievoTest
{
class EmbreeScene;

/** Called from several threads. */
using InsideFunction = std::function<bool(const glm::dvec3&)>;

/** Whether two of three rays from a position cross the scene's triangles an odd number of times. */
bool IsInsideByVote(const EmbreeScene& scene, const glm::dvec3& place);

/** 1 for cells whose centre is inside, x fastest; `origin` is the grid's lower corner. */
std::vector<unsigned char> CellsInside(const InsideFunction& isInside, const int cells[3],
  const double origin[3], const glm::dvec3& spacing);
}

#endif
