// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Places in the grids of optical depths towards lights (vtkRelievoOpticalDepths).

// The texel, from 0 to size - 1, of a place that the light's matrix took to `map`, for rays side by
// side or from one point.
vec3 relievoVolumeTexel(vec4 map, vec3 size)
{
  vec3 texel = vec3(map.x / map.w, map.y / map.w, map.z);
  return clamp(texel, vec3(float(0.0)), size - vec3(float(1.0)));
}

// For rays in all directions around the light: by longitude and the angle to the third axis, with a
// texel beyond each border.
vec3 relievoVolumeTexelAround(vec4 map, vec3 size)
{
  vec3 way = vec3(map.x, map.y, map.z);
  float half_turn = float(3.14159265358979);
  vec2 share = vec2(atan(way.y, way.x) / (float(2.0) * half_turn) + float(0.5),
    atan(length(vec2(way.x, way.y)), way.z) / half_turn);
  vec3 texel = vec3(share.x * (size.x - float(2.0)) + float(0.5),
    share.y * (size.y - float(2.0)) + float(0.5), length(way) - map.w);
  return clamp(texel, vec3(float(0.0)), size - vec3(float(1.0)));
}
