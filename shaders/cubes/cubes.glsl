// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Sizes and positions of cubes in the vertex shader of VTK's instances. Inserted after the
// declaration of the instance's matrix, which it replaces in all later code.
//RELIEVO::Include(formulas/geometry/cube.glsl)

uniform vec4 relievoCubeCell; // sides of a cell, and the longest one
uniform vec3 relievoCubeFall; // transition, size at rest, growth
uniform vec4 relievoCubeRepeller; // position and radius, model coordinates

mat4 relievoCubeMatrix()
{
  mat4 instance = GCMCMatrix;
  // Instances are scaled by 1 / (1 + distance outside / longest side).
  float scale = length(instance[0].xyz) / relievoCubeCell.x;
  float distance = max(1.0 / scale - 1.0, 0.0) * relievoCubeCell.w;
  // Rounding of a cell inside does not count as a distance.
  distance = distance < 1e-4 * relievoCubeCell.w ? 0.0 : distance;
  float size = relievoCubeSize(distance, relievoCubeFall.x, relievoCubeFall.y, relievoCubeFall.z);
  instance[0].xyz *= size / scale;
  instance[1].xyz *= size / scale;
  instance[2].xyz *= size / scale;
  instance[3].xyz =
    relievoCubePlace(instance[3].xyz, relievoCubeRepeller.xyz, relievoCubeRepeller.w);
  return instance;
}
#define GCMCMatrix relievoCubeMatrix()
