// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow maps: the receiver plane in the map, the bias in texels, the weights of the filter.
//
// Map space: u, v in texels from the centre of the lowest left one, depth in [0, 1] from the map's
// near to its far plane; viewToMap takes eye space there (homogeneous; w is 1 for a parallel light,
// the distance along the light's axis for a perspective one).

// The plane through an eye-space point, as (normal, -normal . point), is taken to map space by
// the transposed inverse of viewToMap: planes stay planes in a perspective map. A plane whose
// normal points at the light's side has a negative z there.

// Slope of a plane of map space: depth per u and per v. `steepest` bounds each: a plane that the
// light grazes has none.
vec2 relievoReceiverSlope(vec3 plane, float steepest)
{
  return vec2(clamp(-plane.x / plane.z, -steepest, steepest),
    clamp(-plane.y / plane.z, -steepest, steepest));
}

// Weight of tap i of the 2 * radius taps 1 - radius ... radius in one direction; `part` is the
// place of the point between taps 0 and 1. The weights of a row add up to 2 * radius - 1.
float relievoFilterWeight(int i, int radius, float part)
{
  if (i == 1 - radius)
  {
    return float(1.0) - part;
  }
  if (i == radius)
  {
    return part;
  }
  return float(1.0);
}
