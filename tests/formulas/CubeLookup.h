// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CubeLookup.h
 * @brief Which texel of a cube map OpenGL's samplerCube finds in a direction.
 */
#ifndef relievoTestCubeLookup_h
#define relievoTestCubeLookup_h

#include <glm/vec3.hpp>

#include <vector>

namespace relievoTest
{
/** A texel: face 0 to 5 in OpenGL's order, column and row as they are given to OpenGL. */
struct CubeTexel
{
  int Face;
  int I;
  int J;
};

/**
 * The texel nearest to each direction in a cube of size x size texels a face, asked of OpenGL in a
 * window of its own; empty, with a counted failure, when that cannot be done.
 */
std::vector<CubeTexel> LookUpCube(int size, const std::vector<glm::vec3>& directions);
}

#endif
