// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Window z for the depth test of lamps' rectangles: 0 for the background, 0.25 to 0.75 for
// surfaces, and less than 0.25 for the front of a lamp that contains the near plane. Surfaces' and
// lamps' z grow with depth by equal steps; a lamp's is smaller by more than the rounding error.
float relievoLampSurfaceZ(float depth, float zNear, float zFar)
{
  return isinf(depth) ? 0.0 : 0.25 + 0.5 * clamp((depth - zNear) / (zFar - zNear), 0.0, 1.0);
}

float relievoLampFrontZ(float depth, float zNear, float zFar)
{
  return 0.25 - 1e-5 + 0.5 * clamp((depth - zNear) / (zFar - zNear), 0.0, 1.0);
}
