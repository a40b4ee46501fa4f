// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Window z by which rectangles of lamps are tested: nothing lies at 0, surfaces between 0.25 and
// 0.75, and the front of a lamp that contains the near plane before them. Both grow with the depth
// by the same steps; a lamp's is smaller by more than what rounding makes of it.
float relievoLampSurfaceZ(float depth, float zNear, float zFar)
{
  return isinf(depth) ? 0.0 : 0.25 + 0.5 * clamp((depth - zNear) / (zFar - zNear), 0.0, 1.0);
}

float relievoLampFrontZ(float depth, float zNear, float zFar)
{
  return 0.25 - 1e-5 + 0.5 * clamp((depth - zNear) / (zFar - zNear), 0.0, 1.0);
}
