// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Shadow maps: the receiver plane in the map, the bias in texels, the weights of the filter.
//
// Map space: u, v in texels from the centre of the lowest left one, depth in [0, 1] from the map's
// near to its far plane; viewToMap transforms eye space to it (homogeneous; w is 1 for a parallel
// light, the distance along the light's axis for a perspective one).

// The share of its colour that a shadow catcher keeps, from the light that reaches it, and all the
// light that would without occluders; both exclude light that misses it. In full shadow a part is
// left, for the sky's light, which is in no other term.
float relievoCatcherShare(float reaches, float all)
{
  return all > float(0.0) ? float(0.4) + float(0.6) * min(reaches / all, float(1.0)) : float(1.0);
}

// A tangent of the plane with this normal: perpendicular to it and of similar length.
vec3 relievoTangent(vec3 normal)
{
  if (abs(normal.x) > abs(normal.y))
  {
    return vec3(-normal.z, float(0.0), normal.x);
  }
  return vec3(float(0.0), normal.z, -normal.y);
}

// The derivative of a point's map coordinates (u, v, depth) along a direction. `map` is viewToMap *
// (point, 1).
vec3 relievoMapDerivative(mat4 viewToMap, vec4 map, vec3 direction)
{
  vec4 moved = viewToMap * vec4(direction, float(0.0));
  return vec3(moved.x - map.x / map.w * moved.w, moved.y - map.y / map.w * moved.w,
           moved.z - map.z / map.w * moved.w) /
    map.w;
}

// Normal in map space of the plane through the point with this eye-space normal: planes remain
// planes in a perspective map. Of any length and sign.
vec3 relievoMapPlane(mat4 viewToMap, vec4 map, vec3 normalVC)
{
  vec3 tangent = relievoTangent(normalVC);
  return cross(relievoMapDerivative(viewToMap, map, tangent),
    relievoMapDerivative(viewToMap, map, cross(normalVC, tangent)));
}

// Negative if the visible side of a plane faces the light. `place` is a point of the plane, `eye`
// the eye in homogeneous map space, or the direction to it (w = 0).
float relievoMapFacing(vec3 plane, vec3 place, vec4 eye)
{
  return plane.z *
    (plane.x * (eye.x - eye.w * place.x) + plane.y * (eye.y - eye.w * place.y) +
      plane.z * (eye.z - eye.w * place.z));
}

// Slope of a plane in map space: depth per u and per v. `steepest` limits each: a plane at grazing
// incidence has no finite slope.
vec2 relievoReceiverSlope(vec3 plane, float steepest)
{
  return vec2(clamp(-plane.x / plane.z, -steepest, steepest),
    clamp(-plane.y / plane.z, -steepest, steepest));
}

// Weight of tap i of the 2 * radius taps 1 - radius ... radius in one direction; `part` is the
// point's position between taps 0 and 1. The weights of a row add up to 2 * radius - 1.
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
