// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow maps: the receiver plane in the map, the bias in texels, the weights of the filter.
//
// Map space: u, v in [0, 1] over the map, depth in [0, 1] from its near to its far plane;
// viewToMap takes eye space there (homogeneous; w is 1 for a parallel light, the distance along the
// light's axis for a perspective one).

// A tangent of the plane with this unit normal: square to it, not of unit length.
vec3 relievoTangent(vec3 normal)
{
  if (abs(normal.x) > abs(normal.y))
  {
    return vec3(-normal.z, float(0.0), normal.x);
  }
  return vec3(float(0.0), normal.z, -normal.y);
}

// Change of the map coordinates (u, v, depth) of a point that moves along a direction.
vec3 relievoMapDerivative(mat4 viewToMap, vec4 map, vec3 direction)
{
  vec4 moved = viewToMap * vec4(direction, float(0.0));
  return vec3(moved.x - map.x / map.w * moved.w, moved.y - map.y / map.w * moved.w,
           moved.z - map.z / map.w * moved.w) /
    map.w;
}

// Slope of the plane through the point in the map: depth per u and per v. Planes stay planes in a
// perspective map, so it holds at every distance. `map` is viewToMap * (position, 1). `steepest`
// bounds each slope: a plane that the light grazes has none.
vec2 relievoReceiverSlope(mat4 viewToMap, vec4 map, vec3 normalVC, float steepest)
{
  vec3 tangent = relievoTangent(normalVC);
  vec3 a = relievoMapDerivative(viewToMap, map, tangent);
  vec3 b = relievoMapDerivative(viewToMap, map, cross(normalVC, tangent));
  float area = a.x * b.y - a.y * b.x;
  float u = a.z * b.y - b.z * a.y;
  float v = b.z * a.x - a.z * b.x;
  float limit = steepest * abs(area);
  float side = area < float(0.0) ? float(-1.0) : float(1.0);
  if (max(abs(u), abs(v)) >= limit)
  {
    // Towards the steepest descent, as far as is allowed.
    float scale = steepest / max(max(abs(u), abs(v)), float(1e-30));
    return vec2(side * u * scale, side * v * scale);
  }
  return vec2(u / area, v / area);
}

// Weight of tap i of the 2 * radius taps 1 - radius ... radius in one direction; `part` is the place
// of the point between taps 0 and 1. The weights of a row add up to 2 * radius - 1.
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
